// A perfect mirror of constant reflectance.
#pragma once

#include "renderer/bsdf/bsdf.h"

namespace candela {

[[nodiscard]] inline BsdfSample mirror_sample(const Vec3f& wo, const Rgb& weight) {
  return {.wi = {-wo.x, -wo.y, wo.z}, .weight = weight, .is_delta = true};
}

[[nodiscard]] inline BsdfSample sample_mirror(const Bsdf& bsdf, const Vec3f& wo) {
  return mirror_sample(wo, bsdf.diffuse);
}

}  // namespace candela
