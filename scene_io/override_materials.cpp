#include "scene_io/override_materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace candela {
namespace {

using namespace description;

// n with ((n - 1) / (n + 1))^2 = f0. F0 = 1 has none: the nearest that has.
double index_of_reflectance(double f0) {
  const double root = std::sqrt(std::clamp(f0, 0.0, 1 - 1e-6));
  return (1 + root) / (1 - root);
}

void override_fresnel(FresnelModel fresnel, CookTorranceMaterial& material) {
  material.fresnel = fresnel;
  const bool has_indices = material.ior || material.eta_k;
  if (fresnel == FresnelModel::Exact && !has_indices) {
    const Vec3d eta{index_of_reflectance(material.f0.x), index_of_reflectance(material.f0.y),
                    index_of_reflectance(material.f0.z)};
    material.eta_k = {eta, Vec3d(0.0)};
  }
}

}  // namespace

void override_materials(const LoadOptions& options, SceneDescription& scene,
                        Diagnostics& diagnostics) {
  for (Material& material : scene.materials) {
    auto* rough = std::get_if<CookTorranceMaterial>(&material.model);
    if (!rough) continue;
    if (options.fresnel) override_fresnel(*options.fresnel, *rough);
    if (!options.geometry) continue;
    rough->geometry = *options.geometry;
    if (rough->energy_compensation && rough->geometry != GeometryModel::Smith)
      diagnostics.error(material.span,
                        fmt::format("material '{}' has energy_compensation, which needs "
                                    "--geometry smith",
                                    material.name));
  }
}

}  // namespace candela
