// The diffuse lobe of a surface, by which it lights and is lit by what others' paths met
// (path_reuse.h): all of Lambert's surface, and what glossy ones have below their highlights.
#pragma once

#include "renderer/bsdf/coated_diffuse.h"
#include "renderer/bsdf/cook_torrance.h"
#include "renderer/bsdf/lab.h"
#include "renderer/material/material.h"

namespace candela {

inline constexpr ModelSet models_with_shared_lobes =
    model_bit(BsdfModel::Diffuse) | model_bit(BsdfModel::CookTorrance) | model_bit(BsdfModel::Lab) |
    model_bit(BsdfModel::CoatedDiffuse);

// Which share of light crosses the surface to the lobe below, from or to a direction of this cosine
// with the shading normal: even + shaped * shape(cosine).
enum class LobeShape : std::uint8_t {
  Even,
  Schlick,  // schlick_weight()
  Coat      // CoatTable::transmittance()
};
struct SurfaceCrossing {
  LobeShape shape = LobeShape::Even;
  Rgb even{1};
  Rgb shaped{0};
  const CoatTable* coat = nullptr;
  float alpha = 0;

  [[nodiscard]] Rgb at(float cosine) const {
    switch (shape) {
      case LobeShape::Schlick:
        return even + shaped * schlick_weight(cosine);
      case LobeShape::Coat:
        return even + shaped * coat->transmittance(cosine, alpha);
      case LobeShape::Even:
        break;
    }
    return even;
  }
};

// f |cos_i| = albedo crossing(cos_i) crossing(cos_o) |cos_i| / pi, seen from one direction o.
struct SharedLobe {
  Rgb albedo{0};
  SurfaceCrossing crossing;
  Rgb crossing_o{1};
  float others = 0;  // the probability that directions are drawn from other lobes

  // With which directions are drawn from this one, by their cosine.
  [[nodiscard]] float probability() const { return 1 - others; }
  [[nodiscard]] bool is_never_drawn() const {
    return !(others < 1) || is_black(albedo * crossing_o);
  }

  // f |cos_i| / crossing(cos_o).
  [[nodiscard]] Rgb value_below(float cos_i) const {
    return albedo * crossing.at(cos_i) * (cos_i * inverse_pi);
  }
};

[[nodiscard]] inline SharedLobe shared_lobe_of(const Bsdf& bsdf, float cos_o) {
  SharedLobe lobe;
  lobe.albedo = bsdf.diffuse;
  switch (bsdf.model) {
    case BsdfModel::Diffuse:
      break;
    case BsdfModel::CookTorrance:
      lobe.others = cook_torrance_specular_probability(bsdf, cos_o);
      break;
    case BsdfModel::Lab: {
      const Rgb straight = lab_fresnel(bsdf.specular, 1), grazing = lab_fresnel(bsdf.specular, 0);
      lobe.crossing = {
          .shape = LobeShape::Schlick, .even = Rgb(1) - straight, .shaped = straight - grazing};
      lobe.others = lab_specular_probability(bsdf, cos_o);
      break;
    }
    case BsdfModel::CoatedDiffuse:
      lobe.crossing = {.shape = LobeShape::Coat,
                       .even = Rgb(0),
                       .shaped = Rgb(1),
                       .coat = bsdf.coat,
                       .alpha = mean_coat_width(bsdf)};
      lobe.others = coat_probability(coated_lobes_of(bsdf, cos_o), cos_o);
      break;
    case BsdfModel::Mirror:
    case BsdfModel::Conductor:
    case BsdfModel::Dielectric:
    case BsdfModel::ThinDielectric:
    case BsdfModel::CompensatedCookTorrance:
    case BsdfModel::DiffuseTransmission:
    case BsdfModel::CoatedConductor:
    case BsdfModel::AnisotropicConductor:
    case BsdfModel::AnisotropicDielectric:
      lobe.others = 1;
      break;
  }
  lobe.crossing_o = lobe.crossing.at(cos_o);
  return lobe;
}

}  // namespace candela
