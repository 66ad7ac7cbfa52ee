// Compiled lights in normalised space. One file a kind beside this one; the table that picks among
// them is light_sampler.h.
#pragma once

#include <cstdint>

#include "renderer/math/constants.h"
#include "renderer/math/vec.h"

namespace candela {

enum class LightKind : std::uint8_t { Point, Spot, Directional, Triangle, Environment };

// Delta lights have no area: only next-event estimation sees them.
struct Light {
  LightKind kind = LightKind::Point;
  bool emits_both_sides = false;  // Triangle
  // Point, Spot: position; Directional: unit direction towards the light; Triangle: vertex 0
  Vec3f position{0};
  Vec3f edge1{0};  // Triangle: v1 - v0;  Spot: unit axis outwards
  Vec3f edge2{0};  // Triangle: v2 - v0
  // Point, Spot: radiant intensity; Directional: irradiance; Triangle: radiance
  Rgb emission{0};
  float cos_inner = 1;  // Spot
  float cos_outer = 1;
  float area = 0;                        // Triangle
  std::uint32_t geometry = 0xffffffffu;  // Triangle: where it lies, for its shadow ray's end
  std::uint32_t triangle = 0;

  [[nodiscard]] bool is_delta() const {
    return kind == LightKind::Point || kind == LightKind::Spot || kind == LightKind::Directional;
  }
};

// A direction towards a light from a point.
struct LightSample {
  Vec3f wi{0};      // unit
  Rgb radiance{0};  // arriving along wi if nothing is in the way; delta lights: irradiance
                    // on a surface that faces them (pdf is 1)
  float pdf = 0;    // solid angle, given the light was chosen; 1 for delta lights; 0: no sample
  bool is_delta = false;
  bool is_infinite = false;  // directional, environment: no end point
  Vec3f point{0};            // where the shadow ray ends, unless is_infinite
  Vec3f point_error{0};      // bound of its rounding error, per axis
  Vec3f normal{0};           // geometric normal there; zero for point lights
};

}  // namespace candela
