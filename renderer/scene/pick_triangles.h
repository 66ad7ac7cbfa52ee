// From the triangles of a mesh as it is described to a geometry's own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/geometry/geometry.h"
#include "renderer/math/transform.h"

namespace candela {

// The arrays of one mesh in normalised space, from which its geometries pick. Normals are of unit
// length or zero, whatever the file has; uvs are for the caller to set.
struct MeshArrays {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;
};
[[nodiscard]] MeshArrays normalised_arrays(const description::Mesh& mesh,
                                           const Transform& to_normalised);

// A geometry of the given triangles of the mesh with just the vertices they use, which are marked
// in `is_kept`. Where those are all of the mesh it may take the arrays away.
[[nodiscard]] Geometry picked(const description::Mesh& mesh, MeshArrays& arrays,
                              std::span<const std::uint32_t> triangles, std::uint32_t material,
                              bool is_mirrored, std::vector<bool>& is_kept);

}  // namespace candela
