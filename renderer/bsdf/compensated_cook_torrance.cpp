#include "renderer/bsdf/compensated_cook_torrance.h"

#include "renderer/bsdf/cook_torrance.h"
#include "renderer/bsdf/energy_loss.h"

namespace candela {
namespace {

// F_avg, the cosine-weighted mean 2 int F(c) c dc of the Fresnel term: in closed form for
// Schlick's, else by Gauss' rule, good to 1e-3 from an index of 1.05 to metals.
Rgb mean_fresnel(const Bsdf& bsdf) {
  if (bsdf.fresnel == FresnelTerm::Schlick) return bsdf.f0 + (Rgb{1} - bsdf.f0) / 21.0f;
  constexpr float cosines[] = {0.0694318f, 0.3300095f, 0.6699905f, 0.9305682f};
  constexpr float weights[] = {0.0241522f, 0.2152141f, 0.4369311f, 0.3237026f};
  Rgb sum{0};
  for (int i = 0; i < 4; ++i) sum += weights[i] * cook_torrance_fresnel(bsdf, cosines[i]);
  return sum;
}

// ks F_ms.
Rgb multiple_reflectance(const Bsdf& bsdf, float mean_loss) {
  const Rgb mean = mean_fresnel(bsdf);
  return bsdf.specular * mean * mean * (1 - mean_loss) / (Rgb{1} - mean * mean_loss);
}

}  // namespace

Rgb multiple_albedo(const Bsdf& bsdf, float cos_o) {
  const EnergyLossTable& table = energy_loss_table();
  const float a = ggx_width(bsdf.alpha);
  return multiple_reflectance(bsdf, table.mean_loss(a)) * table.loss(cos_o, a);
}

float compensated_specular_probability(const Bsdf& bsdf, float cos_o) {
  const EnergyLossTable& table = energy_loss_table();
  const float a = ggx_width(bsdf.alpha);
  const float loss = table.loss(cos_o, a);
  const Rgb multiple = multiple_reflectance(bsdf, table.mean_loss(a)) * loss;
  return specular_probability(average(bsdf.specular * fresnel_schlick(bsdf.f0, cos_o)) * (1 - loss),
                              average(bsdf.diffuse + multiple));
}

BsdfEvaluation evaluate_compensated(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  const EnergyLossTable& table = energy_loss_table();
  const float a = ggx_width(bsdf.alpha);
  const float mean_loss = table.mean_loss(a);
  const Rgb multiple = multiple_reflectance(bsdf, mean_loss) *
                       (table.loss(wo.z, a) * table.loss(wi.z, a) / mean_loss);
  const MicrofacetReflection reflection = reflect_microfacets(GeometryTerm::Smith, a, wo, wi);
  const Rgb fresnel = cook_torrance_fresnel(bsdf, reflection.cos_half);
  return {
      (bsdf.diffuse + multiple) * (wi.z * inverse_pi) + bsdf.specular * fresnel * reflection.value,
      specular_mixture_pdf(compensated_specular_probability(bsdf, wo.z), reflection.pdf, wi.z)};
}

BsdfSample sample_compensated(const Bsdf& bsdf, const Vec3f& wo, float lobe, Vec2f direction) {
  const Vec3f wi = sample_specular_mixture(compensated_specular_probability(bsdf, wo.z),
                                           ggx_width(bsdf.alpha), wo, lobe, direction);
  return to_sample(wi, evaluate_compensated(bsdf, wo, wi));
}

}  // namespace candela
