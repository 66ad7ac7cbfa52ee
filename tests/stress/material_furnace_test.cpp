// Furnaces: what loses no light vanishes in a white sky, alone and inside of and beside others; and
// a plane of any material gives back what its formula says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/bsdf/reference_bsdf.h"
#include "tests/scenes/description.h"
#include "tests/stress/closed_form.h"
#include "tests/stress/material_cases.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;
using Model = decltype(description::Material::model);

struct Lossless {
  std::string name;
  Model model;
};

Model metal_without_loss() {
  description::ConductorMaterial metal;
  metal.eta = Vec3d(1e-4);  // F = 1 - 4e-8 from straight above
  metal.k = Vec3d(100.0);
  return metal;
}
Model polish_without_loss() {
  description::CookTorranceMaterial polish;
  polish.f0 = Vec3d(1.0);
  polish.roughness.factor = 1e-6;
  polish.geometry = description::GeometryModel::Smith;
  return polish;
}
Model glass(double ior, bool is_thin) {
  description::DielectricMaterial material;
  material.ior = ior;
  material.is_thin = is_thin;
  return material;
}

Model coat_without_loss() {
  description::CoatedDiffuseMaterial coated;
  coated.reflectance.factor = Vec3d(1.0);
  coated.coat.thickness = 0;
  return coated;
}
Model sheet_without_loss() {
  description::DiffuseTransmissionMaterial sheet;
  sheet.reflectance.factor = Vec3d(0.4);
  sheet.transmittance.factor = Vec3d(0.6);
  return sheet;
}

std::vector<Lossless> lossless_materials() {
  description::LabMaterial lab;
  lab.diffuse.factor = Vec3d(1.0);
  std::vector<Lossless> all = {{"diffuse", diffuse(Vec3d(1.0))},
                               {"lab", lab},
                               {"mirror", description::MirrorMaterial{}},
                               {"metal", metal_without_loss()},
                               {"polish", polish_without_loss()},
                               {"coat", coat_without_loss()},
                               {"sheet", sheet_without_loss()}};
  for (const float ior : refractive_indices) {
    all.push_back({fmt::format("glass {}", ior), glass(double{ior}, false)});
    all.push_back({fmt::format("pane {}", ior), glass(double{ior}, true)});
  }
  return all;
}

SceneDescription under_a_white_sky() {
  SceneDescription scene = empty_scene();
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, {0.9, 1.3, 3.5}, {0, 0, 0}, 36);
  return scene;
}

void expect_nothing_seen(const std::string& name, const SceneDescription& scene) {
  const RenderSettings settings = settings_of(12, is_heavy() ? 128 : 32);
  // Two hundred scenes: each at its own share of one false alarm in ten thousand runs.
  expect_mean(renders_of(name, scene, settings, 8), 1,
              {.allowed_relative = 2e-6, .resolution = 5e-3, .level = 2.5e-7});
}

TEST(Stress_MaterialFurnace, LosslessMaterialsVanish) {
  for (const Lossless& material : lossless_materials()) {
    SceneDescription scene = under_a_white_sky();
    add_mesh(scene, box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6}), add_material(scene, material.model));
    expect_nothing_seen(material.name, scene);
  }
}

// The inner one touches nothing; rays go in and out of the outer one many times. (Not of what
// reflects all but some thousandths, as an index of 1000 does: light within comes out after
// hundreds of reflections or a million, and Russian roulette, which lets at most 0.98 live, leaves
// it without a variance.) The default suite does one pair in five.
TEST(Stress_MaterialFurnace, LosslessMaterialsVanishInsideOfEachOther) {
  std::size_t pair = 0;
  for (const Lossless& outer : lossless_materials()) {
    const auto* clear = std::get_if<description::DielectricMaterial>(&outer.model);
    if (clear == nullptr || clear->ior > 100) continue;
    for (const Lossless& inner : lossless_materials()) {
      if (pair++ % 5 != 0 && !is_heavy()) continue;
      SceneDescription scene = under_a_white_sky();
      add_mesh(scene, sphere({0, 0, 0}, 0.9, 2, false), add_material(scene, outer.model));
      add_mesh(scene, box({-0.3, -0.3, -0.3}, {0.3, 0.3, 0.4}), add_material(scene, inner.model));
      expect_nothing_seen(inner.name + " in " + outer.name, scene);
    }
  }
}

// Just over a white table and just beside each other. (Faces that coincide have no order, and a
// path that meets one of two leaves glass without having entered it.)
TEST(Stress_MaterialFurnace, LosslessMaterialsVanishBesideEachOther) {
  const std::vector<Lossless> all = lossless_materials();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SceneDescription scene = under_a_white_sky();
    add_mesh(scene, quad({-2, -0.4, 2}, {4, 0, 0}, {0, 0, -4}),
             add_material(scene, diffuse(Vec3d(1.0))));
    add_mesh(scene, box({-0.8, -0.39, -0.4}, {-0.01, 0.4, 0.4}), add_material(scene, all[i].model));
    const std::size_t next = (i + 1) % all.size();
    add_mesh(scene, box({0.01, -0.39, -0.4}, {0.8, 0.2, 0.4}),
             add_material(scene, all[next].model));
    expect_nothing_seen(all[i].name + " beside " + all[next].name, scene);
  }
}

std::vector<Lossless> opaque_materials(double roughness) {
  description::ConductorMaterial gold;  // in its green
  gold.eta = Vec3d(0.92);
  gold.k = Vec3d(2.45);
  gold.roughness.factor = roughness;
  description::CookTorranceMaterial coat;
  coat.roughness.factor = roughness;
  description::CookTorranceMaterial metal = coat;
  metal.eta_k = std::array{Vec3d(2.9), Vec3d(3.1)};
  metal.fresnel = description::FresnelModel::Exact;
  metal.geometry = description::GeometryModel::Smith;
  description::LabMaterial lab;
  lab.specular.factor = Vec3d(0.3);
  lab.diffuse.factor = Vec3d(0.8);
  lab.shininess = 2 / square(std::max(roughness, 0.0884)) - 2;  // up to 254
  return {{"conductor", gold},
          {"cook_torrance", coat},
          {"cook_torrance, exact conductor", metal},
          {"lab", lab}};
}

// Seen from one direction, far and narrow.
TEST(Stress_MaterialFurnace, PlanesGiveBackWhatTheirFormulaSays) {
  for (const double roughness : {1.0, 0.1, 1e-2, 1e-4, 0.0})
    for (const Lossless& material : opaque_materials(roughness))
      for (const float cosine : {1.0f, 0.5f, 0.1f}) {
        SceneDescription scene = under_a_white_sky();
        const auto handle = add_material(scene, material.model);
        add_mesh(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}), handle);
        const double sine = std::sqrt(1 - square(double{cosine}));
        set_camera(scene, {0, 8 * double{cosine}, 8 * sine}, {0, 0, 0}, 0.01, {0, sine, -1});
        const RenderSettings settings = settings_of(8, is_heavy() ? 256 : 32);
        const Scene as_compiled = compiled(scene, settings.options);
        const Bsdf bsdf = bsdf_at(as_compiled.materials[0], {}, {}, true);
        const double expected = tests::reference_albedo(bsdf, {sine, 0, double{cosine}});
        const std::string name =
            fmt::format("{} of roughness {} at cosine {}", material.name, roughness, cosine);
        expect_mean(renders_of(name, scene, settings, 8), expected,
                    {.allowed_relative = 5e-4, .resolution = 5e-3, .level = 1e-5});
      }
}

}  // namespace
}  // namespace candela
