#include "renderer/description/validate_mesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace candela::description {
namespace {

bool is_finite_number(const Vec2f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
template <class V>
bool is_finite_number(const V& v) {
  return is_finite(v);
}

// One sentence for all of them, with the first's index.
template <class V>
void check_finite(const Mesh& mesh, const std::vector<V>& values, std::string_view what,
                  Diagnostics& diagnostics) {
  const auto is_bad = [](const V& value) { return !is_finite_number(value); };
  const auto first = std::find_if(values.begin(), values.end(), is_bad);
  if (first == values.end()) return;
  diagnostics.error(
      mesh.span, fmt::format("mesh '{}': {} of {} {} have numbers that are not finite, the "
                             "first is number {}",
                             mesh.name, std::count_if(first, values.end(), is_bad), values.size(),
                             what, first - values.begin() + 1));
}

void check_size(const Mesh& mesh, std::size_t size, std::string_view what,
                Diagnostics& diagnostics) {
  if (size != 0 && size != mesh.positions.size())
    diagnostics.error(mesh.span, fmt::format("mesh '{}' has {} {} for {} vertices, expected none "
                                             "or as many",
                                             mesh.name, size, what, mesh.positions.size()));
}

void check_triangles(const Mesh& mesh, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (std::max({a, b, c}) < mesh.positions.size()) continue;
    diagnostics.error(
        mesh.span, fmt::format("mesh '{}': triangle {} uses vertex {} of {} (from 0)", mesh.name, i,
                               std::max({a, b, c}), mesh.positions.size()));
    return;
  }
}

void check_materials(const SceneDescription& scene, const Mesh& mesh, Diagnostics& diagnostics) {
  if (mesh.sphere && mesh.materials.size() != 1)
    return diagnostics.error(mesh.span, fmt::format("mesh '{}' is a sphere with {} materials, "
                                                    "expected 1",
                                                    mesh.name, mesh.materials.size()));
  const std::size_t count = mesh.materials.size();
  if (count != 1 && count != mesh.triangles.size())
    diagnostics.error(mesh.span, fmt::format("mesh '{}' has {} materials for {} triangles, "
                                             "expected 1 or as many",
                                             mesh.name, count, mesh.triangles.size()));
  const bool is_in_range =
      std::all_of(mesh.materials.begin(), mesh.materials.end(),
                  [&](MaterialHandle material) { return material.index < scene.materials.size(); });
  if (!is_in_range)
    diagnostics.error(mesh.span,
                      fmt::format("mesh '{}' has a material that does not exist", mesh.name));
}

void check_sphere(const Mesh& mesh, Diagnostics& diagnostics) {
  if (!mesh.sphere) return;
  const double radius = mesh.sphere->radius;
  if (!(radius > 0 && std::isfinite(radius)))
    diagnostics.error(mesh.span, fmt::format("mesh '{}' is a sphere of radius {}, expected above 0",
                                             mesh.name, radius));
  if (!mesh.positions.empty() || !mesh.triangles.empty())
    diagnostics.error(
        mesh.span, fmt::format("mesh '{}' is a sphere and has vertices or triangles", mesh.name));
}

}  // namespace

void check_mesh(const SceneDescription& scene, const Mesh& mesh, Diagnostics& diagnostics) {
  check_size(mesh, mesh.normals.size(), "normals", diagnostics);
  check_size(mesh, mesh.uvs.size(), "texture coordinates", diagnostics);
  check_finite(mesh, mesh.positions, "vertices", diagnostics);
  check_finite(mesh, mesh.normals, "normals", diagnostics);
  check_finite(mesh, mesh.uvs, "texture coordinates", diagnostics);
  check_triangles(mesh, diagnostics);
  check_materials(scene, mesh, diagnostics);
  check_sphere(mesh, diagnostics);
}

}  // namespace candela::description
