// Lights, and what surfaces emit.
#pragma once

#include <optional>

#include "scene_io/pbrt/context.h"

namespace candela::pbrt {

// All LightSource directives.
void read_lights(Context& context);

struct Emission {
  Vec3d radiance{0.0};
  bool emits_both_sides = false;
  std::optional<double> power;     // of each of pbrt's shapes, in place of its radiance
  description::ImageHandle map{};  // a factor of the radiance
  bool is_maps_mean = false;       // the radiance is that of the map's mean

  // `area` is that of one of pbrt's shapes in the world: each triangle and each patch of a mesh has
  // the whole power.
  [[nodiscard]] Vec3d radiance_on(double area) const;
};

// Of an AreaLightSource.
[[nodiscard]] Emission read_emission(Context& context, Statement& statement);

}  // namespace candela::pbrt
