// What the properties of a PLY file's vertices are called.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "scene_io/ply/header.h"

namespace candela::ply {

// What a property of a vertex is, for us.
enum Slot : std::size_t { X, Y, Z, NormalX, NormalY, NormalZ, U, V, SlotCount };
inline constexpr std::size_t unused = SlotCount;

inline constexpr std::array<std::pair<std::string_view, Slot>, 6> slot_names{
    {{"x", X}, {"y", Y}, {"z", Z}, {"nx", NormalX}, {"ny", NormalY}, {"nz", NormalZ}}};

// What texture coordinates may be called; the first that there is counts, as in pbrt.
struct UvNames {
  std::string_view u, v;
};
inline constexpr UvNames uv_names[] = {
    {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};

[[nodiscard]] inline UvNames uv_names_of(const Element& element) {
  const auto has = [&](std::string_view name) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& p) { return !p.count_type && p.name == name; });
  };
  for (const UvNames& names : uv_names)
    if (has(names.u) && has(names.v)) return names;
  return {};
}

[[nodiscard]] inline std::size_t slot_of(const Property& property, const UvNames& uv) {
  if (property.count_type) return unused;
  for (const auto& [name, slot] : slot_names)
    if (name == property.name) return slot;
  if (property.name == uv.u) return U;
  return property.name == uv.v ? std::size_t{V} : unused;
}

}  // namespace candela::ply
