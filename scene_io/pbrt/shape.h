// Shapes -> meshes in the shape's own space; whole spheres stay what they are, where they are not
// stretched.
//
// Triangles are oriented as pbrt orients surfaces: along the vertex normals where there are some,
// else by the winding (dp/du x dp/dv of curved shapes), and turned by ReverseOrientation. Curved
// shapes become meshes with the exact normals and texture coordinates, enlarged so that the mesh
// has the area of the shape: a convex body's mean projected area is a quarter of it [Cauchy1850].
#pragma once

#include <optional>
#include <string>

#include "renderer/description/scene_description.h"
#include "scene_io/pbrt/program.h"

namespace candela::pbrt {

inline constexpr std::uint32_t finest_segments = 128;

// Of a full circle, in a scene with so many curved shapes and patches: they take 8 million
// triangles at most, or 144 each and a patch 2.
[[nodiscard]] std::uint32_t segments_for(std::size_t curved_shapes, std::size_t curved_patches);
// Along each edge of a patch that two triangles do not make.
[[nodiscard]] std::uint32_t patch_cells_for(std::uint32_t segments);
// How many such patches it has, as far as can be seen without reading its parameters.
[[nodiscard]] std::size_t curved_patch_count(const ShapeStatement& shape, bool needs_uvs);
// Whether what it wears or emits looks at texture coordinates, as far as can be seen likewise.
[[nodiscard]] bool has_texture(const Program& program, const ShapeStatement& shape);
[[nodiscard]] bool is_curved(const ShapeStatement& shape);
// Spheres of which nothing is cut off, as far as can be seen without reading their parameters.
[[nodiscard]] bool is_whole_sphere(const ShapeStatement& shape);

struct ShapeOptions {
  const std::string& scene_path;
  bool needs_uvs = false;                    // the material is textured: meshes without get pbrt's
  std::uint32_t segments = finest_segments;  // of a full circle: see segments_for()
  bool keeps_spheres = false;  // whole ones stay spheres: they are placed by similarities only
};

// `count`: how many shapes pbrt makes of it, each with the whole power of its light: a mesh's
// triangles or patches; spheres, disks and cylinders are one.
struct ShapeMesh {
  description::Mesh mesh;
  std::size_t count = 1;
};

// What tells one mesh from another: shapes with equal keys have equal meshes. Empty: it is alone.
[[nodiscard]] std::string mesh_key(const ShapeStatement& shape, const ShapeOptions& options);

// No value: it is in error or, with a warning, no shape that candela has. `materials` is left
// empty. Touches nothing but the shape, so several may be made in parallel.
[[nodiscard]] std::optional<ShapeMesh> make_mesh(ShapeStatement& shape, const ShapeOptions& options,
                                                 const Report& report);

// Reverses triangles that lie against their normals, and all with is_reversed.
void orient(description::Mesh& mesh, bool is_reversed);
// pbrt's for triangles without: (0, 0), (1, 0), (1, 1). Vertices are no longer shared.
void add_default_uvs(description::Mesh& mesh);

}  // namespace candela::pbrt
