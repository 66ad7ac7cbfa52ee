// The phase function of Henyey and Greenstein [Henyey41]: how a medium scatters, by one number g,
// the mean cosine between the directions that light comes and goes. In solid angle; its own
// density.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/frame.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

struct PhaseSample {
  Vec3f wi{0};
  float pdf = 0;
};

// Both directions are unit and point away from the place of scattering, so that light that goes
// straight on has wi = -wo. 1 + g^2 - 2 g cos = (1 - g)^2 + g |wi + wo|^2 does not cancel about the
// peak of large g.
[[nodiscard]] inline float phase_function(float g, const Vec3f& wo, const Vec3f& wi) {
  constexpr float inverse_four_pi = 0.25f * inverse_pi;
  const float d = g >= 0 ? square(1 - g) + g * length_squared(wi + wo)
                         : square(1 + g) - g * length_squared(wi - wo);
  return inverse_four_pi * (1 - g) * (1 + g) / (d * std::sqrt(d));
}

// The cosine of [Pharr23, eq. 11.3.1], expanded so that neither small g nor g = 0 cancels.
[[nodiscard]] inline double sampled_phase_cosine(double g, double u) {
  const double s = 2 * u - 1;
  const double cosine =
      (2 * s + g * (s * s + 3) + 2 * g * g * s + g * g * g * (s * s - 1)) / (2 * square(1 + g * s));
  return std::clamp(cosine, -1.0, 1.0);
}

// Density phase_function().
[[nodiscard]] inline PhaseSample sample_phase_function(float g, const Vec3f& wo, Vec2f u) {
  const double cosine = sampled_phase_cosine(double{g}, double{u.x});
  const auto sine = static_cast<float>(std::sqrt((1 - cosine) * (1 + cosine)));
  SinCos phi = sin_cos_of_turns(u.y);
  Frame frame = frame_from_normal(-wo);
  Vec3f wi = frame.to_world({sine * phi.cos, sine * phi.sin, static_cast<float>(cosine)});
  return {wi, phase_function(g, wo, wi)};
}

}  // namespace candela
