// One switch over the models for each question that integrators ask of a BSDF.
// Who knows which models there may be passes their set (loops over lanes of one model do): the
// others leave no code behind. A model outside of the set would be black, or taken for the set's
// only one; bsdf_at() never makes one (material/bsdf_at.h: bsdf_models).
#pragma once

#include <bit>

#include "renderer/bsdf/albedo.h"  // albedo_estimate
#include "renderer/bsdf/anisotropic.h"
#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/coated_conductor.h"
#include "renderer/bsdf/coated_diffuse.h"
#include "renderer/bsdf/compensated_cook_torrance.h"
#include "renderer/bsdf/conductor.h"
#include "renderer/bsdf/cook_torrance.h"
#include "renderer/bsdf/dielectric.h"
#include "renderer/bsdf/diffuse.h"
#include "renderer/bsdf/diffuse_transmission.h"
#include "renderer/bsdf/lab.h"
#include "renderer/bsdf/mirror.h"
#include "renderer/bsdf/thin_dielectric.h"

namespace candela {

template <ModelSet models>
constexpr bool has_model(BsdfModel model) {
  return (models & model_bit(model)) != 0;
}

// The model of a BSDF: a constant where the set has only one.
template <ModelSet models>
constexpr BsdfModel model_in(const Bsdf& bsdf) {
  if constexpr (std::has_single_bit(models))
    return static_cast<BsdfModel>(std::countr_zero(models));
  return bsdf.model;
}

// True where every lobe is a delta lobe: next-event estimation has nothing to add.
template <ModelSet models = all_models>
[[nodiscard]] inline bool is_only_delta(const Bsdf& bsdf) {
  const BsdfModel model = model_in<models>(bsdf);
  return model == BsdfModel::Mirror || model == BsdfModel::ThinDielectric || bsdf.is_smooth;
}

// Those whose sample_bsdf() reads the number that picks a lobe.
inline constexpr ModelSet models_with_lobes =
    all_models & ~(model_bit(BsdfModel::Diffuse) | model_bit(BsdfModel::Mirror) |
                   model_bit(BsdfModel::Conductor) | model_bit(BsdfModel::AnisotropicConductor));

// The sum of the non-delta lobes. wo.z > 0 always holds; wi is of unit length.
template <ModelSet models = all_models>
[[nodiscard]] inline BsdfEvaluation evaluate_bsdf(const Bsdf& bsdf, const Vec3f& wo,
                                                  const Vec3f& wi) {
  switch (model_in<models>(bsdf)) {
    case BsdfModel::Diffuse:
      if constexpr (has_model<models>(BsdfModel::Diffuse)) return evaluate_diffuse(bsdf, wo, wi);
      break;
    case BsdfModel::CookTorrance:
      if constexpr (has_model<models>(BsdfModel::CookTorrance))
        return evaluate_cook_torrance(bsdf, wo, wi);
      break;
    case BsdfModel::Lab:
      if constexpr (has_model<models>(BsdfModel::Lab)) return evaluate_lab(bsdf, wo, wi);
      break;
    case BsdfModel::Conductor:
      if constexpr (has_model<models>(BsdfModel::Conductor))
        return evaluate_conductor(bsdf, wo, wi);
      break;
    case BsdfModel::Dielectric:
      if constexpr (has_model<models>(BsdfModel::Dielectric))
        return evaluate_dielectric(bsdf, wo, wi);
      break;
    case BsdfModel::CompensatedCookTorrance:
      if constexpr (has_model<models>(BsdfModel::CompensatedCookTorrance))
        return evaluate_compensated(bsdf, wo, wi);
      break;
    case BsdfModel::DiffuseTransmission:
      if constexpr (has_model<models>(BsdfModel::DiffuseTransmission))
        return evaluate_diffuse_transmission(bsdf, wi);
      break;
    case BsdfModel::CoatedDiffuse:
      if constexpr (has_model<models>(BsdfModel::CoatedDiffuse))
        return evaluate_coated_diffuse(bsdf, wo, wi);
      break;
    case BsdfModel::CoatedConductor:
      if constexpr (has_model<models>(BsdfModel::CoatedConductor))
        return evaluate_coated_conductor(bsdf, wo, wi);
      break;
    case BsdfModel::AnisotropicConductor:
      if constexpr (has_model<models>(BsdfModel::AnisotropicConductor))
        return evaluate_anisotropic_conductor(bsdf, wo, wi);
      break;
    case BsdfModel::AnisotropicDielectric:
      if constexpr (has_model<models>(BsdfModel::AnisotropicDielectric))
        return evaluate_anisotropic_dielectric(bsdf, wo, wi);
      break;
    case BsdfModel::Mirror:
    case BsdfModel::ThinDielectric:
      break;
  }
  return {};
}

// `lobe` picks the lobe (read by models_with_lobes only), `direction` a direction in it, all in
// [0, 1).
template <ModelSet models = all_models>
[[nodiscard]] inline BsdfSample sample_bsdf(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                            Vec2f direction) {
  switch (model_in<models>(bsdf)) {
    case BsdfModel::Diffuse:
      if constexpr (has_model<models>(BsdfModel::Diffuse))
        return sample_diffuse(bsdf, wo, direction);
      break;
    case BsdfModel::CookTorrance:
      if constexpr (has_model<models>(BsdfModel::CookTorrance))
        return sample_cook_torrance(bsdf, wo, lobe, direction);
      break;
    case BsdfModel::Lab:
      if constexpr (has_model<models>(BsdfModel::Lab)) return sample_lab(bsdf, wo, lobe, direction);
      break;
    case BsdfModel::Mirror:
      if constexpr (has_model<models>(BsdfModel::Mirror)) return sample_mirror(bsdf, wo);
      break;
    case BsdfModel::Conductor:
      if constexpr (has_model<models>(BsdfModel::Conductor))
        return sample_conductor(bsdf, wo, direction);
      break;
    case BsdfModel::Dielectric:
      if constexpr (has_model<models>(BsdfModel::Dielectric))
        return sample_dielectric(bsdf, wo, lobe, direction);
      break;
    case BsdfModel::ThinDielectric:
      if constexpr (has_model<models>(BsdfModel::ThinDielectric))
        return sample_thin_dielectric(bsdf, wo, lobe);
      break;
    case BsdfModel::CompensatedCookTorrance:
      if constexpr (has_model<models>(BsdfModel::CompensatedCookTorrance))
        return sample_compensated(bsdf, wo, lobe, direction);
      break;
    case BsdfModel::DiffuseTransmission:
      if constexpr (has_model<models>(BsdfModel::DiffuseTransmission))
        return sample_diffuse_transmission(bsdf, lobe, direction);
      break;
    case BsdfModel::CoatedDiffuse:
      if constexpr (has_model<models>(BsdfModel::CoatedDiffuse))
        return sample_coated_diffuse(bsdf, wo, lobe, direction);
      break;
    case BsdfModel::CoatedConductor:
      if constexpr (has_model<models>(BsdfModel::CoatedConductor))
        return sample_coated_conductor(bsdf, wo, lobe, direction);
      break;
    case BsdfModel::AnisotropicConductor:
      if constexpr (has_model<models>(BsdfModel::AnisotropicConductor))
        return sample_anisotropic_conductor(bsdf, wo, direction);
      break;
    case BsdfModel::AnisotropicDielectric:
      if constexpr (has_model<models>(BsdfModel::AnisotropicDielectric))
        return sample_anisotropic_dielectric(bsdf, wo, lobe, direction);
      break;
  }
  return {};
}

}  // namespace candela
