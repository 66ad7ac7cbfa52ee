// Materials at the ends of their parameters, as scenes name them, for the tests of this folder.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "renderer/material/bsdf_at.h"
#include "tests/bsdf/bsdf_cases.h"

namespace candela::test {

struct MaterialCase {
  std::string name;
  Bsdf bsdf;  // as bsdf_at() makes it: smooth where the width asks for it
};

inline constexpr float roughness_decades[] = {1, 0.1f, 0.01f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 0};
inline constexpr float refractive_indices[] = {1, 1.0000001f, 1.0001f, 1.5f, 1000};

inline std::vector<MaterialCase> conductor_cases(float roughness) {
  // A metal, absorption without and with much of it, and what total reflection leaves.
  constexpr float eta_k[][2] = {{0.2f, 3.9f}, {1, 0},    {1.0001f, 0}, {1.5f, 0},
                                {0.5f, 0},    {1000, 0}, {1, 100},     {1.5f, 100}};
  std::vector<MaterialCase> cases;
  for (const auto& [eta, k] : eta_k) {
    Material material;
    material.model = MaterialModel::Conductor;
    material.roughness.constant = roughness;
    material.eta = Rgb{eta};
    material.k = Rgb{k};
    cases.push_back({fmt::format("conductor eta {} k {} roughness {}", eta, k, roughness),
                     bsdf_at(material, {}, {}, true)});
  }
  return cases;
}

inline std::vector<MaterialCase> dielectric_cases(float roughness) {
  std::vector<MaterialCase> cases;
  for (const float ior : refractive_indices)
    for (const bool is_outside : {true, false}) {
      Material material;
      material.model = MaterialModel::Dielectric;
      material.roughness.constant = roughness;
      material.eta = Rgb{ior};
      cases.push_back({fmt::format("dielectric {} from {} roughness {}", ior,
                                   is_outside ? "outside" : "inside", roughness),
                       bsdf_at(material, {}, {}, is_outside)});
    }
  return cases;
}

inline std::vector<MaterialCase> layered_cases(float roughness) {
  std::vector<MaterialCase> cases;
  for (const GeometryModel geometry : {GeometryModel::Smith, GeometryModel::SchlickGgx}) {
    Material material;
    material.model = MaterialModel::CookTorrance;
    material.geometry = geometry;
    material.roughness.constant = roughness;
    material.diffuse.constant = Rgb{0.5f};
    material.specular.constant = Rgb{0.5f};
    cases.push_back({fmt::format("cook_torrance {} roughness {}",
                                 geometry == GeometryModel::Smith ? "smith" : "schlick", roughness),
                     bsdf_at(material, {}, {}, true)});
  }
  cases.push_back({fmt::format("lab of width {}", roughness),
                   {.model = BsdfModel::Lab,
                    .alpha = ggx_width(roughness),
                    .diffuse = Rgb{0.7f},
                    .specular = Rgb{0.3f}}});
  return cases;
}

// Brushed along either axis: as rough as that along it and, across, three times as rough and fully.
inline std::vector<MaterialCase> anisotropic_cases(float roughness) {
  std::vector<MaterialCase> cases;
  const auto add = [&](const std::string& name, Material material) {
    material.is_anisotropic = true;
    for (const float across : {std::min(1.0f, 3 * roughness), 1.0f})
      for (const bool is_turned : {false, true}) {
        material.roughness.constant = is_turned ? across : roughness;
        material.roughness_across.constant = is_turned ? roughness : across;
        for (const bool is_outside : {true, false}) {
          if (!is_outside && material.model == MaterialModel::Conductor) continue;
          cases.push_back(
              {fmt::format("{} from {} roughness {} by {}", name, is_outside ? "outside" : "inside",
                           material.roughness.constant, material.roughness_across.constant),
               bsdf_at(material, {}, {}, is_outside)});
        }
      }
  };
  Material metal;
  metal.model = MaterialModel::Conductor;
  metal.eta = Rgb{0.2f};
  metal.k = Rgb{3.9f};
  add("brushed metal", metal);
  for (const float ior : {1.0001f, 1.5f, 1000.0f}) {
    Material glass;
    glass.model = MaterialModel::Dielectric;
    glass.eta = Rgb{ior};
    add(fmt::format("brushed glass {}", ior), glass);
  }
  return cases;
}

// Coats of this width over white and over metal; beside what is smooth of them there is a delta
// lobe.
inline std::vector<MaterialCase> coated_cases(float roughness) {
  const float coat = roughness >= smallest_ggx_width ? roughness : 0;
  const float across = std::min(1.0f, 3 * coat);
  return {
      {fmt::format("coated diffuse roughness {}", coat),
       tests::coated_diffuse(coat, coat, Rgb{0.9f})},
      {fmt::format("brushed coat over diffuse roughness {}", coat),
       tests::coated_diffuse(coat, across, Rgb{0.9f})},
      {fmt::format("coated metal roughness {}", coat), tests::coated_conductor(coat, coat)},
      {fmt::format("coated rough metal roughness {}", coat), tests::coated_conductor(coat, 0.3f)}};
}

inline std::vector<MaterialCase> all_material_cases(float roughness) {
  std::vector<MaterialCase> cases = conductor_cases(roughness);
  for (auto* more : {&dielectric_cases, &layered_cases, &anisotropic_cases, &coated_cases})
    for (MaterialCase& c : more(roughness)) cases.push_back(std::move(c));
  return cases;
}

}  // namespace candela::test
