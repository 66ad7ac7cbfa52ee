// Conductors and dielectrics whose GGX width along the frame's y is another than that along x;
// never smooth. Not inline: so that kernels stay as small as they are without them.
#pragma once

#include "renderer/bsdf/bsdf.h"

namespace candela {

[[nodiscard]] BsdfEvaluation evaluate_anisotropic_conductor(const Bsdf& bsdf, const Vec3f& wo,
                                                            const Vec3f& wi);
[[nodiscard]] BsdfSample sample_anisotropic_conductor(const Bsdf& bsdf, const Vec3f& wo,
                                                      Vec2f direction);

[[nodiscard]] BsdfEvaluation evaluate_anisotropic_dielectric(const Bsdf& bsdf, const Vec3f& wo,
                                                             const Vec3f& wi);
[[nodiscard]] BsdfSample sample_anisotropic_dielectric(const Bsdf& bsdf, const Vec3f& wo,
                                                       float lobe, Vec2f direction);

}  // namespace candela
