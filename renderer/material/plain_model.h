// Surfaces whose BSDF is of one of eight models, the same one whatever textures say: paths take
// their steps on such surfaces side by side (integrators/path/plain_lanes.h).
#pragma once

#include "renderer/material/bsdf_at.h"

namespace candela {

// GGX of one width, the same everywhere, and no mirror.
[[nodiscard]] inline bool has_one_width(const Material& material) {
  return !material.is_anisotropic && !material.roughness.texture &&
         material.roughness.constant >= smallest_ggx_width;
}

// From either side.
[[nodiscard]] inline bool is_smooth_glass(const Material& material) {
  const float alpha = material.roughness.constant;
  const float eta = material.eta.x;
  return !material.is_anisotropic && !material.roughness.texture &&
         is_smooth_dielectric(alpha, eta) && is_smooth_dielectric(alpha, 1 / eta);
}

[[nodiscard]] inline PlainModel plain_model_of(const Material& material) {
  switch (material.model) {
    case MaterialModel::Diffuse:
      return PlainModel::Diffuse;
    case MaterialModel::CookTorrance:
      if (material.energy_compensation || fresnel_term(material) != FresnelTerm::Schlick)
        return PlainModel::None;
      return material.geometry == GeometryModel::Smith ? PlainModel::SmithCookTorrance
                                                       : PlainModel::CookTorrance;
    case MaterialModel::Lab:
      return PlainModel::Lab;
    case MaterialModel::Conductor:
      return !material.energy_compensation && has_one_width(material) ? PlainModel::Conductor
                                                                      : PlainModel::None;
    case MaterialModel::CoatedDiffuse:
      return has_one_width(material) ? PlainModel::CoatedDiffuse : PlainModel::None;
    case MaterialModel::Mirror:
      return PlainModel::Mirror;
    case MaterialModel::Dielectric:
      return is_smooth_glass(material) ? PlainModel::Glass : PlainModel::None;
    case MaterialModel::ThinDielectric:
    case MaterialModel::DiffuseTransmission:
    case MaterialModel::CoatedConductor:
    case MaterialModel::Mix:
      return PlainModel::None;
  }
  return PlainModel::None;
}

}  // namespace candela
