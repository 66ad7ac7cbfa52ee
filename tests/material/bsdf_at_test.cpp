#include "renderer/material/bsdf_at.h"

#include <gtest/gtest.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/bsdf/dispatch.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

// A store with one picture of one colour.
class Picture {
 public:
  explicit Picture(std::array<unsigned, 4> rgba) {
    const std::string path = folder_.put("x.png", crafted::png_rgba(2, 2, [rgba](int, int, int c) {
                                           return rgba[static_cast<std::size_t>(c)];
                                         }));
    Diagnostics diagnostics;
    handle = store.add({path, Encoding::Linear, Wrap::Repeat, {}}, diagnostics);
  }
  TextureStore store;
  TextureHandle handle;

 private:
  TemporaryFolder folder_;
};

TEST(Unit_BsdfAt, MapsReplaceFactors) {
  const Picture picture({51, 102, 255, 128});
  Material material{.model = MaterialModel::Diffuse};
  material.diffuse = {Rgb{0.5f}, {}};
  EXPECT_EQ(bsdf_at(material, picture.store, {}, true).diffuse, Rgb{0.5f});
  material.diffuse.texture = picture.handle;
  const Bsdf mapped = bsdf_at(material, picture.store, {Vec2f(0.3f, 0.7f)}, true);
  EXPECT_EQ(mapped.model, BsdfModel::Diffuse);
  EXPECT_FLOAT_EQ(mapped.diffuse.x, 0.2f);
  EXPECT_FLOAT_EQ(mapped.diffuse.z, 1);

  Material rough{.model = MaterialModel::Conductor};
  rough.roughness = {0.1f, picture.handle, 1};
  EXPECT_FLOAT_EQ(bsdf_at(rough, picture.store, {}, true).alpha, 0.4f);
  rough.roughness.channel = 3;
  EXPECT_FLOAT_EQ(bsdf_at(rough, picture.store, {}, true).alpha, 128.0f / 255);
}

// White would have an infinite k; it reflects .9999.
TEST(Unit_BsdfAt, MetalsReflectTheirMapAtNormalIncidence) {
  const Picture picture({51, 0, 255, 255});
  Material metal{.model = MaterialModel::Conductor};
  metal.specular.texture = picture.handle;
  for (const bool is_anisotropic : {false, true}) {
    metal.is_anisotropic = is_anisotropic;
    const Bsdf bsdf = bsdf_at(metal, picture.store, {}, true);
    const Rgb reflectance = fresnel_conductor(1, bsdf.eta, bsdf.k);
    EXPECT_NEAR(reflectance.x, 0.2f, 1e-6f);
    EXPECT_NEAR(reflectance.y, 0, 1e-6f);
    EXPECT_NEAR(reflectance.z, 0.9999f, 1e-6f);
    EXPECT_GT(fresnel_conductor(0.05f, bsdf.eta, bsdf.k).x, 0.5f);  // brighter at grazing angles
  }
}

TEST(Unit_BsdfAt, LabMapsCarryTheExponentInAlpha) {
  const Picture picture({51, 51, 51, 64});
  Material material{.model = MaterialModel::Lab};
  material.specular.texture = picture.handle;
  const Bsdf bsdf = bsdf_at(material, picture.store, {}, true);
  EXPECT_EQ(bsdf.model, BsdfModel::Lab);
  EXPECT_FLOAT_EQ(bsdf.specular.x, 0.2f);
  EXPECT_FLOAT_EQ(bsdf.alpha, std::sqrt(2 / (64.0f / 255 * 256 + 2)));
}

// (Those without a map and without a highlight compile to diffuse ones.)
TEST(Unit_BsdfAt, LabReflectsAsDiffuseWhereItsMapOfHighlightsIsBlack) {
  const Picture black({0, 0, 0, 255});
  Material material{.model = MaterialModel::Lab};
  material.diffuse.constant = Rgb{0.6f};
  material.specular.texture = black.handle;
  EXPECT_EQ(bsdf_models(material), model_bit(BsdfModel::Lab));
  const Bsdf bsdf = bsdf_at(material, black.store, {}, true);
  const BsdfEvaluation f = evaluate_bsdf(bsdf, normalize(Vec3f(0.6f, 0, 0.8f)), Vec3f(0, 0, 1));
  EXPECT_FLOAT_EQ(f.value.x, 0.6f * inverse_pi);
  EXPECT_FLOAT_EQ(f.pdf, inverse_pi);
}

