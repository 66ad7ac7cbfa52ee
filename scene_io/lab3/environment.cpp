#include "scene_io/lab3/environment.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/math/constants.h"
#include "scene_io/image_encoding.h"
#include "scene_io/lab3/assets.h"

namespace candela::lab3 {
namespace {

using description::ConstantEnvironment;
using description::CubeEnvironment;
using description::Encoding;
using description::LatLongEnvironment;
using description::Wrap;

constexpr std::string_view keys[] = {"Map", "Scale", "Rotation", "Radiance", "VisibleToCamera"};

// About +y, by the right hand.
Mat3d rotation_about_y(double degrees) {
  const double angle = degrees * (pi_double / 180);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return Mat3d(c, 0, -s, 0, 1, 0, s, 0, c);
}

void read_map(Reader& reader, const Fields& fields, const Vec3d& scale, bool is_seen) {
  const Entry& map = *fields.find("Map");
  LatLongEnvironment environment;
  environment.image =
      read_required_image(reader, map, encoding_of_colours(map.value->text), Wrap::Repeat);
  environment.scale = scale;
  environment.is_seen_by_camera = is_seen;
  environment.world_from_map = rotation_about_y(fields.number("Rotation", any_number).value_or(0));
  reader.scene.lights.push_back({reader.span(fields.offset()), environment});
}

void read_constant(Reader& reader, const Fields& fields, const Vec3d& scale, bool is_seen) {
  const Vec3d radiance = fields.colour("Radiance", not_negative).value_or(Vec3d(1.0));
  if (const Entry* rotation = fields.find("Rotation"))
    reader.warning(rotation->key_offset, "Rotation has no effect on a constant Radiance");
  reader.scene.lights.push_back(
      {reader.span(fields.offset()), ConstantEnvironment{radiance * scale, is_seen}});
}

void note_default_ambient(Reader& reader) {
  if (reader.has_ambient || reader.is_extended || reader.has_environment || reader.options.ambient)
    return;
  reader.note("AmbientIntensity is not given: [0.1, 0.1, 0.1], as in lab3");
}

}  // namespace

void read_skyboxes(Reader& reader, const Fields& root) {
  const Entry* entry = root.find("Skyboxes");
  if (!entry || entry->value->is_null()) return;
  const Node& list = *entry->value;
  const bool has_lists =
      list.is_sequence() && (list.entries.empty() || list.entries[0].value->is_sequence());
  if (!has_lists) {
    reader.error(list.offset, fmt::format("Skyboxes: found {}, expected a list of lists of 6 image "
                                          "files (+X, -X, +Y, -Y, +Z, -Z)",
                                          describe(list)));
    return;
  }
  if (list.entries.empty()) return;
  const Node& faces = *list.entries[0].value;
  if (faces.entries.size() != 6) {
    reader.error(faces.offset, fmt::format("a skybox: found {}, expected 6 image files (+X, -X, "
                                           "+Y, -Y, +Z, -Z)",
                                           describe(faces)));
    return;
  }
  if (list.entries.size() > 1)
    reader.warning(list.entries[1].value->offset, "only the first skybox is used");
  CubeEnvironment environment;
  for (std::size_t i = 0; i < 6; ++i)
    environment.faces[i] =
        read_required_image(reader, faces.entries[i], Encoding::LabGamma, Wrap::Clamp);
  reader.scene.lights.push_back({reader.span(faces.offset), environment});
  reader.has_environment = true;
}

void read_environment(Reader& reader, const Fields& root) {
  const Entry* entry = root.find("Environment");
  if (!entry) return;
  reader.is_extended = true;
  const Fields fields(reader, *entry->value, "an Environment", keys);
  if (!entry->value->is_map()) return;
  const Vec3d scale = fields.colour("Scale", not_negative).value_or(Vec3d(1.0));
  const bool is_seen = fields.flag("VisibleToCamera", true);
  if (reader.has_environment) {
    reader.error(entry->key_offset,
                 "both Skyboxes and Environment are given, expected one of them");
    return;
  }
  reader.has_environment = true;
  if (fields.has("Map") == fields.has("Radiance")) {
    reader.error(entry->key_offset, fields.has("Map")
                                        ? "both Map and Radiance are given, expected one of them"
                                        : "an Environment needs a Map or a Radiance");
    return;
  }
  if (fields.has("Map"))
    read_map(reader, fields, scale, is_seen);
  else
    read_constant(reader, fields, scale, is_seen);
}

void read_ambient(Reader& reader, const Fields& root) {
  const auto given = root.vector("AmbientIntensity", not_negative);
  reader.has_ambient = root.has("AmbientIntensity");
  note_default_ambient(reader);
  std::optional<Vec3d>& ambient = reader.scene.lab_ambient;
  if (!reader.is_extended) ambient = Vec3d(0.1);
  if (given) ambient = given;
  if (reader.options.ambient) ambient = reader.options.ambient;
  if (reader.has_environment) {
    if (reader.options.ambient)
      reader.note("--ambient counts for whitted and raster only: the scene has an environment");
    return;
  }
  if (ambient && *ambient != Vec3d(0.0))
    reader.scene.lights.push_back({{}, ConstantEnvironment{*ambient, false}});
}

}  // namespace candela::lab3
