// Fresnel reflectances of unpolarised light: Schlick's approximation, exact for dielectrics, exact
// for conductors. All results lie in [0, 1] and are never NaN, whatever the angles and indices;
// Schlick's as far as its f0 does.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

// x in [0, 1]; 0 for NaN.
[[nodiscard]] inline float clamp_unit(float x) {
  return std::min(1.0f, std::max(0.0f, x));
}
[[nodiscard]] inline Rgb clamp_unit(const Rgb& c) {
  return {clamp_unit(c.x), clamp_unit(c.y), clamp_unit(c.z)};
}

// (1 - cos)^5, the weight of the reflectance at grazing incidence [Schlick94, eq. 15].
[[nodiscard]] inline float schlick_weight(float cos_theta) {
  const float m = clamp_unit(1 - cos_theta);
  return square(square(m)) * m;
}
[[nodiscard]] inline Rgb fresnel_schlick(const Rgb& f0, float cos_theta) {
  return f0 + (Rgb{1} - f0) * schlick_weight(cos_theta);
}

// Reflectance of normal incidence on an interface of relative index eta.
[[nodiscard]] inline float normal_reflectance(float eta) {
  return clamp_unit(square((eta - 1) / (eta + 1)));
}

struct DielectricFresnel {
  float reflectance = 1;
  float cos_transmitted = 0;  // > 0 of the refracted direction; 0 under total internal reflection
};

// `eta`: index of the far side over that of the side of incidence; cos_theta >= 0 on that side.
// (eta cos_t)^2 = eta^2 - sin^2 is written so that it does not cancel for eta near 1.
[[nodiscard]] inline DielectricFresnel fresnel_dielectric(float cos_theta, float eta) {
  const float eta2_cos2_t = (eta - 1) * (eta + 1) + square(cos_theta);
  // One condition, which lanes can have: where cos_theta is NaN the other is, too.
  if (!(std::min(eta2_cos2_t, cos_theta) > 0)) return {};
  const float eta_cos_t = std::sqrt(eta2_cos2_t);
  const float cos_t = std::min(1.0f, eta_cos_t / eta);
  const float perpendicular = (cos_theta - eta_cos_t) / (cos_theta + eta_cos_t);
  const float parallel = (eta * cos_theta - cos_t) / (eta * cos_theta + cos_t);
  return {clamp_unit(0.5f * (square(perpendicular) + square(parallel))), cos_t};
}

// 1 - F of a refraction whose two cosines are known: without cancellation at grazing angles and
// near the critical one, and the same from both sides.
[[nodiscard]] inline float fresnel_transmittance(float cos_theta, float cos_transmitted,
                                                 float eta) {
  const float perpendicular = cos_theta + eta * cos_transmitted;
  const float parallel = eta * cos_theta + cos_transmitted;
  const float product = 2 * eta * cos_theta * cos_transmitted;
  return clamp_unit(product / square(perpendicular) + product / square(parallel));
}

// One channel of a conductor with relative index eta + i k; [Lagarde13, "conductor-dielectric"]
// with a + i b = sqrt((eta + i k)^2 - sin^2). Of a^2 and b^2 the larger is a sum and the smaller
// their product (eta k)^2 over it, and the amplitudes' differences are squared as such: nothing
// cancels where eta is near 1 and k near 0, also at grazing angles. Squares beyond `mirror_like`
// are those of surfaces that absorb less than floats can tell.
[[nodiscard]] inline float fresnel_conductor(float cos_theta, float eta, float k) {
  constexpr float mirror_like = 1e36f;
  const float c = clamp_unit(cos_theta);
  const float sin2 = (1 - c) * (1 + c);
  const float difference = (eta - 1) * (eta + 1) - square(k) + square(c);  // a^2 - b^2
  const float product = square(eta * k);
  const float larger = 0.5f * (std::sqrt(square(difference) + 4 * product) + std::abs(difference));
  if (!(larger > 0 && larger < mirror_like)) return 1;
  const float smaller = product / larger;
  const float a = std::sqrt(difference > 0 ? larger : smaller);
  const float b2 = difference > 0 ? smaller : larger;
  const float denominator_s = square(a + c) + b2;
  const float denominator_p = square(a * c + sin2) + b2 * square(c);
  if (!(denominator_s > 0) || !(denominator_p > 0)) return 1;
  const float s = (square(a - c) + b2) / denominator_s;
  const float p_over_s = (square(a * c - sin2) + b2 * square(c)) / denominator_p;
  return clamp_unit(0.5f * s * (1 + p_over_s));
}
[[nodiscard]] inline Rgb fresnel_conductor(float cos_theta, const Rgb& eta, const Rgb& k) {
  return {fresnel_conductor(cos_theta, eta.x, k.x), fresnel_conductor(cos_theta, eta.y, k.y),
          fresnel_conductor(cos_theta, eta.z, k.z)};
}

}  // namespace candela
