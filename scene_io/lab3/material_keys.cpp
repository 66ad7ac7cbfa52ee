#include "scene_io/lab3/material_keys.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene_io/text/source.h"

namespace candela::lab3 {
namespace {

using Keys = std::vector<std::string_view>;

constexpr std::string_view common_keys[] = {"Name",        "Type",     "Blend",      "Emission",
                                            "EmissionMap", "TwoSided", "opacity",    "opacity_map",
                                            "HeightMap",   "bump_map", "bump_scale", "normal_map"};
constexpr std::string_view lab_keys[] = {
    "Diffuse",  "Albedo",    "BaseColor",  "DiffuseMap", "AlbedoMap",   "BaseColorMap", "Specular",
    "Metallic", "Shininess", "Glossiness", "Smoothness", "SpecularMap", "MetallicMap"};
constexpr std::string_view roughness_keys[] = {"roughness", "roughness_map"};
constexpr std::string_view fresnel_keys[] = {"fresnel", "geometry", "ior", "eta",
                                             "k",       "metal",    "F0",  "energy_compensation"};
constexpr std::string_view conductor_keys[] = {"eta", "k", "metal", "F0", "energy_compensation"};
constexpr std::string_view dielectric_keys[] = {"ior", "transmittance"};

Keys joined(std::initializer_list<Names> parts) {
  Keys all;
  for (const Names part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Keys keys_of(MaterialType type) {
  switch (type) {
    case MaterialType::Lab:
      return joined({common_keys, lab_keys});
    case MaterialType::CookTorrance:
      return joined({common_keys, kd_names, kd_map_names, ks_names, ks_map_names, roughness_keys,
                     fresnel_keys});
    case MaterialType::Diffuse:
    case MaterialType::Mirror:
      return joined({common_keys, reflectance_names, reflectance_map_names});
    case MaterialType::Conductor:
      return joined({common_keys, roughness_keys, conductor_keys});
    case MaterialType::Dielectric:
      return joined({common_keys, roughness_keys, dielectric_keys});
    case MaterialType::ThinDielectric:
      return joined({common_keys, dielectric_keys});
  }
  return {};
}

constexpr std::size_t type_count = std::size(material_type_words) + 1;

const std::array<Keys, type_count>& all_keys() {
  static const std::array<Keys, type_count> table = [] {
    std::array<Keys, type_count> made;
    for (std::size_t i = 0; i < type_count; ++i) made[i] = keys_of(static_cast<MaterialType>(i));
    return made;
  }();
  return table;
}

bool knows(const Keys& keys, std::string_view key) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](std::string_view known) { return is_same_name(known, key); });
}

}  // namespace

Names material_keys(MaterialType type) {
  return all_keys()[static_cast<std::size_t>(type)];
}

Names all_material_keys() {
  static const Keys keys = [] {
    Keys all;
    for (const Keys& some : all_keys()) all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return keys;
}

std::string hint_of_material_key(MaterialType type, std::string_view key) {
  const auto& table = all_keys();
  std::string owners;
  for (std::size_t i = 1; i < type_count; ++i)
    if (knows(table[i], key))
      owners += fmt::format("{}{}", owners.empty() ? "" : ", ", material_type_words[i - 1]);
  if (type == MaterialType::Lab && !owners.empty())
    return fmt::format("key {} belongs to materials with a Type ({}); this one has none",
                       text::quoted(key), owners);
  const std::string_view word = type == MaterialType::Lab
                                    ? std::string_view()
                                    : material_type_words[static_cast<std::size_t>(type) - 1];
  if (!owners.empty())
    return fmt::format("key {} has no meaning for Type: {} (it has for {})", text::quoted(key),
                       word, owners);
  if (knows(table[0], key))
    return fmt::format("key {} belongs to materials without a Type; this one is Type: {}",
                       text::quoted(key), word);
  return "";
}

}  // namespace candela::lab3
