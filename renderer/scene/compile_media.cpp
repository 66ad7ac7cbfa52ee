#include "renderer/scene/compile_media.h"

#include <algorithm>
#include <variant>

namespace candela {
namespace {

using description::SceneDescription;

// Coefficients have the inverse of a length in them.
Rgb scaled(const Vec3d& coefficient, const Normalisation& n) {
  constexpr double largest = 1e30;  // optical depths of all ways in the scene are floats
  return Rgb(glm::min(coefficient / n.scale, Vec3d(largest)));
}

// Beyond this the peak is narrower than directions in float can tell.
constexpr double largest_asymmetry = 0.9999;

Medium compile_medium(const description::Medium& medium, const Normalisation& n) {
  Medium out;
  out.scattering = scaled(medium.scattering, n);
  out.extinction = scaled(medium.scattering + medium.absorption, n);
  out.asymmetry =
      static_cast<float>(std::clamp(medium.asymmetry, -largest_asymmetry, largest_asymmetry));
  return out;
}

// Compiles each medium when it is first referred to.
class MediumTable {
 public:
  MediumTable(const SceneDescription& description, Scene& scene)
      : description_(description), scene_(scene), compiled_(description.media.size()) {}

  MediumHandle of(description::MediumHandle handle) {
    if (!handle || is_clear(handle)) return {};
    MediumHandle& compiled = compiled_[handle.index];
    if (!compiled) {
      compiled = MediumHandle(scene_.media.size());
      scene_.media.push_back(
          compile_medium(description_.media[handle.index], scene_.normalisation));
    }
    return compiled;
  }

 private:
  [[nodiscard]] bool is_clear(description::MediumHandle handle) const {
    const description::Medium& medium = description_.media[handle.index];
    return medium.absorption == Vec3d(0.0) && medium.scattering == Vec3d(0.0);
  }

  const SceneDescription& description_;
  Scene& scene_;
  std::vector<MediumHandle> compiled_;
};

// Boundaries of one medium with itself refer to none.
MediumBoundary compile_boundary(const description::Material& material, MediumTable& media) {
  const description::MediumInterface& sides = material.media;
  if (sides.inside == sides.outside) return {};
  return {media.of(sides.inside), media.of(sides.outside),
          std::holds_alternative<description::InterfaceMaterial>(material.model)};
}

}  // namespace

void compile_media(const SceneDescription& description, const std::vector<bool>& used, Scene& scene,
                   DropCounts& dropped) {
  MediumTable media(description, scene);
  for (std::size_t i = 0; i < description.cameras.size(); ++i)
    scene.cameras[i].medium = media.of(description.cameras[i].medium);
  std::vector<MediumBoundary> boundaries(description.materials.size());
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    if (used[i]) boundaries[i] = compile_boundary(description.materials[i], media);
  const std::size_t unused = description.media.size() - scene.media.size();
  if (unused > 0) dropped[DropReason::ClearMedia] += unused;
  if (scene.media.empty()) return;
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    if (boundaries[i].is_clear && boundaries[i].is_transition())
      scene.materials[i].opacity = {1, {}, 0};
  scene.medium_boundaries = std::move(boundaries);
}

}  // namespace candela
