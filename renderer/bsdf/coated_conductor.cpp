#include "renderer/bsdf/coated_conductor.h"

#include "renderer/bsdf/albedo.h"
#include "renderer/bsdf/coat.h"
#include "renderer/bsdf/coated_metal_table.h"
#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/mirror.h"
#include "renderer/bsdf/specular_mixture.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

// Snell: eta^2 cos^2 within the coat is so much more than cos^2 outside. 0 where nothing bends, so
// that what comes in edge-on goes on edge-on.
float bend_of(float eta) {
  return (eta - 1) * (eta + 1);
}

// Within the coat, of a direction above it whose cosine is `cos_o`; still upwards.
float cosine_within(const Bsdf& bsdf, float cos_o) {
  const float eta = bsdf.coat->eta();
  return std::sqrt(bend_of(eta) + square(cos_o)) / eta;
}
Vec3f refracted(const Bsdf& bsdf, const Vec3f& w) {
  const float eta = bsdf.coat->eta();
  return {w.x / eta, w.y / eta, cosine_within(bsdf, w.z)};
}

// Of all bounces between two smooth layers, without the coat's own reflection.
Rgb smooth_metal_albedo(const Bsdf& bsdf, float cos_o) {
  const float through = bsdf.coat->transmittance(cos_o, 0);
  const float f = coat_reflectance(bsdf, cos_o);
  if (!(f < 1)) return Rgb{0};
  const Rgb metal = fresnel_conductor(cosine_within(bsdf, cos_o), bsdf.eta, bsdf.k);
  const float left = through / (1 - f);  // of one crossing's absorption
  const Rgb again = metal * (f * square(left));
  const Rgb cut = left_after(bsdf.metal_bounces, again);
  return metal * square(through) * (Rgb{1} - cut) / glm::max(Rgb{1} - again, Rgb{1e-6f});
}

// What comes out from below where not both are smooth; of one bounce where there is no table.
Rgb metal_albedo(const Bsdf& bsdf, float cos_o) {
  if (bsdf.metal) return bsdf.metal->albedo(cos_o);
  return fresnel_conductor(cosine_within(bsdf, cos_o), bsdf.eta, bsdf.k) *
         square(bsdf.coat->transmittance(cos_o, mean_coat_width(bsdf)));
}

float coat_probability(const Bsdf& bsdf, float cos_o) {
  return specular_probability(coat_reflectance(bsdf, cos_o), average(metal_albedo(bsdf, cos_o)));
}

BsdfEvaluation evaluate(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi, float p_coat) {
  if (!(wi.z > 0)) return {};
  const BsdfEvaluation metal = evaluate_coated_metal(bsdf, wo, wi);
  if (has_smooth_coat(bsdf)) return {metal.value, (1 - p_coat) * metal.pdf};
  const MicrofacetReflection reflection =
      reflect_microfacets(GeometryTerm::Smith, widths_of(bsdf), wo, wi);
  return {metal.value + coat_reflectance(bsdf, reflection.cos_half) * reflection.value,
          p_coat * reflection.pdf + (1 - p_coat) * metal.pdf};
}

}  // namespace

BsdfEvaluation evaluate_coated_metal(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  const CoatTable& coat = *bsdf.coat;
  const Vec3f o = refracted(bsdf, wo);
  const Vec3f i = refracted(bsdf, wi);
  const MicrofacetReflection reflection =
      reflect_microfacets(GeometryTerm::Smith, bsdf.metal_widths, o, i);
  // Solid angles within and without: cos' dw' eta^2 = cos dw.
  const float solid_angles = wi.z / (square(coat.eta()) * i.z);
  const float alpha = mean_coat_width(bsdf);
  const float through = coat.transmittance(wo.z, alpha) * coat.transmittance(wi.z, alpha);
  Rgb value = fresnel_conductor(reflection.cos_half, bsdf.eta, bsdf.k) *
              (through * reflection.value * solid_angles);
  if (bsdf.metal) value *= bsdf.metal->scale(wo.z) * bsdf.metal->scale(wi.z);
  return {value, reflection.pdf * solid_angles};
}

Vec3f sample_coated_metal(const Bsdf& bsdf, const Vec3f& wo, Vec2f direction) {
  const Vec3f i = sample_ggx_reflection(refracted(bsdf, wo), bsdf.metal_widths, direction);
  if (!(i.z > 0)) return Vec3f(0);
  const float eta = bsdf.coat->eta();
  const Vec2f across(eta * i.x, eta * i.y);
  const float cos2 = 1 - dot(across, across);
  if (!(cos2 > 0)) return Vec3f(0);
  return {across.x, across.y, std::sqrt(cos2)};
}

Rgb coated_conductor_albedo(const Bsdf& bsdf, float cos_o) {
  const Rgb at_angle{coat_reflectance(bsdf, cos_o)};
  if (bsdf.is_smooth) return at_angle + smooth_metal_albedo(bsdf, cos_o);
  const Rgb below = metal_albedo(bsdf, cos_o);
  if (has_smooth_coat(bsdf)) return at_angle + below;
  const float a = mean_coat_width(bsdf);
  return below + rough_reflectance(Rgb{normal_reflectance(bsdf.coat->eta())}, at_angle, a) *
                     microfacet_albedo(GeometryTerm::Smith, a, cos_o);
}

BsdfEvaluation evaluate_coated_conductor(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi) {
  if (bsdf.is_smooth) return {};
  return evaluate(bsdf, wo, wi, coat_probability(bsdf, wo.z));
}

BsdfSample sample_coated_conductor(const Bsdf& bsdf, const Vec3f& wo, float lobe, Vec2f direction) {
  if (bsdf.is_smooth) return mirror_sample(wo, coated_conductor_albedo(bsdf, wo.z));
  const float p_coat = coat_probability(bsdf, wo.z);
  const bool picks_coat = lobe < p_coat;
  if (picks_coat && has_smooth_coat(bsdf))
    return mirror_sample(wo, Rgb{coat_reflectance(bsdf, wo.z) / p_coat});
  const Vec3f wi = picks_coat ? sample_ggx_reflection(wo, widths_of(bsdf), direction)
                              : sample_coated_metal(bsdf, wo, direction);
  return to_sample(wi, evaluate(bsdf, wo, wi, p_coat));
}

}  // namespace candela
