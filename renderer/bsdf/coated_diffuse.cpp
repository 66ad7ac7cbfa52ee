#include "renderer/bsdf/coated_diffuse.h"

#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/mirror.h"
#include "renderer/bsdf/specular_mixture.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

float coat_probability(const Bsdf& bsdf, float cos_o) {
  return specular_probability(coat_reflectance(bsdf, cos_o),
                              average(coated_diffuse_albedo(bsdf, cos_o)));
}

// Of the lobes that are not delta lobes, with the probability of the coat's.
BsdfEvaluation evaluate(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi, float p_coat) {
  if (!(wi.z > 0)) return {};
  const CoatTable& coat = *bsdf.coat;
  const float through = coat.transmittance(wo.z, mean_coat_width(bsdf)) *
                        coat.transmittance(wi.z, mean_coat_width(bsdf));
  const Rgb diffuse = bsdf.diffuse * (through * wi.z * inverse_pi);
  if (has_smooth_coat(bsdf)) return {diffuse, (1 - p_coat) * cosine_hemisphere_pdf(wi.z)};
  const MicrofacetReflection reflection =
      reflect_microfacets(GeometryTerm::Smith, widths_of(bsdf), wo, wi);
  return {diffuse + coat_reflectance(bsdf, reflection.cos_half) * reflection.value,
          specular_mixture_pdf(p_coat, reflection.pdf, wi.z)};
}

}  // namespace

Rgb coated_reflectance(const CoatTable& coat, float alpha, const Rgb& kd, int bounces) {
  const Rgb again = kd * coat.internal_reflectance(alpha);
  Rgb cut{0};
  if (bounces > 0) {
    cut = again;
    for (int i = 1; i < bounces; ++i) cut *= again;
  }
  // Where eta is so high and absorption so low that float sees no way out, there is none.
  const Rgb trapped = glm::max(Rgb{1} - again, Rgb{1e-6f});
  return kd * (Rgb{1} - cut) / (trapped * square(coat.eta()));
}

Rgb coated_diffuse_albedo(const Bsdf& bsdf, float cos_o) {
  return bsdf.diffuse * (bsdf.coat->transmittance(cos_o, mean_coat_width(bsdf)) *
                         bsdf.coat->mean_transmittance(mean_coat_width(bsdf)));
}

BsdfEvaluation evaluate_coated_diffuse(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  return evaluate(bsdf, wo, wi, coat_probability(bsdf, wo.z));
}

BsdfSample sample_coated_diffuse(const Bsdf& bsdf, const Vec3f& wo, float lobe, Vec2f direction) {
  const float p_coat = coat_probability(bsdf, wo.z);
  if (has_smooth_coat(bsdf) && lobe < p_coat)
    return mirror_sample(wo, Rgb{coat_reflectance(bsdf, wo.z) / p_coat});
  const Vec3f wi = has_smooth_coat(bsdf)
                       ? square_to_cosine_hemisphere(direction)
                       : sample_specular_mixture(p_coat, widths_of(bsdf), wo, lobe, direction);
  return to_sample(wi, evaluate(bsdf, wo, wi, p_coat));
}

}  // namespace candela
