#include "renderer/scene/compile_media.h"

#include <algorithm>
#include <variant>

#include "renderer/math/ray.h"

namespace candela {
namespace {

using description::SceneDescription;

constexpr double largest_coefficient = 1e30;  // optical depths of all ways in the scene are floats

// Thinner channels are clear: light would scatter farther out than rays can start from
// (farthest_traceable), thirty free paths and more.
constexpr double thinnest_extinction = 30 / static_cast<double>(farthest_traceable);

// Beyond this the peak is narrower than directions in float can tell.
constexpr double largest_asymmetry = 0.9999;

// Coefficients have the inverse of a length in them.
Medium compile_medium(const description::Medium& medium, const Normalisation& n) {
  Vec3d scattering = medium.scattering / n.scale;
  Vec3d extinction = (medium.scattering + medium.absorption) / n.scale;
  for (int c = 0; c < 3; ++c)
    if (extinction[c] < thinnest_extinction) scattering[c] = extinction[c] = 0;
  Medium out;
  out.scattering = Rgb(glm::min(scattering, Vec3d(largest_coefficient)));
  out.extinction = Rgb(glm::min(extinction, Vec3d(largest_coefficient)));
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
    if (!handle) return {};
    MediumHandle& compiled = compiled_[handle.index];
    if (!compiled) {
      const Medium medium = compile_medium(description_.media[handle.index], scene_.normalisation);
      if (is_black(medium.extinction)) return {};
      compiled = MediumHandle(scene_.media.size());
      scene_.media.push_back(medium);
    }
    return compiled;
  }

 private:
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
