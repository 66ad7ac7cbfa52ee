#include "renderer/scene/compile_environment.h"

#include <vector>

#include <fmt/format.h>

#include "renderer/description/validate.h"
#include "renderer/description/validate_light.h"
#include "renderer/light/build_environment.h"
#include "renderer/light/sum_environments.h"

namespace candela {
namespace {

using description::ConstantEnvironment;
using description::Light;
using description::SceneDescription;

struct EnvironmentCompiler {
  std::span<const description::Image> images;
  TextureStore& textures;
  Diagnostics& diagnostics;

  std::optional<Environment> operator()(const ConstantEnvironment& light) const {
    return build_environment(light);
  }
  std::optional<Environment> operator()(const description::CubeEnvironment& light) const {
    return build_environment(light, images, textures, diagnostics);
  }
  std::optional<Environment> operator()(const description::LatLongEnvironment& light) const {
    return build_environment(light, images, textures, diagnostics);
  }
  std::optional<Environment> operator()(const description::EqualAreaEnvironment& light) const {
    return build_environment(light, images, textures, diagnostics);
  }
  template <class Other>
  std::optional<Environment> operator()(const Other&) const {
    return std::nullopt;
  }
};

// Those that count: where all are black, the first.
std::vector<const Light*> environments_of(const SceneDescription& description) {
  std::vector<const Light*> found;
  const Light* black = nullptr;
  for (const Light& light : description.lights) {
    if (!description::is_environment(light)) continue;
    if (!description::is_black(light))
      found.push_back(&light);
    else if (black == nullptr)
      black = &light;
  }
  if (found.empty() && black != nullptr) found.push_back(black);
  return found;
}

Environment sum_of(const SceneDescription& description, const std::vector<const Light*>& lights,
                   TextureStore& textures, Diagnostics& diagnostics) {
  std::vector<Environment> maps;
  for (const Light* light : lights)
    if (!std::holds_alternative<ConstantEnvironment>(light->kind))
      maps.push_back(*compile_environment(*light, description.images, textures, diagnostics));
  const Vec3d constant = sum_of_constants(description);
  if (maps.empty())
    return build_environment(ConstantEnvironment{
        constant, std::get<ConstantEnvironment>(lights[0]->kind).is_seen_by_camera});
  EnvironmentSum sum = sum_environments(constant, maps, textures);
  if (sum.resampled_side > 0)
    diagnostics.note(lights[1]->span,
                     fmt::format("the scene's {} skies differ in grid or rotation: their sum is "
                                 "resampled to a map of equal areas, {} x {} texels",
                                 lights.size(), sum.resampled_side, sum.resampled_side));
  return std::move(sum.environment);
}

}  // namespace

std::optional<Environment> compile_environment(const Light& light,
                                               std::span<const description::Image> images,
                                               TextureStore& textures, Diagnostics& diagnostics) {
  std::optional<Environment> environment =
      std::visit(EnvironmentCompiler{images, textures, diagnostics}, light.kind);
  if (environment)
    for (const TextureHandle face : environment->faces)
      if (face)
        textures.check_brightness(face, double{max_component(environment->scale)},
                                  description::largest_radiance, diagnostics);
  return environment;
}

std::optional<Environment> compile_environments(const SceneDescription& description,
                                                TextureStore& textures, Diagnostics& diagnostics) {
  const std::vector<const Light*> lights = environments_of(description);
  if (lights.empty()) return std::nullopt;
  if (lights.size() == 1)
    return compile_environment(*lights[0], description.images, textures, diagnostics);
  return sum_of(description, lights, textures, diagnostics);
}

Vec3d sum_of_constants(const SceneDescription& description) {
  Vec3d sum(0.0);
  for (const Light& light : description.lights)
    if (const auto* constant = std::get_if<ConstantEnvironment>(&light.kind))
      sum += constant->radiance;
  return sum;
}

}  // namespace candela
