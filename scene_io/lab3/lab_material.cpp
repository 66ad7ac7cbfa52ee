#include "scene_io/lab3/lab_material.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene_io/lab3/assets.h"

namespace candela::lab3 {
namespace {

using description::Encoding;
using description::Wrap;

// In lab3's order: a later one overrides.
constexpr std::string_view diffuse_names[] = {"Diffuse", "Albedo", "BaseColor"};
constexpr std::string_view diffuse_map_names[] = {"DiffuseMap", "AlbedoMap", "BaseColorMap"};
constexpr std::string_view specular_names[] = {"Specular", "Metallic"};
constexpr std::string_view specular_map_names[] = {"SpecularMap", "MetallicMap"};
constexpr std::string_view shininess_names[] = {"Shininess", "Glossiness", "Smoothness"};

constexpr double largest_shininess = 256;

// lab3 stores everything as n/255 of this.
double clamped(Reader& reader, std::size_t offset, std::string_view name, double value,
               double most) {
  if (value >= 0 && value <= most) return value;
  reader.warning(offset, fmt::format("{}: {} is taken as {}: lab3 stores 0 to {} only", name, value,
                                     value < 0 ? 0 : most, most));
  return std::clamp(value, 0.0, most);
}

// Three or four numbers; what is missing is 1, silently only for the fourth.
std::optional<Vec4d> read_vector4(Reader& reader, const Entry& entry, double most_of_fourth) {
  const auto numbers = read_numbers(reader, *entry.value, entry.key, Count{3, 4}, any_number);
  if (!numbers) return std::nullopt;
  if (numbers->size() < 3)
    reader.warning(entry.value->offset,
                   fmt::format("{}: found {}, expected 3 or 4 numbers; lab3 takes 1 for what is "
                               "missing",
                               entry.key, describe(*entry.value)));
  Vec4d vector{1.0};
  for (std::size_t i = 0; i < numbers->size(); ++i)
    vector[static_cast<int>(i)] = clamped(reader, entry.value->entries[i].value->offset, entry.key,
                                          (*numbers)[i], i == 3 ? most_of_fourth : 1);
  return vector;
}

void warn_of_replaced_factors(Reader& reader, const Fields& fields, const Entry& map,
                              Names factors) {
  for (const std::string_view name : factors)
    if (const Entry* factor = fields.find(name))
      reader.warning(factor->key_offset,
                     fmt::format("{} is not used: {} replaces it (lab3 does not multiply them)",
                                 factor->key, map.key));
}

void read_diffuse(Reader& reader, const Fields& fields, description::LabMaterial& material) {
  if (const Entry* entry = fields.last_of(diffuse_names)) {
    const Vec4d rgba = read_vector4(reader, *entry, 1).value_or(Vec4d(1.0));
    material.diffuse.factor = Vec3d(rgba);
    material.alpha = rgba.w;
  }
  const Entry* map = fields.last_of(diffuse_map_names);
  material.diffuse.map = read_image(reader, map, Encoding::LabGamma, Wrap::Repeat);
  if (material.diffuse.map) warn_of_replaced_factors(reader, fields, *map, diffuse_names);
}

void read_specular(Reader& reader, const Fields& fields, description::LabMaterial& material) {
  if (const Entry* entry = fields.last_of(specular_names)) {
    const Vec4d rgbn = read_vector4(reader, *entry, largest_shininess).value_or(Vec4d(0.0));
    material.specular.factor = Vec3d(rgbn);
    material.shininess = rgbn.w;
  }
  if (const Entry* entry = fields.last_of(shininess_names)) {
    const auto shininess = read_number(reader, *entry->value, entry->key, any_number);
    if (shininess)
      material.shininess =
          clamped(reader, entry->value->offset, entry->key, *shininess, largest_shininess);
  }
  const Entry* map = fields.last_of(specular_map_names);
  material.specular.map = read_image(reader, map, Encoding::Linear, Wrap::Repeat);
  if (!material.specular.map) return;
  warn_of_replaced_factors(reader, fields, *map, specular_names);
  warn_of_replaced_factors(reader, fields, *map, shininess_names);
}

}  // namespace

description::LabMaterial read_lab_material(Reader& reader, const Fields& fields) {
  description::LabMaterial material;
  read_diffuse(reader, fields, material);
  read_specular(reader, fields, material);
  return material;
}

}  // namespace candela::lab3