// Whatever bsdf_at() makes lies in the set that bsdf_models() names: a model outside is black.
TEST(Unit_BsdfAt, ModelsAreTheOnesNamed) {
  const TextureStore none;
  Material material;
  material.coat = std::make_shared<const CoatTable>(1.5f, 0.01f, 0.1f);
  for (const MaterialModel model :
       {MaterialModel::Diffuse, MaterialModel::CookTorrance, MaterialModel::Lab,
        MaterialModel::Mirror, MaterialModel::Conductor, MaterialModel::Dielectric,
        MaterialModel::ThinDielectric, MaterialModel::DiffuseTransmission,
        MaterialModel::CoatedDiffuse, MaterialModel::CoatedConductor})
    for (const float specular : {0.0f, 0.5f})
      for (const bool is_anisotropic : {false, true})
        for (const bool energy_compensation : {false, true}) {
          material.model = model;
          material.specular.constant = Rgb{specular};
          material.is_anisotropic = is_anisotropic;
          material.energy_compensation = energy_compensation;
          const Bsdf bsdf = bsdf_at(material, none, {}, true);
          EXPECT_NE(bsdf_models(material) & model_bit(bsdf.model), 0u)
              << static_cast<int>(model) << is_anisotropic << energy_compensation;
        }
}

TEST(Unit_BsdfAt, GlassSeesTheInverseIndexFromInside) {
  const TextureStore none;
  Material glass{.model = MaterialModel::Dielectric};
  EXPECT_FLOAT_EQ(bsdf_at(glass, none, {}, true).eta.x, 1.5f);
  EXPECT_FLOAT_EQ(bsdf_at(glass, none, {}, false).eta.x, 1 / 1.5f);
  Material pane{.model = MaterialModel::ThinDielectric};
  EXPECT_FLOAT_EQ(bsdf_at(pane, none, {}, false).eta.x, 1.5f);
}

TEST(Unit_BsdfAt, WidthsThatFloatCannotHoldAreSmooth) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const TextureStore none;
  Material material{.model = MaterialModel::Conductor};
  for (const float alpha : {0.0f, 1e-6f, 0.99e-4f, std::nanf("")}) {
    material.roughness.constant = alpha;
    EXPECT_TRUE(bsdf_at(material, none, {}, true).is_smooth) << alpha;
  }
  material.roughness.constant = 1e-4f;
  EXPECT_FALSE(bsdf_at(material, none, {}, true).is_smooth);

  material.model = MaterialModel::Dielectric;
  material.roughness.constant = 0.3f;
  for (const bool is_front : {true, false}) {
    material.eta = Rgb{1.5f};
    EXPECT_FALSE(bsdf_at(material, none, {}, is_front).is_smooth);
    material.eta = Rgb{1.0000001f};
    EXPECT_TRUE(bsdf_at(material, none, {}, is_front).is_smooth);
    material.eta = Rgb{1};
    EXPECT_TRUE(bsdf_at(material, none, {}, is_front).is_smooth);
  }
}

TEST(Unit_BsdfAt, CookTorranceMapsCannotExceedOne) {
  const Picture white({255, 255, 255, 255});
  Material material{.model = MaterialModel::CookTorrance};
  material.diffuse.texture = white.handle;
  material.specular.constant = {0, 0.5f, 1};
  const Bsdf bsdf = bsdf_at(material, white.store, {}, true);
  EXPECT_FLOAT_EQ(bsdf.diffuse.x, 1);
  EXPECT_FLOAT_EQ(bsdf.diffuse.y, 1 / 1.5f);
  EXPECT_FLOAT_EQ(bsdf.specular.y, 0.5f / 1.5f);
  EXPECT_FLOAT_EQ(bsdf.specular.z, 0.5f);
}

TEST(Unit_BsdfAt, CookTorranceTakesItsTerms) {
  const TextureStore none;
  Material material{.model = MaterialModel::CookTorrance};
  EXPECT_EQ(bsdf_at(material, none, {}, true).fresnel, FresnelTerm::Schlick);
  material.fresnel = FresnelModel::Exact;
  material.geometry = GeometryModel::Smith;
  EXPECT_EQ(bsdf_at(material, none, {}, true).fresnel, FresnelTerm::Dielectric);
  EXPECT_EQ(bsdf_at(material, none, {}, true).geometry, GeometryTerm::Smith);
  material.fresnel_is_conductor = true;
  EXPECT_EQ(bsdf_at(material, none, {}, false).fresnel, FresnelTerm::Conductor);
}

}  // namespace
}  // namespace candela
