// What a kernel instance can do. A scene gets the smallest instance that covers what it needs; each
// bit left out removes code, never changes a bit of the result (invariant 2).
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/scene/scene.h"

namespace candela {

struct FeatureSet {
  bool textures = true;  // any texture, of lights too, bump or normal map, mixed materials
  bool instances = true;
  bool delta_lights = true;
  bool environment = true;
  bool thin_lens = true;
  bool spheres = false;
  bool media = false;
  bool strategies = false;  // RenderOptions' sampling and heuristic count; else Mis by Power
  bool guided = false;      // directions may be guided (guide.h)
  bool lanes = false;       // paths on plain surfaces take their steps side by side (plain_lanes.h)
  ModelSet models = all_models;

  [[nodiscard]] constexpr FeatureSet with_models(ModelSet others) const {
    FeatureSet features = *this;
    features.models = others;
    return features;
  }

  [[nodiscard]] constexpr LightKindSet light_kinds() const {
    LightKindSet kinds = surface_light_kinds;
    if (delta_lights)
      kinds |= light_kind_bit(LightKind::Point) | light_kind_bit(LightKind::Spot) |
               light_kind_bit(LightKind::Directional);
    if (textures) kinds |= light_kind_bit(LightKind::TexturedTriangle);
    if (textures && delta_lights)
      kinds |= light_kind_bit(LightKind::Goniometric) | light_kind_bit(LightKind::Projection);
    if (spheres) kinds |= light_kind_bit(LightKind::Sphere);
    if (environment) kinds |= light_kind_bit(LightKind::Environment);
    return kinds;
  }

  [[nodiscard]] constexpr bool covers(const SceneFeatures& scene) const {
    return (textures || !(scene.textures || scene.bump)) && (instances || !scene.instances) &&
           (delta_lights || !scene.delta_lights) && (environment || !scene.environment) &&
           (thin_lens || !scene.thin_lens) && (spheres || !scene.spheres) &&
           (media || !scene.media) && (scene.bsdf_models & ~models) == 0;
  }
};

// Every path takes its steps alone: what the kernels with lanes are held against. Everything but
// media and spheres, which few scenes have; those with either get the next.
inline constexpr FeatureSet general_features{};

// With media, paths know what they are in and shadow rays what they cross.
inline constexpr FeatureSet media_features{.spheres = true, .media = true};

// Everything but media. That it has spheres costs other scenes nothing (docs/decisions.md).
inline constexpr FeatureSet broad_features{.spheres = true, .lanes = true};

// For comparisons of estimators.
inline constexpr FeatureSet strategy_features{.spheres = true, .media = true, .strategies = true};

// Where a trial says that guiding pays. Scenes with media are not guided.
inline constexpr FeatureSet guided_features{.spheres = true, .guided = true};

// Cornell boxes and the like: triangles, area lights, opaque untextured surfaces.
inline constexpr FeatureSet plain_features{
    .textures = false,
    .instances = false,
    .delta_lights = false,
    .environment = false,
    .thin_lens = false,
    .lanes = true,
    .models = model_bit(BsdfModel::Diffuse) | model_bit(BsdfModel::CookTorrance)};

// The course's scenes. With lanes in the broad kernel this gains little (docs/decisions.md).
inline constexpr FeatureSet lab_features{
    .instances = false,
    .thin_lens = false,
    .lanes = true,
    .models = model_bit(BsdfModel::Diffuse) | model_bit(BsdfModel::Lab)};

}  // namespace candela
