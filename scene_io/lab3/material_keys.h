// Which keys a material may have, by its Type.
#pragma once

#include <string>
#include <string_view>

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

enum class MaterialType : std::uint8_t {
  Lab,  // no Type
  CookTorrance,
  Diffuse,
  Mirror,
  Conductor,
  Dielectric,
  ThinDielectric,
};

// As the file writes them, without Lab: index + 1 is the enumerator.
inline constexpr std::string_view material_type_words[] = {
    "cook_torrance", "diffuse", "mirror", "conductor", "dielectric", "thin_dielectric"};

inline constexpr std::string_view kd_names[] = {"kd", "Diffuse", "Albedo", "BaseColor"};
inline constexpr std::string_view kd_map_names[] = {"kd_map", "DiffuseMap", "AlbedoMap",
                                                    "BaseColorMap"};
inline constexpr std::string_view ks_names[] = {"ks", "Specular"};
inline constexpr std::string_view ks_map_names[] = {"ks_map", "SpecularMap"};
inline constexpr std::string_view reflectance_names[] = {"kd", "Diffuse", "Albedo", "BaseColor",
                                                         "Reflectance"};
inline constexpr std::string_view reflectance_map_names[] = {"kd_map", "DiffuseMap", "AlbedoMap",
                                                             "BaseColorMap", "reflectance_map"};
inline constexpr std::string_view height_map_names[] = {"HeightMap", "bump_map"};

[[nodiscard]] Names material_keys(MaterialType type);
// Of all Types, and of none: some are there several times.
[[nodiscard]] Names all_material_keys();

// That 'roughness' belongs to materials of some Types, or "" for what no material knows.
[[nodiscard]] std::string hint_of_material_key(MaterialType type, std::string_view key);

}  // namespace candela::lab3
