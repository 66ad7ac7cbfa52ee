// Closed surfaces for watertightness: every edge belongs to two triangles that share its vertices,
// bit by bit, so that a ray from within that meets nothing fell through a crack.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"
#include "tests/scenes/meshes.h"

namespace candela::test {

// Vertices shared by index, in the space of the back ends: compile() has not moved them.
struct ClosedMesh {
  std::string name;
  Geometry geometry;
  Vec3f inside{0};   // rays start about here, all well within
  float radius = 0;  // of the cube they start from
};

[[nodiscard]] ClosedMesh closed_mesh(const std::string& name, const description::Mesh& mesh,
                                     const Vec3d& inside, double radius);

// The walls of the Cornell box with a wall in front; 12 triangles of slightly odd shape.
[[nodiscard]] ClosedMesh closed_cornell_box();
[[nodiscard]] ClosedMesh icosphere(int subdivisions);
// A turned cube whose sides are cut into strips a millionth as wide as long.
[[nodiscard]] ClosedMesh box_of_slivers();
// The course's bunny, its holes filled by fans; nothing where it is not present.
[[nodiscard]] std::optional<ClosedMesh> closed_bunny();
// Of radius 2 about (148376, 1234, -223423), where Embree's own tests look for cracks.
[[nodiscard]] ClosedMesh far_sphere();

// Edges that do not belong to exactly one triangle in each direction: 0 for a closed surface.
[[nodiscard]] std::size_t open_edges(const Geometry& geometry);

[[nodiscard]] Scene scene_of(const ClosedMesh& mesh);

}  // namespace candela::test
