#include "integrators/path/check_sampling.h"

#include <string_view>

#include <fmt/format.h>

#include "integrators/name_of_delta_light.h"
#include "renderer/bsdf/ggx.h"
#include "renderer/description/used_materials.h"

namespace candela {
namespace {

using namespace description;

// A map or a texture may be smooth somewhere.
bool may_be_smooth(const ScalarInput& roughness) {
  return !roughness.is_constant() || roughness.factor < static_cast<double>(smallest_ggx_width);
}
// The larger of two widths decides (coat_widths_at()).
template <class Layer>
bool may_be_smooth(const Layer& layer) {
  return may_be_smooth(layer.roughness) &&
         (!layer.roughness_across || may_be_smooth(*layer.roughness_across));
}
template <class Layer>
bool varies(const Layer& layer) {
  return !layer.roughness.is_constant() ||
         (layer.roughness_across && !layer.roughness_across->is_constant());
}

// Whether a material has, or may have somewhere, a delta lobe beside another. One alone is followed
// as it is.
struct HasDeltaLobeBeside {
  bool operator()(const CoatedDiffuseMaterial& m) const { return may_be_smooth(m.coat); }
  bool operator()(const CoatedConductorMaterial& m) const {
    const bool is_one_delta_lobe =
        may_be_smooth(m) && !varies(m) && !varies(m.coat);  // where the coat is smooth
    return may_be_smooth(m.coat) && !is_one_delta_lobe;
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

struct HasVaryingCoat {
  template <class Model>
  bool operator()(const Model& m) const {
    if constexpr (requires { m.coat; }) return varies(m.coat);
    return false;
  }
};

void check_lobes(const SceneDescription& scene, SamplingStrategy strategy,
                 Diagnostics& diagnostics) {
  const std::vector<bool> is_used = used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    if (is_used[i] && std::visit(HasDeltaLobeBeside{}, material.model))
      diagnostics.error(
          material.span,
          fmt::format("material '{}' {} smoothly coated, and sampling by '{}' does not follow the "
                      "coat's reflection; expected mis, bsdf or light",
                      material.name, std::visit(HasVaryingCoat{}, material.model) ? "may be" : "is",
                      name_of(strategy)));
  }
}

void check_lights(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (const Light& light : scene.lights) {
    const std::string_view kind = name_of_delta_light(light);
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
