#include "renderer/bsdf/coated_diffuse.h"

#include "renderer/bsdf/mirror.h"

namespace candela {
namespace {

// Beside the smooth coat, which is a delta lobe.
BsdfEvaluation evaluate_below_smooth_coat(const Bsdf& bsdf, const CoatedLobes& lobes, float p_coat,
                                          const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  const Rgb value =
      value_below_coat(lobes.diffuse, lobes.transmittance, bsdf.coat->transmittance(wi.z, 0), wi.z);
  return {value, (1 - p_coat) * cosine_hemisphere_pdf(wi.z)};
}

BsdfEvaluation evaluate_below_rough_coat(const Bsdf& bsdf, const CoatedLobes& lobes,
                                         const Vec3f& wo, const Vec3f& wi) {
  return evaluate_coated_lobes(lobes, wo, wi,
                               bsdf.coat->transmittance(wi.z, mean_coat_width(bsdf)));
}

}  // namespace

CoatedLobes coated_lobes_of(const Bsdf& bsdf, float cos_o) {
  return {bsdf.coat->eta(), widths_of(bsdf), bsdf.diffuse,
          bsdf.coat->transmittance(cos_o, mean_coat_width(bsdf)),
          bsdf.coat->mean_transmittance(mean_coat_width(bsdf))};
}

Rgb coated_reflectance(const CoatTable& coat, float alpha, const Rgb& kd, int bounces) {
  const Rgb again = kd * coat.internal_reflectance(alpha);
  const Rgb cut = left_after(bounces, again);
  // Where eta is so high and absorption so low that float sees no way out, there is none.
  const Rgb trapped = glm::max(Rgb{1} - again, Rgb{1e-6f});
  return kd * (Rgb{1} - cut) / (trapped * square(coat.eta()));
}

Rgb coated_diffuse_albedo(const Bsdf& bsdf, float cos_o) {
  const CoatedLobes lobes = coated_lobes_of(bsdf, cos_o);
  return albedo_below_coat(lobes.diffuse, lobes.transmittance, lobes.mean_transmittance);
}

BsdfEvaluation evaluate_coated_diffuse(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  const CoatedLobes lobes = coated_lobes_of(bsdf, wo.z);
  if (has_smooth_coat(bsdf))
    return evaluate_below_smooth_coat(bsdf, lobes, coat_probability(lobes, wo.z), wi);
  return evaluate_below_rough_coat(bsdf, lobes, wo, wi);
}

BsdfSample sample_coated_diffuse(const Bsdf& bsdf, const Vec3f& wo, float lobe, Vec2f direction) {
  const CoatedLobes lobes = coated_lobes_of(bsdf, wo.z);
  if (!has_smooth_coat(bsdf)) {
    const Vec3f wi = sample_coated_lobes(lobes, wo, lobe, direction);
    return to_sample(wi, evaluate_below_rough_coat(bsdf, lobes, wo, wi));
  }
  const float p_coat = coat_probability(lobes, wo.z);
  if (lobe < p_coat) return mirror_sample(wo, Rgb{coat_reflectance(bsdf, wo.z) / p_coat});
  const Vec3f wi = square_to_cosine_hemisphere(direction);
  return to_sample(wi, evaluate_below_smooth_coat(bsdf, lobes, p_coat, wi));
}

}  // namespace candela
