// Soups, meshes whose triangles share no vertex, in parts.
#pragma once

#include <cstddef>
#include <span>

#include "renderer/description/scene_description.h"
#include "renderer/geometry/geometry.h"

namespace candela {

// Parts of a soup have the same corners, 0 1 2, 3 4 5 and so on, which are stored once: 12 bytes a
// triangle less, of the 48 that it takes. So many triangles are in each but the last.
inline constexpr std::size_t triangles_of_a_part = 65536;

// 1, unless the mesh is a soup of one material, of more triangles than that, in the vertices'
// order.
[[nodiscard]] std::size_t part_count(const description::Mesh& mesh);

// A copy.
[[nodiscard]] description::Mesh part_of(const description::Mesh& mesh, std::size_t part);

// Geometries from `first` on take the corners of one before them that begins like them, or lend it
// their own.
void share_corners(std::span<Geometry> geometries, std::size_t first);

}  // namespace candela
