#include "renderer/accel/few_faces.h"

#include <algorithm>
#include <functional>

namespace candela {
namespace {

// Other than of objects without a surface.
bool has_instances(const Scene& scene) {
  return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
    return std::ranges::any_of(scene.objects[instance.object.index].geometries,
                               [&](GeometryHandle handle) {
                                 const Geometry& geometry = scene.geometries[handle.index];
                                 return !geometry.triangles.empty() || !geometry.spheres.empty();
                               });
  });
}

bool may_be_listed(const Geometry& geometry) {
  return geometry.spheres.empty() && !geometry.has_cutouts;
}

// Of a triangle.
double mean_area(const Geometry& geometry) {
  double sum = 0;
  for (const auto& [a, b, c] : geometry.triangles) {
    const Vec3d corner(geometry.positions[a]);
    sum += length(cross(Vec3d(geometry.positions[b]) - corner,
                        Vec3d(geometry.positions[c]) - corner)) /
           2;
  }
  return geometry.triangles.empty() ? 0 : sum / static_cast<double>(geometry.triangles.size());
}

// Those of the rest, where they and the faces are few enough for a list.
void list_spheres(const Scene& scene, FewFaces& few) {
  const auto is_listed = [&](GeometryHandle handle) {
    const Geometry& geometry = scene.geometries[handle.index];
    return !geometry.spheres.empty() && !geometry.has_cutouts;
  };
  const auto others = std::stable_partition(few.rest.begin(), few.rest.end(), is_listed);
  const SphereList spheres(scene, {few.rest.begin(), others});
  if (spheres.is_empty() || few.faces.size() + spheres.size() > FaceList::most_faces) return;
  few.spheres = spheres;
  few.rest.erase(few.rest.begin(), others);
}

}  // namespace

FewFaces find_few_faces(const Scene& scene) {
  constexpr std::size_t most_listed = 2 * FaceList::most_faces;
  constexpr std::size_t most_dense = 1 << 17;  // a second tree of so many takes little memory
  std::vector<GeometryHandle> all = scene.world.geometries;
  const auto size_of = [&](GeometryHandle handle) {
    const Geometry& geometry = scene.geometries[handle.index];
    return geometry.triangles.size() + geometry.spheres.size();
  };
  std::size_t size = 0;
  for (const GeometryHandle handle : all) size += size_of(handle);
  if (size > most_listed + most_dense || has_instances(scene)) return {};
  std::ranges::stable_sort(all, std::greater(), [&](GeometryHandle handle) {
    return mean_area(scene.geometries[handle.index]);
  });
  std::vector<GeometryHandle> listed;
  std::size_t triangles = 0;
  std::size_t dense = 0;
  FewFaces few;
  for (const GeometryHandle handle : all) {
    if (may_be_listed(scene.geometries[handle.index]) &&
        triangles + size_of(handle) <= most_listed) {
      triangles += size_of(handle);
      listed.push_back(handle);
    } else {
      dense += size_of(handle);
      few.rest.push_back(handle);
    }
  }
  few.faces = FaceList(scene, listed);
  if (few.faces.is_empty() || dense > most_dense) return {};
  list_spheres(scene, few);
  few.boxes = BoxList(scene, few.rest);
  return few;
}

}  // namespace candela
