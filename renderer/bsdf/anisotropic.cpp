#include "renderer/bsdf/anisotropic.h"

#include "renderer/bsdf/conductor.h"
#include "renderer/bsdf/dielectric.h"

namespace candela {
namespace {

Vec2f valid_widths(const Bsdf& bsdf) {
  return ggx_width(widths_of(bsdf));
}

}  // namespace

BsdfEvaluation evaluate_anisotropic_conductor(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  return evaluate_rough_conductor(bsdf, valid_widths(bsdf), wo, wi);
}

BsdfSample sample_anisotropic_conductor(const Bsdf& bsdf, const Vec3f& wo, Vec2f direction) {
  const Vec3f wi = sample_ggx_reflection(wo, valid_widths(bsdf), direction);
  return to_sample(wi, evaluate_anisotropic_conductor(bsdf, wo, wi));
}

BsdfEvaluation evaluate_anisotropic_dielectric(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  return evaluate_rough_dielectric(bsdf, valid_widths(bsdf), wo, wi);
}

BsdfSample sample_anisotropic_dielectric(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                         Vec2f direction) {
  return sample_rough_dielectric(bsdf, valid_widths(bsdf), wo, lobe, direction);
}

}  // namespace candela
