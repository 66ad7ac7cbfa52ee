#include "scene_io/lab3/lights.h"

#include <array>

#include <fmt/format.h>

#include "renderer/math/constants.h"
#include "scene_io/lab3/direction.h"

namespace candela::lab3 {
namespace {

constexpr std::string_view keys[] = {
    "Type", "Intensity", "Direction", "Position",    "Position2", "Position3", "p0",
    "p1",   "p2",        "CutOff",    "OuterCutOff", "TwoSided",  "Length"};
constexpr std::string_view kinds[] = {"Point", "Spot", "Directional", "Area"};
enum class Kind : std::uint8_t { Point, Spot, Directional, Area };

constexpr Range half_angle{0, 180, false, false, "a half angle in degrees from 0 to 180"};
constexpr double radians_per_degree = pi_double / 180;

Vec3d read_intensity(const Fields& fields) {
  return fields.vector("Intensity", not_negative).value_or(Vec3d(1.0));
}

// Unit; nothing where it is absent or wrong.
std::optional<Vec3d> read_direction(Reader& reader, const Fields& fields) {
  const auto direction = fields.vector("Direction", any_number);
  if (!direction) return std::nullopt;
  if (*direction == Vec3d(0.0)) {
    reader.error(fields.find("Direction")->value->offset,
                 "Direction: found [0, 0, 0], expected a direction");
    return std::nullopt;
  }
  return unit(*direction);
}

Vec3d read_direction_or_default(Reader& reader, const Fields& fields) {
  return read_direction(reader, fields).value_or(Vec3d(1, 0, 0));
}

description::PointLight read_point(const Fields& fields) {
  return {fields.vector("Position", any_number).value_or(Vec3d(0.0)),
          pi_double * read_intensity(fields)};
}

description::DirectionalLight read_directional(Reader& reader, const Fields& fields) {
  return {read_direction_or_default(reader, fields), pi_double * read_intensity(fields)};
}

// CutOff and OuterCutOff are half angles in degrees. `Direction` points from the surface to the
// light, as everywhere in lab3, so the axis of the cone is against it.
description::SpotLight read_spot(Reader& reader, const Fields& fields) {
  description::SpotLight light;
  light.position = fields.vector("Position", any_number).value_or(Vec3d(0.0));
  light.axis = -read_direction_or_default(reader, fields);
  light.intensity = pi_double * read_intensity(fields);
  const auto inner = fields.number("CutOff", half_angle);
  const auto outer = fields.number("OuterCutOff", half_angle);
  if (!fields.has("CutOff") && !fields.has("OuterCutOff"))
    reader.error(fields.offset(),
                 "a Spot light needs CutOff or OuterCutOff, the half angle of its cone in degrees");
  double inner_degrees = inner.value_or(outer.value_or(0));
  double outer_degrees = outer.value_or(inner_degrees);
  if (outer_degrees < inner_degrees) {
    reader.warning(fields.find("OuterCutOff")->value->offset,
                   fmt::format("OuterCutOff {} lies within CutOff {}: both are taken as {}",
                               outer_degrees, inner_degrees, inner_degrees));
    outer_degrees = inner_degrees;
  }
  if (fields.has("Length"))
    reader.warning(fields.find("Length")->key_offset,
                   "Length is not used: a Spot light is a point");
  light.inner_angle_radians = inner_degrees * radians_per_degree;
  light.outer_angle_radians = outer_degrees * radians_per_degree;
  return light;
}

// p0 p1 p2, or Position Position2 Position3.
std::optional<std::array<Vec3d, 3>> read_triangle(Reader& reader, const Fields& fields) {
  static constexpr std::string_view short_names[] = {"p0", "p1", "p2"};
  static constexpr std::string_view long_names[] = {"Position", "Position2", "Position3"};
  const bool is_short = fields.has_any(short_names);
  if (is_short && fields.has_any(long_names))
    reader.warning(
        fields.offset(),
        "both p0, p1, p2 and Position, Position2, Position3 are given: p0, p1, p2 count");
  if (!is_short && !fields.has_any(long_names)) {
    reader.error(fields.offset(), "an Area light needs p0, p1 and p2, the corners of its triangle");
    return std::nullopt;
  }
  std::array<Vec3d, 3> vertices{};
  bool is_complete = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view name = is_short ? short_names[i] : long_names[i];
    const auto vertex = fields.vector(name, any_number);
    if (!fields.has(name))
      reader.error(fields.offset(),
                   fmt::format("an Area light needs {}, a corner of its triangle", name));
    is_complete = is_complete && vertex;
    vertices[i] = vertex.value_or(Vec3d(0.0));
  }
  if (!is_complete) return std::nullopt;
  return vertices;
}

bool has_no_area(const std::array<Vec3d, 3>& vertices) {
  const Vec3d edge1 = vertices[1] - vertices[0];
  const Vec3d edge2 = vertices[2] - vertices[0];
  return edge1 == Vec3d(0.0) || edge2 == Vec3d(0.0) || are_parallel(edge1, edge2);
}

// Direction, where given, chooses the side: it points away from the light, and the winding follows.
void turn_towards_direction(Reader& reader, const Fields& fields,
                            description::TriangleLight& light) {
  const auto direction = read_direction(reader, fields);
  if (!direction) return;
  const auto& [a, b, c] = light.vertices;
  const double along = dot(*direction, cross(unit(b - a), unit(c - a)));
  if (along == 0)
    reader.warning(fields.find("Direction")->value->offset,
                   "Direction lies in the light's plane and chooses no side: the light shines to "
                   "the side of (p1 - p0) x (p2 - p0)");
  if (along < 0) std::swap(light.vertices[1], light.vertices[2]);
}

std::optional<description::TriangleLight> read_area(Reader& reader, const Fields& fields) {
  description::TriangleLight light;
  light.radiance = read_intensity(fields);
  light.emits_both_sides = fields.flag("TwoSided", false);
  const auto vertices = read_triangle(reader, fields);
  if (!vertices) return std::nullopt;
  light.vertices = *vertices;
  if (has_no_area(light.vertices)) {
    reader.error(fields.offset(), "the corners of this Area light lie on a line: its area is 0");
    return std::nullopt;
  }
  turn_towards_direction(reader, fields, light);
  return light;
}

void warn_of_keys_without_meaning(Reader& reader, const Fields& fields, Kind kind) {
  const auto warn = [&](std::string_view key) {
    if (const Entry* entry = fields.find(key))
      reader.warning(entry->key_offset, fmt::format("{} has no meaning for {} {} light", key,
                                                    kind == Kind::Area ? "an" : "a",
                                                    kinds[static_cast<std::size_t>(kind)]));
  };
  for (const std::string_view key : {"Position2", "Position3", "p0", "p1", "p2", "TwoSided"})
    if (kind != Kind::Area) warn(key);
  for (const std::string_view key : {"CutOff", "OuterCutOff", "Length"})
    if (kind != Kind::Spot) warn(key);
}

void read_light(Reader& reader, const Node& node) {
  const Fields fields(reader, node, "a light", keys);
  if (!node.is_map()) return;
  const auto chosen = fields.choice("Type", kinds);
  if (fields.has("Type") && !chosen) return;
  const Kind kind = static_cast<Kind>(chosen.value_or(0));
  warn_of_keys_without_meaning(reader, fields, kind);
  description::Light light{reader.span(node.offset), description::PointLight{}};
  switch (kind) {
    case Kind::Point:
      light.kind = read_point(fields);
      break;
    case Kind::Spot:
      light.kind = read_spot(reader, fields);
      break;
    case Kind::Directional:
      light.kind = read_directional(reader, fields);
      break;
    case Kind::Area: {
      const auto area = read_area(reader, fields);
      if (!area) return;
      light.kind = *area;
      break;
    }
  }
  reader.scene.lights.push_back(light);
}

}  // namespace

void read_lights(Reader& reader, const Fields& root) {
  for_each_entry(reader, root, "Lights", [&](const Node& node) { read_light(reader, node); });
}

}  // namespace candela::lab3
