// Homogeneous media in normalised space, and the surfaces that bound them.
#pragma once

#include "renderer/base/handle.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

struct Medium;
using MediumHandle = Handle<Medium>;

// Coefficients a unit of normalised space, a channel.
struct Medium {
  Rgb extinction{0};    // sigma_t: absorption and scattering
  Rgb scattering{0};    // sigma_s
  float asymmetry = 0;  // g of the phase function (phase_function.h)

  [[nodiscard]] bool scatters() const { return !is_black(scattering); }
};

// The media on both sides of a surface.
struct MediumBoundary {
  MediumHandle inside;
  MediumHandle outside;
  bool is_clear = false;  // nothing else is there: light goes straight on

  // Where they are alike, the surface is within whatever surrounds it.
  [[nodiscard]] bool is_transition() const { return inside != outside; }
};

// Optical depths of a way, a channel; what does not dim is not dimmed by an infinite way either.
[[nodiscard]] inline Rgb optical_depth(const Rgb& coefficient, float distance) {
  const auto depth = [distance](float c) { return c > 0 ? c * distance : 0.0f; };
  return {depth(coefficient.x), depth(coefficient.y), depth(coefficient.z)};
}

// Beer's law: what is left of light after an optical depth.
[[nodiscard]] inline Rgb transmittance_of(const Rgb& optical_depth) {
  return {decay(optical_depth.x), decay(optical_depth.y), decay(optical_depth.z)};
}

}  // namespace candela
