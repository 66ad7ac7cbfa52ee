// Material + textures + place -> Bsdf: the parameters of one model at one point.
//
// What textures say is clamped to [0, 1] (NaN is 0), so that no picture can break the energy
// balance; constants were validated. Opacity is not handled here: it decides whether there is a
// hit.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/coated_conductor.h"
#include "renderer/bsdf/coated_diffuse.h"
#include "renderer/bsdf/dielectric.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/lab.h"
#include "renderer/material/material.h"
#include "renderer/math/reflectance.h"

namespace candela {

[[nodiscard]] inline Rgb colour_at(const ColourParameter& parameter, const TextureStore& textures,
                                   const TexturePoint& at) {
  if (!parameter.texture) return parameter.constant;
  return clamp_unit(Rgb(textures.lookup_at(parameter.texture, at)));
}
[[nodiscard]] inline float scalar_at(const ScalarParameter& parameter, const TextureStore& textures,
                                     const TexturePoint& at) {
  if (!parameter.texture) return parameter.constant;
  return clamp_unit(textures.lookup_at(parameter.texture, at)[parameter.channel]);
}

// Which models bsdf_at() can make of a material.
[[nodiscard]] inline ModelSet bsdf_models(const Material& material) {
  switch (material.model) {
    case MaterialModel::Diffuse:
      return model_bit(BsdfModel::Diffuse);
    case MaterialModel::CookTorrance:
      return model_bit(material.energy_compensation ? BsdfModel::CompensatedCookTorrance
                                                    : BsdfModel::CookTorrance);
    case MaterialModel::Lab:
      return model_bit(BsdfModel::Lab);
    case MaterialModel::Mirror:
      return model_bit(BsdfModel::Mirror);
    case MaterialModel::Conductor: {
      const ModelSet plain = model_bit(BsdfModel::Conductor);
      if (material.is_anisotropic) return plain | model_bit(BsdfModel::AnisotropicConductor);
      if (!material.energy_compensation) return plain;
      return plain | model_bit(BsdfModel::CompensatedCookTorrance);
    }
    case MaterialModel::Dielectric: {
      const ModelSet plain = model_bit(BsdfModel::Dielectric);
      if (material.is_anisotropic) return plain | model_bit(BsdfModel::AnisotropicDielectric);
      return plain;
    }
    case MaterialModel::ThinDielectric:
      return model_bit(BsdfModel::ThinDielectric);
    case MaterialModel::DiffuseTransmission:
      return model_bit(BsdfModel::DiffuseTransmission);
    case MaterialModel::CoatedDiffuse:
      return model_bit(BsdfModel::CoatedDiffuse);
    case MaterialModel::CoatedConductor:
      return model_bit(BsdfModel::CoatedConductor);
    case MaterialModel::Mix:
      return 0;
  }
  return 0;
}

[[nodiscard]] inline FresnelTerm fresnel_term(const Material& material) {
  if (material.fresnel == FresnelModel::Schlick) return FresnelTerm::Schlick;
  return material.fresnel_is_conductor ? FresnelTerm::Conductor : FresnelTerm::Dielectric;
}

// kd + ks <= 1 a channel [REPORT 2.2]: where maps ask for more, both give way in proportion.
inline void limit_reflectance(Rgb& diffuse, Rgb& specular) {
  Rgb sum = glm::max(diffuse + specular, Rgb{1});
  diffuse /= sum;
  specular /= sum;
}

// With a given colour of the diffuse lobe, and before limit_reflectance().
[[nodiscard]] inline Bsdf unlimited_cook_torrance_at(const Material& material,
                                                     const TextureStore& textures,
                                                     const TexturePoint& at, const Rgb& diffuse) {
  return {.model = material.energy_compensation ? BsdfModel::CompensatedCookTorrance
                                                : BsdfModel::CookTorrance,
          .fresnel = fresnel_term(material),
          .geometry = material.geometry == GeometryModel::Smith ? GeometryTerm::Smith
                                                                : GeometryTerm::SchlickGgx,
          .alpha = ggx_width(scalar_at(material.roughness, textures, at)),
          .diffuse = diffuse,
          .specular = colour_at(material.specular, textures, at),
          .f0 = material.f0,
          .eta = material.eta,
          .k = material.k};
}
[[nodiscard]] inline Bsdf cook_torrance_at(const Material& material, const TextureStore& textures,
                                           const TexturePoint& at) {
  Bsdf bsdf =
      unlimited_cook_torrance_at(material, textures, at, colour_at(material.diffuse, textures, at));
  limit_reflectance(bsdf.diffuse, bsdf.specular);
  return bsdf;
}

// With a given colour of the diffuse lobe.
[[nodiscard]] inline Bsdf lab_at(const Material& material, const TextureStore& textures,
                                 const TexturePoint& at, const Rgb& diffuse) {
  Bsdf bsdf{.model = BsdfModel::Lab,
            .alpha = material.roughness.constant,
            .diffuse = diffuse,
            .specular = material.specular.constant};
  if (material.specular.texture) {
    const Vec4f specular = textures.lookup_at(material.specular.texture, at);
    bsdf.specular = clamp_unit(Rgb(specular));
    bsdf.alpha = lab_width(clamp_unit(specular.w) * 256);
  }
  return bsdf;
}

struct MetalIndex {
  Rgb eta, k;
};

// eta and k, or those with eta = 1 that give a textured reflectance at normal incidence.
[[nodiscard]] inline MetalIndex metal_index_at(const Material& material,
                                               const TextureStore& textures,
                                               const TexturePoint& at) {
  if (!material.specular.texture) return {material.eta, material.k};
  constexpr auto largest = static_cast<float>(largest_metal_reflectance);
  Rgb r = glm::min(colour_at(material.specular, textures, at), Rgb{largest});
  return {Rgb{1}, extinction_of_reflectance(r)};
}

[[nodiscard]] inline Bsdf conductor_at(const Material& material, const TextureStore& textures,
                                       const TexturePoint& at) {
  const float alpha = scalar_at(material.roughness, textures, at);
  if (material.energy_compensation && alpha >= smallest_ggx_width)
    return {.model = BsdfModel::CompensatedCookTorrance,
            .fresnel = FresnelTerm::Conductor,
            .geometry = GeometryTerm::Smith,
            .alpha = ggx_width(alpha),
            .specular = Rgb{1},
            .f0 = material.f0,
            .eta = material.eta,
            .k = material.k};
  MetalIndex metal = metal_index_at(material, textures, at);
  return {.model = BsdfModel::Conductor,
          .is_smooth = !(alpha >= smallest_ggx_width),
          .alpha = ggx_width(alpha),
          .eta = metal.eta,
          .k = metal.k};
}

// As they are given: of two the smaller one counts as at least the smallest (ggx_width()) where the
// larger one is rough.
[[nodiscard]] inline Vec2f widths_at(const Material& material, const TextureStore& textures,
                                     const TexturePoint& at) {
  const float along = scalar_at(material.roughness, textures, at);
  if (!material.is_anisotropic) return {along, along};
  return {along, scalar_at(material.roughness_across, textures, at)};
}

[[nodiscard]] inline Bsdf anisotropic_conductor_at(const Material& material,
                                                   const TextureStore& textures,
                                                   const TexturePoint& at) {
  const Vec2f widths = widths_at(material, textures, at);
  const bool is_smooth = !(std::max(widths.x, widths.y) >= smallest_ggx_width);
  MetalIndex metal = metal_index_at(material, textures, at);
  return {.model = is_smooth ? BsdfModel::Conductor : BsdfModel::AnisotropicConductor,
          .is_smooth = is_smooth,
          .alpha = ggx_width(widths.x),
          .eta = metal.eta,
          .k = metal.k,
          .alpha_across = ggx_width(widths.y)};
}

[[nodiscard]] inline Bsdf anisotropic_dielectric_at(const Material& material,
                                                    const TextureStore& textures,
                                                    const TexturePoint& at, bool is_front_side) {
  const float eta = is_front_side ? material.eta.x : 1 / material.eta.x;
  const Vec2f widths = widths_at(material, textures, at);
  const bool is_smooth = is_smooth_dielectric(std::max(widths.x, widths.y), eta);
  // What float can tell from smooth (is_smooth_dielectric()).
  const float least =
      std::max(smallest_ggx_width, smallest_refraction_spread * std::max(1.0f, eta) /
                                       std::max(smallest_refraction_spread, std::abs(eta - 1)));
  return {.model = is_smooth ? BsdfModel::Dielectric : BsdfModel::AnisotropicDielectric,
          .is_smooth = is_smooth,
          .alpha = ggx_width(std::max(widths.x, least)),
          .eta = Rgb{eta},
          .transmittance = material.transmittance,
          .alpha_across = ggx_width(std::max(widths.y, least))};
}

[[nodiscard]] inline Bsdf sheet_at(const Material& material, const TextureStore& textures,
                                   const TexturePoint& at) {
  Bsdf bsdf{.model = BsdfModel::DiffuseTransmission,
            .diffuse = colour_at(material.diffuse, textures, at),
            .eta = Rgb{1},
            .transmittance = colour_at(material.specular, textures, at)};
  limit_reflectance(bsdf.diffuse, bsdf.transmittance);
  return bsdf;
}

// Coats that float cannot tell from smooth are smooth: their width is 0.
[[nodiscard]] inline Vec2f coat_widths_at(const Material& material, const TextureStore& textures,
                                          const TexturePoint& at) {
  const Vec2f widths = widths_at(material, textures, at);
  if (!(std::max(widths.x, widths.y) >= smallest_ggx_width)) return {0, 0};
  return ggx_width(widths);
}

[[nodiscard]] inline Bsdf coated_diffuse_at(const Material& material, const TextureStore& textures,
                                            const TexturePoint& at) {
  const Vec2f widths = coat_widths_at(material, textures, at);
  return {.model = BsdfModel::CoatedDiffuse,
          .alpha = widths.x,
          .diffuse =
              coated_reflectance(*material.coat, std::sqrt(widths.x * widths.y),
                                 colour_at(material.diffuse, textures, at), material.coat_bounces),
          .alpha_across = widths.y,
          .coat = material.coat.get()};
}

[[nodiscard]] inline Bsdf coated_conductor_at(const Material& material,
                                              const TextureStore& textures,
                                              const TexturePoint& at) {
  const Vec2f coat = coat_widths_at(material, textures, at);
  const Vec2f metal{scalar_at(material.metal_roughness, textures, at),
                    scalar_at(material.metal_roughness_across, textures, at)};
  const float eta = material.coat->eta();
  const Vec2f widths{coated_metal_width(eta, coat.x, metal.x),
                     coated_metal_width(eta, coat.y, metal.y)};
  return {.model = BsdfModel::CoatedConductor,
          .is_smooth = coat.x == 0 && !(std::max(widths.x, widths.y) >= smallest_ggx_width),
          .alpha = coat.x,
          .eta = material.eta,
          .k = material.k,
          .alpha_across = coat.y,
          .coat = material.coat.get(),
          .metal = material.metal.get(),
          .metal_widths = ggx_width(widths),
          .metal_bounces = material.coat_bounces};
}

[[nodiscard]] inline Bsdf dielectric_at(const Material& material, const TextureStore& textures,
                                        const TexturePoint& at, bool is_front_side) {
  const float eta = is_front_side ? material.eta.x : 1 / material.eta.x;
  const float alpha = scalar_at(material.roughness, textures, at);
  return {.model = BsdfModel::Dielectric,
          .is_smooth = is_smooth_dielectric(alpha, eta),
          .alpha = ggx_width(alpha),
          .eta = Rgb{eta},
          .transmittance = material.transmittance};
}

// `is_front_side`: wo lies on the side that the geometric normal (of the file's winding) points to,
// the outside of glass.
[[nodiscard]] inline Bsdf bsdf_at(const Material& material, const TextureStore& textures,
                                  const TexturePoint& at, bool is_front_side) {
  switch (material.model) {
    case MaterialModel::Diffuse:
      return {.model = BsdfModel::Diffuse, .diffuse = colour_at(material.diffuse, textures, at)};
    case MaterialModel::CookTorrance:
      return cook_torrance_at(material, textures, at);
    case MaterialModel::Lab:
      return lab_at(material, textures, at, colour_at(material.diffuse, textures, at));
    case MaterialModel::Mirror:
      return {.model = BsdfModel::Mirror, .diffuse = colour_at(material.diffuse, textures, at)};
    case MaterialModel::Conductor:
      return material.is_anisotropic ? anisotropic_conductor_at(material, textures, at)
                                     : conductor_at(material, textures, at);
    case MaterialModel::Dielectric:
      return material.is_anisotropic
                 ? anisotropic_dielectric_at(material, textures, at, is_front_side)
                 : dielectric_at(material, textures, at, is_front_side);
    case MaterialModel::ThinDielectric:
      return {.model = BsdfModel::ThinDielectric,
              .eta = material.eta,
              .transmittance = material.transmittance};
    case MaterialModel::DiffuseTransmission:
      return sheet_at(material, textures, at);
    case MaterialModel::CoatedDiffuse:
      return coated_diffuse_at(material, textures, at);
    case MaterialModel::CoatedConductor:
      return coated_conductor_at(material, textures, at);
    case MaterialModel::Mix:  // its parts have bsdfs
      break;
  }
  return {};
}

}  // namespace candela
