// What a kernel instance can do. A scene gets one that covers what it needs; each bit left out
// removes code and never changes a bit of the picture. More bits were tried: what they left out was
// less than 5 % of the time (docs/decisions.md, "Which kernels there are").
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/scene/scene.h"

namespace candela {

struct FeatureSet {
  bool spheres = false;
  bool media = false;
  bool strategies = false;  // RenderOptions' sampling and heuristic count; else Mis by Power
  bool guided = false;      // directions may be guided (guide.h)
  bool lanes = false;       // paths on plain surfaces take their steps side by side (plain_lanes.h)
  ModelSet models = all_models;  // fewer only where a loop over lanes has sorted them

  [[nodiscard]] constexpr FeatureSet with_models(ModelSet others) const {
    FeatureSet features = *this;
    features.models = others;
    return features;
  }

  // An observer may be told what paths do (integrators/path_observer.h).
  [[nodiscard]] constexpr bool observed() const {
    return guided || (media && !lanes && !strategies);
  }

  // Pixels may share what paths find (path_reuse.h).
  [[nodiscard]] constexpr bool reuses_paths() const { return !strategies && !guided; }

  [[nodiscard]] constexpr LightKindSet light_kinds() const {
    return spheres ? all_light_kinds : all_light_kinds & ~light_kind_bit(LightKind::Sphere);
  }

  [[nodiscard]] constexpr bool covers(const SceneFeatures& scene) const {
    return (spheres || !scene.spheres) && (media || !scene.media);
  }
};

// Every path takes its steps alone: what the kernels with lanes are held against. Everything but
// media and spheres, which few scenes have; those with either get the next.
inline constexpr FeatureSet general_features{};

// With media, paths know what they are in and shadow rays what they cross.
inline constexpr FeatureSet media_features{.spheres = true, .media = true};

// Everything but media. That it has spheres costs other scenes nothing.
inline constexpr FeatureSet lane_features{.spheres = true, .lanes = true};

// And with media: lanes are for paths that are in none of them.
inline constexpr FeatureSet media_lane_features{.spheres = true, .media = true, .lanes = true};

// For comparisons of estimators.
inline constexpr FeatureSet strategy_features{.spheres = true, .media = true, .strategies = true};

// Where a trial says that guiding pays. Scenes with media are not guided.
inline constexpr FeatureSet guided_features{.spheres = true, .guided = true};

}  // namespace candela
