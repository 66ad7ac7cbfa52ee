// Path guiding: directions from what was learned of the light at a surface, mixed with those of the
// BSDF [Mueller17; Vorba19]. Nothing at all in kernels without it.
#pragma once

#include <type_traits>

#include "integrators/guiding/guiding_field.h"
#include "integrators/path/feature_set.h"
#include "renderer/bsdf/dispatch.h"
#include "renderer/geometry/surface_point.h"

namespace candela {

struct NoGuide {};

// Of one surface point; with unknown targets its paths follow the BSDF alone.
struct LearnedGuide {
  TargetsSeen targets;
  float share = 0;  // of the paths that follow it, below 1

  // The density of a path's next direction: of what the BSDF never chooses 0, since such
  // directions of the guide are rejected.
  [[nodiscard]] float mixed_pdf(float bsdf_pdf, float guide_pdf) const {
    return bsdf_pdf > 0 ? bsdf_pdf + share * (guide_pdf - bsdf_pdf) : 0;
  }
};

template <FeatureSet F>
using Guide = std::conditional_t<F.guided, LearnedGuide, NoGuide>;

// Lobes that are too narrow to learn, and what is seen through glass, are left to the BSDF.
[[nodiscard]] inline bool is_guided(const Bsdf& bsdf) {
  constexpr float narrow = 0.1f;  // GGX width
  switch (bsdf.model) {
    case BsdfModel::Diffuse:
    case BsdfModel::DiffuseTransmission:
    case BsdfModel::CookTorrance:
    case BsdfModel::Lab:
    case BsdfModel::CoatedDiffuse:
      return true;
    case BsdfModel::Conductor:
    case BsdfModel::CompensatedCookTorrance:
      return !bsdf.is_smooth && bsdf.alpha >= narrow;
    case BsdfModel::AnisotropicConductor:
      return std::min(bsdf.alpha, bsdf.alpha_across) >= narrow;
    case BsdfModel::Mirror:
    case BsdfModel::Dielectric:
    case BsdfModel::ThinDielectric:
    case BsdfModel::CoatedConductor:
    case BsdfModel::AnisotropicDielectric:
      return false;
  }
  return false;
}

// `field` may be null.
template <FeatureSet F>
[[nodiscard]] inline Guide<F> guide_at([[maybe_unused]] const GuidingField* field,
                                       [[maybe_unused]] const SurfacePoint& point,
                                       [[maybe_unused]] const Bsdf& bsdf) {
  if constexpr (F.guided) {
    if (field == nullptr || !is_guided(bsdf)) return {};
    const TargetMixture* mixture = field->mixture_at(point.position, point.receiving_normal);
    if (mixture == nullptr || !(mixture->share > 0)) return {};
    return {{*mixture, point.position}, mixture->share};
  } else {
    return {};
  }
}

// The density of a path's next direction, which the BSDF has with `bsdf_pdf`.
template <FeatureSet F>
[[nodiscard]] inline float path_pdf([[maybe_unused]] const Guide<F>& guide,
                                    [[maybe_unused]] const Vec3f& wi, float bsdf_pdf) {
  if constexpr (F.guided) {
    if (guide.targets.is_known()) return guide.mixed_pdf(bsdf_pdf, guide.targets.pdf(wi));
  }
  return bsdf_pdf;
}

struct GuidedSample {
  BsdfSample sample;
  float density_ratio = 1;  // of the direction, to that by the BSDF alone
};

// A direction of the guide or of the BSDF, weighted by the density of both [Veach97, section
// 9.2.4]. `guide_choice`, `lobe`, `direction`: in [0, 1).
template <ModelSet models>
[[nodiscard]] inline GuidedSample sample_with_guide(const LearnedGuide& guide,
                                                    const SurfacePoint& point, const Bsdf& bsdf,
                                                    const Vec3f& wo_local, float guide_choice,
                                                    float lobe, Vec2f direction) {
  if (guide_choice < guide.share) {
    const GuidedDirection guided = guide.targets.sample(guide_choice / guide.share, direction);
    const Vec3f wi = point.shading.to_local(guided.wi);
    BsdfEvaluation f = evaluate_bsdf<models>(bsdf, wo_local, wi);
    const float pdf = guide.mixed_pdf(f.pdf, guided.pdf);
    if (!(pdf > 0)) return {};
    return {{.wi = wi, .weight = f.value / pdf, .pdf = pdf}, pdf / f.pdf};
  }
  BsdfSample sample = sample_bsdf<models>(bsdf, wo_local, lobe, direction);
  if (is_black(sample.weight)) return {};
  if (sample.is_delta) {
    sample.weight /= 1 - guide.share;
    return {sample, 1 - guide.share};
  }
  const float guide_pdf = guide.targets.pdf(point.shading.to_world(sample.wi));
  const float ratio = guide.mixed_pdf(sample.pdf, guide_pdf) / sample.pdf;
  sample.weight /= ratio;
  sample.pdf *= ratio;
  return {sample, ratio};
}

}  // namespace candela
