// How large a mesh is in the world and in its texture coordinates: pbrt's heights are lengths in
// the world, those of other scenes are in edges of the uv square on the surface.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/description/scene_description.h"

namespace candela::pbrt {

struct Areas {
  double surface = 0, uv = 0;
  std::size_t triangle_count = 0;
};

// A sphere counts as one triangle: pbrt's `power` is that of a light each.
// Of the triangles that are listed by their places in the mesh.
[[nodiscard]] Areas areas_of(const description::Mesh& mesh,
                             std::span<const std::uint32_t> triangles,
                             const Transform& world_from_object);
[[nodiscard]] Areas areas_of(const description::Mesh& mesh, const Transform& world_from_object);

// Whether each of `count` parts, of as many triangles that follow each other, has the same area, up
// to rounding.
[[nodiscard]] bool has_equal_parts(const description::Mesh& mesh, std::size_t count,
                                   const Transform& world_from_object);

// candela's height_scale of a length of 1 in the world; 1 where the mesh has no area.
[[nodiscard]] double height_scale(const Areas& areas);

}  // namespace candela::pbrt
