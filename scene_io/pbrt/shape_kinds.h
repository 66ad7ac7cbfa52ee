// One function a shape: its parameters -> a mesh, not oriented yet.
#pragma once

#include <functional>
#include <optional>

#include "renderer/description/scene_description.h"
#include "scene_io/pbrt/arguments.h"
#include "scene_io/pbrt/shape.h"

namespace candela::pbrt {

using MaybeMesh = std::optional<ShapeMesh>;

[[nodiscard]] MaybeMesh triangle_mesh(Arguments& arguments);
[[nodiscard]] MaybeMesh ply_mesh(Arguments& arguments, const ShapeOptions& options);
[[nodiscard]] MaybeMesh sphere(Arguments& arguments, const ShapeOptions& options);
[[nodiscard]] MaybeMesh disk(Arguments& arguments, const ShapeOptions& options);
[[nodiscard]] MaybeMesh cylinder(Arguments& arguments, const ShapeOptions& options);
[[nodiscard]] MaybeMesh bilinear_mesh(Arguments& arguments, const ShapeOptions& options);
[[nodiscard]] MaybeMesh loop_subdivision(Arguments& arguments);

// A mesh each of whose triangles is a shape of pbrt's.
[[nodiscard]] ShapeMesh of_triangles(description::Mesh mesh);

struct SurfaceSample {
  Vec3d position{0.0};
  Vec3d normal{0.0};
};

// Appends a grid of columns x rows cells over u, v in [0, 1], oriented along dp/du x dp/dv.
// Triangles that have two corners at one place are left out.
void append_grid(std::uint32_t columns, std::uint32_t rows,
                 const std::function<SurfaceSample(double u, double v)>& surface,
                 const std::function<Vec2d(double u, double v)>& uv, description::Mesh& mesh);

// Vertices and indices of "P", "indices", "N" and "uv" with all checks. `corners` is that of a
// face: 3, or 4 for patches.
struct IndexedFaces {
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;
  std::vector<Vec2d> uvs;
  std::vector<std::uint32_t> indices;
};
[[nodiscard]] std::optional<IndexedFaces> indexed_faces(Arguments& arguments, std::size_t corners);

}  // namespace candela::pbrt
