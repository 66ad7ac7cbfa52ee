// BSDFs and directions that the tests of this folder go through.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/coated_conductor.h"
#include "renderer/bsdf/coated_diffuse.h"
#include "renderer/bsdf/coated_metal_table.h"
#include "renderer/sampling/sobol.h"

namespace candela::tests {

struct BsdfCase {
  std::string name;
  Bsdf bsdf;
};

inline Bsdf cook_torrance(float alpha, Rgb kd, Rgb ks, Rgb f0, GeometryTerm geometry) {
  return {.model = BsdfModel::CookTorrance,
          .geometry = geometry,
          .alpha = alpha,
          .diffuse = kd,
          .specular = ks,
          .f0 = f0};
}
// With the light of multiple bounces.
inline Bsdf compensated(float alpha, Rgb kd, Rgb ks, Rgb f0) {
  Bsdf bsdf = cook_torrance(alpha, kd, ks, f0, GeometryTerm::Smith);
  bsdf.model = BsdfModel::CompensatedCookTorrance;
  return bsdf;
}
inline Bsdf lab(float alpha, Rgb kd, Rgb ks) {
  return {.model = BsdfModel::Lab, .alpha = alpha, .diffuse = kd, .specular = ks};
}
inline Bsdf conductor(float alpha) {
  return {.model = BsdfModel::Conductor,
          .is_smooth = alpha == 0,
          .alpha = alpha,
          .eta = {0.2f, 0.92f, 1.1f},
          .k = {3.9f, 2.45f, 2.14f}};
}
inline Bsdf dielectric(float alpha, float eta, Rgb transmittance = Rgb{1}) {
  return {.model = BsdfModel::Dielectric,
          .is_smooth = alpha == 0,
          .alpha = alpha,
          .eta = Rgb{eta},
          .transmittance = transmittance};
}

inline Bsdf anisotropic_conductor(float along, float across) {
  Bsdf bsdf = conductor(along);
  bsdf.model = BsdfModel::AnisotropicConductor;
  bsdf.alpha_across = across;
  return bsdf;
}
inline Bsdf anisotropic_dielectric(float along, float across, float eta) {
  Bsdf bsdf = dielectric(along, eta);
  bsdf.model = BsdfModel::AnisotropicDielectric;
  bsdf.alpha_across = across;
  return bsdf;
}
inline Bsdf sheet(Rgb reflectance, Rgb transmittance) {
  return {.model = BsdfModel::DiffuseTransmission,
          .diffuse = reflectance,
          .eta = Rgb{1},
          .transmittance = transmittance};
}
// Rough coats alone: smooth ones have a delta lobe beside the other.
inline Bsdf coated_diffuse(float along, float across, Rgb kd) {
  static const CoatTable table(1.5f, 0.01f, -1);
  return {.model = BsdfModel::CoatedDiffuse,
          .alpha = along,
          .diffuse = coated_reflectance(table, std::sqrt(along * across), kd, 0),
          .alpha_across = across,
          .coat = &table};
}

// Rough coats over rough metal.
inline Bsdf coated_conductor(float coat_alpha, float metal_alpha) {
  static const CoatTable table(1.5f, 0.01f, -1);
  static std::map<std::pair<float, float>, std::unique_ptr<const CoatedMetalTable>> metals;
  const Bsdf metal = conductor(metal_alpha);
  Bsdf bsdf{.model = BsdfModel::CoatedConductor,
            .is_smooth = coat_alpha == 0 && metal_alpha == 0,
            .alpha = coat_alpha,
            .eta = metal.eta / 1.5f,
            .k = metal.k / 1.5f,
            .alpha_across = coat_alpha,
            .coat = &table,
            .metal_widths = Vec2f(coated_metal_width(1.5f, coat_alpha, metal_alpha))};
  if (bsdf.is_smooth) return bsdf;
  std::unique_ptr<const CoatedMetalTable>& known = metals[{coat_alpha, metal_alpha}];
  const CoatedMetalLayers layers{coat_alpha, metal_alpha};
  if (!known) known = std::make_unique<const CoatedMetalTable>(bsdf, layers);
  bsdf.metal = known.get();
  return bsdf;
}

// The models with densities.
inline std::vector<BsdfCase> rough_cases() {
  const Rgb steel{0.56f, 0.57f, 0.58f};
  Bsdf exact_dielectric =
      cook_torrance(0.2f, Rgb{0.5f}, Rgb{0.5f}, Rgb{0.04f}, GeometryTerm::Smith);
  exact_dielectric.fresnel = FresnelTerm::Dielectric;
  Bsdf exact_conductor = cook_torrance(0.1f, Rgb{0.1f}, Rgb{0.9f}, steel, GeometryTerm::Smith);
  exact_conductor.fresnel = FresnelTerm::Conductor;
  exact_conductor.eta = Rgb{2.9f};
  exact_conductor.k = Rgb{3.1f};
  return {
      {"diffuse", {.model = BsdfModel::Diffuse, .diffuse = {0.8f, 0.5f, 0.1f}}},
      {"cook_torrance_0.3",
       cook_torrance(0.3f, Rgb{0.2f}, Rgb{0.8f}, steel, GeometryTerm::SchlickGgx)},
      {"cook_torrance_0.05",
       cook_torrance(0.05f, Rgb{0.5f}, Rgb{0.5f}, Rgb{0.04f}, GeometryTerm::Smith)},
      {"cook_torrance_1", cook_torrance(1, Rgb{0}, Rgb{1}, Rgb{1}, GeometryTerm::SchlickGgx)},
      {"cook_torrance_dielectric", exact_dielectric},
      {"cook_torrance_conductor", exact_conductor},
      {"compensated_0.7", compensated(0.7f, Rgb{0}, Rgb{1}, Rgb{0.9f})},
      {"compensated_0.1", compensated(0.1f, Rgb{0.3f}, Rgb{0.7f}, steel)},
      {"lab_0.12", lab(0.12f, {0.7f, 0.6f, 0.5f}, Rgb{0.3f})},
      {"lab_1", lab(1, Rgb{0.9f}, Rgb{0.01f})},
      {"conductor_0.02", conductor(0.02f)},
      {"conductor_0.5", conductor(0.5f)},
      {"dielectric_0.1", dielectric(0.1f, 1.5f)},
      {"dielectric_0.1_inside", dielectric(0.1f, 1 / 1.5f)},
      {"dielectric_0.6_tinted", dielectric(0.6f, 1.33f, {0.9f, 0.5f, 0.3f})},
      {"dielectric_0.4_inside", dielectric(0.4f, 0.5f)},
      {"anisotropic_conductor", anisotropic_conductor(0.4f, 0.15f)},
      {"anisotropic_dielectric", anisotropic_dielectric(0.2f, 0.6f, 1.5f)},
      {"anisotropic_dielectric_inside", anisotropic_dielectric(0.8f, 0.4f, 1 / 1.5f)},
      {"sheet", sheet({0.2f, 0.5f, 0.1f}, {0.7f, 0.4f, 0.1f})},
      {"coated_conductor_0.2_0.3", coated_conductor(0.2f, 0.3f)},
      {"coated_conductor_0.5_0.05", coated_conductor(0.5f, 0.05f)},
      {"coated_diffuse_0.1", coated_diffuse(0.1f, 0.1f, {0.9f, 0.5f, 0.2f})},
      {"coated_diffuse_0.5_0.2", coated_diffuse(0.5f, 0.2f, {0.9f, 0.5f, 0.2f})},
  };
}

inline Vec3f direction_of(float cos_theta, float phi) {
  const float r = std::sqrt(std::max(0.0f, (1 - cos_theta) * (1 + cos_theta)));
  return {r * std::cos(phi), r * std::sin(phi), cos_theta};
}

}  // namespace candela::tests
