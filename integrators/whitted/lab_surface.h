// Any material as lab3's own shading sees it: (kd, ks, exponent, alpha) (docs/cli.md, "Whitted and
// raster").
#pragma once

#include "renderer/material/bsdf_at.h"

namespace candela {

struct LabSurface {
  Rgb kd{0};
  Rgb ks{0};
  float exponent = 1;
  Rgb mirror{0};  // weight of the mirror direction
  Rgb behind{0};  // weight of what comes straight from behind
  float alpha = 1;
};

// The inverse of a = sqrt(2 / (n + 2)) [Walter07, section 5.2].
[[nodiscard]] inline float lab_exponent(float ggx_width) {
  return std::max(0.0f, 2 / square(ggx_width) - 2);
}

[[nodiscard]] inline bool is_glass(const Material& material) {
  return material.model == MaterialModel::Dielectric ||
         material.model == MaterialModel::ThinDielectric;
}

// As it is stored: no thresholds, no dice. A mixture's is its own, whichever part is met.
[[nodiscard]] inline float lab_opacity_at(const Material& worn, const TextureStore& textures,
                                          const TexturePoint& at) {
  return clamp_unit(scalar_at(worn.opacity, textures, at));
}

// Coverage (a material that is no mixture is its own part): glass covers what it reflects.
[[nodiscard]] inline float lab_alpha_at(const Material& worn, const Material& part,
                                        const TextureStore& textures, const TexturePoint& at) {
  const float opacity = lab_opacity_at(worn, textures, at);
  return is_glass(part) ? opacity * normal_reflectance(part.eta.x) : opacity;
}

// lab3's own material, as it stands: mirrors get half of the highlight's colour.
[[nodiscard]] inline LabSurface lab_material_at(const Material& material,
                                                const TextureStore& textures,
                                                const TexturePoint& at) {
  LabSurface surface{.kd = colour_at(material.diffuse, textures, at),
                     .ks = material.specular.constant,
                     .exponent = material.shininess};
  if (material.specular.texture) {
    const Vec4f specular = textures.lookup_at(material.specular.texture, at);
    surface.ks = clamp_unit(Rgb(specular));
    surface.exponent = clamp_unit(specular.w) * 256;
  }
  surface.mirror = 0.5f * surface.ks;
  return surface;
}

// A highlight of the reflectance `f0` at normal incidence and of a GGX width.
[[nodiscard]] inline LabSurface glossy_surface(const Rgb& kd, const Rgb& f0, float ggx_width) {
  return {.kd = kd, .ks = f0, .exponent = lab_exponent(ggx_width), .mirror = 0.5f * f0};
}

// What is smooth mirrors all that it reflects, and has the narrowest highlight of the lab.
[[nodiscard]] inline LabSurface smooth_surface(const Rgb& reflectance) {
  return {.ks = reflectance, .exponent = 256, .mirror = reflectance};
}

// What glass does not reflect passes unbent.
[[nodiscard]] inline LabSurface glass_surface(const Material& material, const Bsdf& bsdf) {
  const bool is_smooth = bsdf.is_smooth || bsdf.model == BsdfModel::ThinDielectric;
  const float passing = 1 - normal_reflectance(material.eta.x);
  return {.ks = Rgb{1},
          .exponent = is_smooth ? 256.0f : lab_exponent(bsdf.alpha),
          .behind = passing * material.transmittance};
}

// All but the coverage.
[[nodiscard]] inline LabSurface uncovered_surface_at(const Material& material,
                                                     const TextureStore& textures,
                                                     const TexturePoint& at) {
  if (material.model == MaterialModel::Lab) return lab_material_at(material, textures, at);
  const Bsdf bsdf = bsdf_at(material, textures, at, true);
  switch (bsdf.model) {
    case BsdfModel::Diffuse:
    case BsdfModel::DiffuseTransmission:
    case BsdfModel::Lab:  // returned above
      return {.kd = bsdf.diffuse};
    case BsdfModel::CookTorrance:
    case BsdfModel::CompensatedCookTorrance:
      return glossy_surface(bsdf.diffuse, bsdf.specular * bsdf.f0, bsdf.alpha);
    case BsdfModel::Mirror:
      return smooth_surface(bsdf.diffuse);
    case BsdfModel::Conductor: {
      const Rgb f0 = normal_reflectance(bsdf.eta, bsdf.k);
      return bsdf.is_smooth ? smooth_surface(f0) : glossy_surface(Rgb{0}, f0, bsdf.alpha);
    }
    case BsdfModel::CoatedDiffuse: {
      const Rgb f0{normal_reflectance(bsdf.coat->eta())};
      return glossy_surface(coated_diffuse_albedo(bsdf, 1), f0, ggx_width(bsdf.alpha));
    }
    case BsdfModel::CoatedConductor: {
      const Rgb f0 = coated_conductor_albedo(bsdf, 1);
      return bsdf.is_smooth ? smooth_surface(f0)
                            : glossy_surface(Rgb{0}, f0, std::max(bsdf.alpha, bsdf.metal_widths.x));
    }
    case BsdfModel::AnisotropicConductor:
      return glossy_surface(Rgb{0}, normal_reflectance(bsdf.eta, bsdf.k), bsdf.alpha);
    case BsdfModel::AnisotropicDielectric:
    case BsdfModel::Dielectric:
    case BsdfModel::ThinDielectric:
      return glass_surface(material, bsdf);
  }
  return {};
}

[[nodiscard]] inline LabSurface lab_surface_at(const Material& worn, const Material& part,
                                               const TextureStore& textures,
                                               const TexturePoint& at) {
  const float opacity = lab_opacity_at(worn, textures, at);
  if (opacity == 0) return {.behind = Rgb{1}, .alpha = 0};  // nothing of it shows
  LabSurface surface = uncovered_surface_at(part, textures, at);
  surface.alpha = lab_alpha_at(worn, part, textures, at);
  surface.behind = Rgb{1 - opacity} + opacity * surface.behind;
  return surface;
}

}  // namespace candela
