#include "renderer/description/world_bounds.h"

#include <vector>

namespace candela::description {
namespace {

Bounds3d bounds_of(const Mesh& mesh) {
  Bounds3d bounds;
  for (const Vec3d& position : mesh.positions) bounds.include(position);
  if (mesh.sphere) {
    bounds.include(Vec3d(-mesh.sphere->radius));
    bounds.include(Vec3d(mesh.sphere->radius));
  }
  return bounds;
}

// The corners' bounds: at most a little wider than those of the vertices.
Bounds3d transformed(const Bounds3d& box, const Transform& transform) {
  Bounds3d bounds;
  for (int corner = 0; corner < 8; ++corner) bounds.include(transform.point(box.corner(corner)));
  return bounds;
}

}  // namespace

Bounds3d world_bounds(const SceneDescription& scene) {
  std::vector<Bounds3d> of_mesh;
  for (const Mesh& mesh : scene.meshes) of_mesh.push_back(bounds_of(mesh));
  Bounds3d bounds;
  for (const Instance& instance : scene.instances) {
    if (instance.mesh.index >= of_mesh.size()) continue;
    const Bounds3d& own = of_mesh[instance.mesh.index];
    if (!own.is_empty()) bounds.include(transformed(own, instance.object_to_world));
  }
  for (const Light& light : scene.lights)
    if (const auto* triangle = std::get_if<TriangleLight>(&light.kind))
      for (const Vec3d& vertex : triangle->vertices) bounds.include(vertex);
  return bounds;
}

}  // namespace candela::description
