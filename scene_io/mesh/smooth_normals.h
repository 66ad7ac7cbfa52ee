// Normals for a mesh whose file has none.
#pragma once

#include "renderer/description/scene_description.h"

namespace candela::mesh {

// Unit normals: for each vertex the sum of the cross products of its triangles (twice their areas),
// as lab3 does; zero where that sum is zero or no triangle uses the vertex. Under a linear map of
// the mesh they transform by its cofactor matrix, so computing them before or after is the same.
void compute_smooth_normals(description::Mesh& mesh);

// False where there is nothing to smooth: the normals would be the triangles' own.
[[nodiscard]] bool shares_vertices(const description::Mesh& mesh);

}  // namespace candela::mesh
