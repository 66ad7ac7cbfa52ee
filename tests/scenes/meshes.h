// Meshes built in code, for tests: description::Mesh in double, counter-clockwise from outside, one
// material for all triangles (set by add_mesh of description.h beside this file).
#pragma once

#include "renderer/description/scene_description.h"

namespace candela::test {

// Three corners, no normals, no uvs.
[[nodiscard]] description::Mesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

// corner, corner + edge1, corner + edge1 + edge2, corner + edge2. Its normal is edge1 x edge2; uv
// (0,0) at the corner, (1,0) at the end of edge1.
[[nodiscard]] description::Mesh quad(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2);

// Twelve triangles, outward.
[[nodiscard]] description::Mesh box(const Vec3d& lower, const Vec3d& upper);

// An icosahedron split `subdivisions` times (20 * 4^subdivisions triangles), outward; smooth vertex
// normals where asked for. No uvs.
[[nodiscard]] description::Mesh sphere(const Vec3d& centre, double radius, int subdivisions,
                                       bool has_normals = true);

// The same surface facing the other way.
[[nodiscard]] description::Mesh inside_out(description::Mesh mesh);

// Appends b's triangles to a. Both have normals (uvs), or the result has none.
[[nodiscard]] description::Mesh merged(description::Mesh a, const description::Mesh& b);

}  // namespace candela::test
