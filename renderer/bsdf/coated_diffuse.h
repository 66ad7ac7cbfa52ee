// Lambert's surface under a dielectric coat, smooth or GGX-rough: what the coat reflects, and what
// crosses it, meets the surface any number of times, and leaves.
//
//   f = F D G / (4 cos_o cos_i) + T(o) T(i) / (pi eta^2) * kd (1 - (kd R)^n) / (1 - kd R)
//
// T is the share of light that reaches the surface, R that of the surface's light that the coat
// throws back onto it (coat_table.h). A Lambert surface forgets where light came from, so the
// product is exact where interfaces scatter once; n is the number of times that light may leave the
// surface. bsdf.diffuse is the last factor over eta^2 (coated_reflectance()).
//
// Not inline: so that kernels stay as small as they are without it.
#pragma once

#include "renderer/bsdf/coat.h"
#include "renderer/bsdf/coated_lobes.h"

namespace candela {

// Of the surface's own reflectance kd; `bounces` 0: any number.
[[nodiscard]] Rgb coated_reflectance(const CoatTable& coat, float alpha, const Rgb& kd,
                                     int bounces);

// What the diffuse part sends back of light from cos_o.
[[nodiscard]] Rgb coated_diffuse_albedo(const Bsdf& bsdf, float cos_o);

[[nodiscard]] CoatedLobes coated_lobes_of(const Bsdf& bsdf, float cos_o);

[[nodiscard]] BsdfEvaluation evaluate_coated_diffuse(const Bsdf& bsdf, const Vec3f& wo,
                                                     const Vec3f& wi);
[[nodiscard]] BsdfSample sample_coated_diffuse(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                               Vec2f direction);

}  // namespace candela
