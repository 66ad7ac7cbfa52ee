#include "integrators/path/check_sampling.h"

#include <string_view>

#include <fmt/format.h>

#include "renderer/bsdf/ggx.h"
#include "renderer/description/used_materials.h"

namespace candela {
namespace {

using namespace description;

bool is_smooth(const ScalarInput& roughness) {
  return !roughness.map && roughness.factor < static_cast<double>(smallest_ggx_width);
}

// Whether a material has a delta lobe beside another. One alone is followed as it is.
struct HasDeltaLobeBeside {
  bool operator()(const CoatedDiffuseMaterial& m) const { return is_smooth(m.coat.roughness); }
  bool operator()(const CoatedConductorMaterial& m) const { return is_smooth(m.coat.roughness); }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

// The kind of a delta light that sheds light, or "".
struct NameOfDeltaLight {
  std::string_view operator()(const PointLight& light) const {
    return light.intensity == Vec3d(0.0) ? "" : "a point light";
  }
  std::string_view operator()(const SpotLight& light) const {
    return light.intensity == Vec3d(0.0) ? "" : "a spot light";
  }
  std::string_view operator()(const GoniometricLight& light) const {
    return light.intensity == Vec3d(0.0) ? "" : "a goniometric light";
  }
  std::string_view operator()(const ProjectionLight& light) const {
    return light.intensity == Vec3d(0.0) ? "" : "a projection light";
  }
  std::string_view operator()(const DirectionalLight& light) const {
    return light.irradiance == Vec3d(0.0) ? "" : "a directional light";
  }
  template <class Wide>
  std::string_view operator()(const Wide&) const {
    return "";
  }
};

void check_lobes(const SceneDescription& scene, SamplingStrategy strategy,
                 Diagnostics& diagnostics) {
  const std::vector<bool> is_used = used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    if (is_used[i] && std::visit(HasDeltaLobeBeside{}, material.model))
      diagnostics.error(material.span,
                        fmt::format("material '{}' is smoothly coated, and sampling by '{}' does "
                                    "not follow the coat's reflection; expected mis, bsdf or light",
                                    material.name, name_of(strategy)));
  }
}

void check_lights(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (const Light& light : scene.lights) {
    const std::string_view kind = std::visit(NameOfDeltaLight{}, light.kind);
    if (!kind.empty())
      diagnostics.error(light.span,
                        fmt::format("the scene has {}, which sampling by 'bsdf' never meets; "
                                    "expected mis, light, cosine or uniform",
                                    kind));
  }
}

}  // namespace

Diagnostics check_sampling(const SceneDescription& scene, SamplingStrategy strategy) {
  Diagnostics diagnostics;
  if (strategy == SamplingStrategy::Bsdf) check_lights(scene, diagnostics);
  if (!samples_bsdfs(strategy)) check_lobes(scene, strategy, diagnostics);
  return diagnostics;
}

}  // namespace candela
