#include "renderer/description/lamp_surfaces.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

namespace candela::description {
namespace {

// Only triangle lights of one kind may be parts of one lamp.
using SurfaceKind = std::tuple<double, double, double, bool>;

SurfaceKind kind_of(const TriangleLight& light) {
  return {light.radiance.x, light.radiance.y, light.radiance.z, light.emits_both_sides};
}

Material black_emitter(const TriangleLight& light, const SourceSpan& span) {
  Material material;
  material.name = "area light";
  material.span = span;
  material.model = DiffuseMaterial{{Vec3d(0.0), {}}};
  material.emission = light.radiance;
  material.emits_both_sides = light.emits_both_sides;
  return material;
}

std::vector<const Light*> triangle_lights(const SceneDescription& description) {
  std::vector<const Light*> lights;
  for (const Light& light : description.lights)
    if (is_triangle_light(light)) lights.push_back(&light);
  return lights;
}

std::size_t root_of(std::vector<std::size_t>& parents, std::size_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

// Triangles of a kind that share corners, over others too, are one lamp: of each light the first
// one of its lamp.
std::vector<std::size_t> lamps_of(const std::vector<const Light*>& lights) {
  std::vector<std::size_t> parents(lights.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  std::map<std::tuple<SurfaceKind, double, double, double>, std::size_t> corners;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& triangle = std::get<TriangleLight>(lights[i]->kind);
    for (const Vec3d& p : triangle.vertices) {
      const auto at = corners.try_emplace({kind_of(triangle), p.x, p.y, p.z}, i).first;
      const std::size_t other = root_of(parents, at->second);
      const std::size_t own = root_of(parents, i);
      parents[std::max(own, other)] = std::min(own, other);
    }
  }
  for (std::size_t& parent : parents) parent = root_of(parents, parent);
  return parents;
}

}  // namespace

bool is_triangle_light(const Light& light) {
  return std::holds_alternative<TriangleLight>(light.kind);
}

void add_lamp_surfaces(SceneDescription& description) {
  const std::vector<const Light*> lights = triangle_lights(description);
  const std::vector<std::size_t> lamps = lamps_of(lights);
  std::map<std::size_t, std::size_t> meshes;  // of the lamps
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& triangle = std::get<TriangleLight>(lights[i]->kind);
    const auto [at, is_new] = meshes.try_emplace(lamps[i], description.meshes.size());
    if (is_new) {
      Mesh mesh;
      mesh.name = "area light";
      mesh.materials.emplace_back(description.materials.size());
      description.materials.push_back(black_emitter(triangle, lights[i]->span));
      description.instances.push_back(
          {MeshHandle(description.meshes.size()), {}, {}, lights[i]->span});
      description.meshes.push_back(std::move(mesh));
    }
    Mesh& mesh = description.meshes[at->second];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), triangle.vertices.begin(), triangle.vertices.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
}

}  // namespace candela::description
