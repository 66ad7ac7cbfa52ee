// --fresnel and --geometry.
#include "scene_io/override_materials.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

using namespace description;

CookTorranceMaterial overridden(CookTorranceMaterial material, const LoadOptions& options) {
  SceneDescription scene;
  scene.materials.push_back({});
  scene.materials[0].model = material;
  Diagnostics diagnostics;
  override_materials(options, scene, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return std::get<CookTorranceMaterial>(scene.materials[0].model);
}

TEST(Unit_OverrideMaterials, ReplaceWhatTheSceneSays) {
  CookTorranceMaterial material;
  material.fresnel = FresnelModel::Exact;
  material.ior = 1.5;
  material.geometry = GeometryModel::Smith;
  EXPECT_EQ(overridden(material, {}).fresnel, FresnelModel::Exact);
  EXPECT_EQ(overridden(material, {}).geometry, GeometryModel::Smith);
  LoadOptions options;
  options.fresnel = FresnelModel::Schlick;
  options.geometry = GeometryModel::SchlickGgx;
  EXPECT_EQ(overridden(material, options).fresnel, FresnelModel::Schlick);
  EXPECT_EQ(overridden(material, options).geometry, GeometryModel::SchlickGgx);
}

TEST(Unit_OverrideMaterials, ExactFresnelKeepsTheReflectanceAtNormalIncidence) {
  CookTorranceMaterial material;
  material.f0 = {0.04, 0.6, 1.0};
  LoadOptions options;
  options.fresnel = FresnelModel::Exact;
  const auto eta_k = overridden(material, options).eta_k;
  ASSERT_TRUE(eta_k);
  const Vec3d& eta = (*eta_k)[0];
  for (int c = 0; c < 3; ++c) {
    const double root = (eta[c] - 1) / (eta[c] + 1);
    EXPECT_NEAR(root * root, material.f0[c], 2e-6) << c;
  }
  EXPECT_EQ((*eta_k)[1], Vec3d(0.0));
}

TEST(Errors_OverrideMaterials, CompensationNeedsSmith) {
  SceneDescription scene;
  CookTorranceMaterial material;
  material.geometry = GeometryModel::Smith;
  material.energy_compensation = true;
  scene.materials.push_back({});
  scene.materials[0].name = "steel";
  scene.materials[0].model = material;
  LoadOptions options;
  options.geometry = GeometryModel::SchlickGgx;
  Diagnostics diagnostics;
  override_materials(options, scene, diagnostics);
  ASSERT_EQ(diagnostics.error_count(), 1u);
  EXPECT_NE(to_string(diagnostics.list()[0]).find("'steel' has energy_compensation"),
            std::string::npos);
}

}  // namespace
}  // namespace candela
