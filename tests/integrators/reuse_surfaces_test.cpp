// What pixels share (integrators/path/path_reuse.h) between surfaces that are more than Lambert's:
// the light of their diffuse lobes, while what their highlights send stays each path's own.
#include <gtest/gtest.h>

#include "integrators/path/reuse_points.h"
#include "integrators/path/shared_surfaces.h"
#include "renderer/base/floating_point_traps.h"
#include "tests/integrators/reused_paths.h"
#include "tests/scenes/description.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

description::LabMaterial lab(double diffuse, double specular, double exponent) {
  description::LabMaterial material;
  material.diffuse.factor = Vec3d(diffuse);
  material.specular.factor = Vec3d(specular, specular, 0.5 * specular);
  material.shininess = exponent;
  return material;
}
description::CookTorranceMaterial cook_torrance(double diffuse, double specular,
                                                description::GeometryModel geometry) {
  description::CookTorranceMaterial material;
  material.diffuse.factor = Vec3d(diffuse);
  material.specular.factor = Vec3d(specular);
  material.roughness.factor = 0.4;
  material.f0 = Vec3d(0.9);
  material.geometry = geometry;
  return material;
}
description::CoatedDiffuseMaterial coated(double reflectance) {
  description::CoatedDiffuseMaterial material;
  material.reflectance.factor = Vec3d(reflectance);
  material.coat.ior = 1.8;
  material.coat.roughness.factor = 0.3;
  return material;
}

// Five walls and two smooth balls, of all surfaces that share, open towards +z; no light.
SceneDescription glossy_room() {
  SceneDescription scene = empty_scene();
  const auto ceiling = add_material(scene, diffuse(Vec3d(0.8)));
  const auto floor = add_material(scene, lab(0.3, 0.7, 20));
  const auto coat = add_material(scene, coated(0.9));
  const auto gloss =
      add_material(scene, cook_torrance(0.2, 0.8, description::GeometryModel::SchlickGgx));
  const auto smith =
      add_material(scene, cook_torrance(0.2, 0.8, description::GeometryModel::Smith));
  add_mesh(scene, quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}), floor);
  add_mesh(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), ceiling);
  add_mesh(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}), coat);
  add_mesh(scene, quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}), gloss);
  add_mesh(scene, quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}), smith);
  add_mesh(scene, sphere({-0.4, -0.6, 0.2}, 0.4, 2, true), coat);
  add_mesh(scene, sphere({0.5, -0.3, 0}, 0.3, 2, true), floor);
  set_camera(scene, {0, 0, 3.5}, {0, 0, 0}, 45);
  return scene;
}
SceneDescription glossy_room_of_a_point() {
  SceneDescription scene = glossy_room();
  add_light(scene, description::PointLight{{0.1, 0.2, 0.3}, Vec3d(1)});
  return scene;
}

TEST(Statistical_ReuseSurfaces, GlossyOnesKeepTheMeanUnderAPointLight) {
  expect_same_mean_shared(glossy_room_of_a_point(), 256);
  expect_same_mean_shared(glossy_room_of_a_point(), 256,
                          [](RenderOptions& options) { options.max_depth = 2; });
}

TEST(Statistical_ReuseSurfaces, GlossyOnesKeepTheMeanUnderALampAndASky) {
  SceneDescription scene = glossy_room();
  const auto lamp = add_material(scene, diffuse(Vec3d(0)), {12, 12, 8});
  add_mesh(scene, quad({-0.2, 0.98, 0}, {0.4, 0, 0}, {0, 0, 0.4}), lamp);
  add_light(scene, description::ConstantEnvironment{Vec3d(0.3), true});
  expect_same_mean_shared(scene, 256,
                          [](RenderOptions& options) { options.samples_constant_sky = true; });
}

// Walls and a ball whose coats are smooth or of two widths, and a wall whose Fresnel
// term is exact: paths on them take their steps alone.
SceneDescription room_without_plain_gloss() {
  SceneDescription scene = empty_scene();
  description::CoatedDiffuseMaterial smooth = coated(0.8);
  smooth.coat.roughness.factor = 0;
  description::CoatedDiffuseMaterial brushed = coated(0.7);
  brushed.coat.roughness_across = description::ScalarInput{0.6, {}, 0};
  description::CookTorranceMaterial exact =
      cook_torrance(0.4, 0.6, description::GeometryModel::Smith);
  exact.fresnel = description::FresnelModel::Exact;
  exact.ior = 1.8;
  const auto smooth_coat = add_material(scene, smooth);
  add_mesh(scene, quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}), smooth_coat);
  add_mesh(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), add_material(scene, brushed));
  add_mesh(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}), add_material(scene, exact));
  add_mesh(scene, quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}), smooth_coat);
  add_mesh(scene, sphere({0.2, -0.4, 0}, 0.5, 2, true), smooth_coat);
  set_camera(scene, {0, 0, 3.5}, {0, 0, 0}, 45);
  add_light(scene, description::PointLight{{0.6, 0.5, 0.6}, Vec3d(1)});
  return scene;
}

TEST(Statistical_ReuseSurfaces, CoatsOfAnyWidthKeepTheMean) {
  const SceneDescription scene = room_without_plain_gloss();
  for (const PlainModel model : compiled(scene, settings_of(16, 16).options).plain_models)
    EXPECT_EQ(model, PlainModel::None);
  expect_same_mean_shared(scene, 256);
  expect_same_mean_shared(scene, 256, [](RenderOptions& options) { options.max_depth = 2; });
}

TEST(Statistical_ReuseSurfaces, CoatsOfAnyWidthHaveLessError) {
  expect_less_error_shared(room_without_plain_gloss(), 0.9);
}

SceneDescription three_glossy_floors() {
  SceneDescription floors = empty_scene();
  for (const auto material :
       {add_material(floors, lab(0.3, 0.7, 20)), add_material(floors, coated(0.9)),
        add_material(floors, cook_torrance(0.2, 0.8, description::GeometryModel::Smith))})
    add_mesh(floors, quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}), material);
  set_camera(floors, {0, 1, 0}, {0, 0, 0.1}, 45);
  return floors;
}

// What comes straight from lights to a glossy point that a path leaves is parted into what its
// diffuse lobe sends back and the rest. The rays to finite lights are as long as these are far.
TEST(Unit_ReusePoints, HowFarALightIsDoesNotChangeHowItsLightIsParted) {
  const Scene scene = compiled(three_glossy_floors(), settings_of(16, 16).options);
  const Vec3f wo = normalize(Vec3f(0.3f, 1, 0.2f)), wi = normalize(Vec3f(-0.4f, 1, 0.1f));
  PathBlock block{};
  SharedPointLanes y;
  const auto light_by_diffuse_lobe = [&](std::uint32_t geometry, float distance) {
    block.hits.set(0, Hit{.u = 0.3f, .v = 0.4f, .geometry = geometry, .triangle = 0});
    block.shadow_rays.set(0, Ray{.direction = wi * distance});
    block.unshadowed.set(0, Rgb(1));
    block.paths.radiance.set(0, Rgb(1));
    reset_points(y);
    y.wo.set(0, wo);
    y.always.set(0, Rgb(0));
    leave_point(scene, 0, {.arriving = 1}, block, y);
    EXPECT_GT(y.direct_glossy[0].x, 0);
    return y.direct[0].x;
  };
  for (std::uint32_t geometry = 0; geometry < 3; ++geometry) {
    const float near = light_by_diffuse_lobe(geometry, 1);
    EXPECT_GT(near, 0.01f);
    EXPECT_LT(near, 0.99f);
    for (const float distance : {0.2f, 5.0f, 40.0f})
      EXPECT_NEAR(light_by_diffuse_lobe(geometry, distance) / near, 1, 1e-5) << geometry;
  }
}

// A path whose next ray cannot be traced has no radiance, whatever lights there are.
TEST(Unit_ReusePoints, ALostPathStaysLost) {
  const Scene scene = compiled(three_glossy_floors(), settings_of(16, 16).options);
  ASSERT_TRUE(scene.light_sampler.always().empty());
  PathBlock block{};
  block.hits.set(0, Hit{.u = 0.3f, .v = 0.4f, .geometry = 0, .triangle = 0});
  lose_path(block, 0);
  SharedPointLanes y;
  reset_points(y);
  y.wo.set(0, {0, 1, 0});
  y.always.set(0, block.paths.radiance[0]);
  const FloatingPointTraps traps(Traps::Off);  // its radiance is no number
  leave_point(scene, 0, {}, block, y);
  EXPECT_FALSE(is_finite(y.direct_glossy[0]));
}

// None of the room's surfaces but the ceiling is Lambert's.
TEST(Statistical_ReuseSurfaces, GlossyOnesHaveLessError) {
  expect_less_error_shared(glossy_room_of_a_point(), 0.9);
}

// Of two lights that are sampled at every hit what a glossy point sends out is its own path's.
TEST(Statistical_ReuseSurfaces, SoTheyDoUnderTwoPointLights) {
  SceneDescription scene = glossy_room_of_a_point();
  add_light(scene, description::PointLight{{-0.5, 0.8, 0.7}, Vec3d(0.3)});
  expect_same_mean_shared(scene, 256);
}

// Paths end where they meet it, whatever others find: it is none of those that find points.
TEST(Statistical_ReuseSurfaces, BlackOnesFindNothing) {
  SceneDescription scene = small_room();
  const auto black = add_material(scene, diffuse(Vec3d(0)));
  add_mesh(scene, sphere({-0.1, -0.4, 0.4}, 0.5, 2, true), black);
  expect_same_mean_shared(scene, 256);
}

// Whether two points see each other through a veil is drawn at random, for each two of them.
TEST(Statistical_ReuseSurfaces, VeilsKeepTheMean) {
  SceneDescription scene = small_room();
  const auto veil = add_material(scene, diffuse(Vec3d(0.5)));
  scene.materials[veil.index].opacity.factor = 0.5;
  add_mesh(scene, quad({-1, -0.3, -1}, {0, 0, 2}, {2, 0, 0}), veil);
  add_mesh(scene, quad({0, -1, -1}, {0, 0, 2}, {0, 2, 0}), veil);
  expect_same_mean_shared(scene, 256);
}

TEST(Agreement_ReuseSurfaces, SameBitsOverThreadsTilesCropsAndKernels) {
  for (SceneDescription description : {glossy_room_of_a_point(), room_without_plain_gloss()}) {
    RenderSettings settings = settings_with_reuse(true, 40, 24);
    settings.options.replicates = 3;
    add_light(description, description::ConstantEnvironment{Vec3d(0.3), true});
    expect_same_bits_shared(compiled(description, settings.options), settings);
  }
}

// The lobe is what is left of the BSDF where its highlight is taken away, and is drawn as often as
// the BSDF's density says.
TEST(Unit_SharedLobe, IsTheBsdfWithoutItsHighlight) {
  const CoatTable table(1.5f, 0.01f, 0.3f);
  Bsdf glossy{.model = BsdfModel::CookTorrance,
              .geometry = GeometryTerm::Smith,
              .alpha = 0.3f,
              .diffuse = {0.5f, 0.4f, 0.3f},
              .specular = {0.3f, 0.2f, 0.5f}};
  Bsdf lab = glossy;
  lab.model = BsdfModel::Lab;
  Bsdf coat = glossy;
  coat.model = BsdfModel::CoatedDiffuse;
  coat.alpha_across = coat.alpha;
  coat.coat = &table;
  const auto fresnel = [](const Bsdf& bsdf, float cosine) {
    if (bsdf.model == BsdfModel::Lab) return lab_fresnel(bsdf.specular, cosine);
    if (bsdf.model == BsdfModel::CoatedDiffuse)
      return Rgb(fresnel_dielectric(cosine, 1.5f).reflectance);
    return bsdf.specular * cook_torrance_fresnel(bsdf, cosine);
  };
  for (const Bsdf& bsdf : {glossy, lab, coat})
    for (const Vec3f wo : {Vec3f(0, 0, 1), Vec3f(0.6f, 0, 0.8f), Vec3f(0.96f, 0, 0.28f)})
      for (const Vec3f wi : {Vec3f(0, 0, 1), Vec3f(0, 0.8f, 0.6f), Vec3f(-0.8f, 0, 0.6f)}) {
        const BsdfEvaluation all = evaluate_bsdf(bsdf, wo, wi);
        const SharedLobe lobe = shared_lobe_of(bsdf, wo.z);
        const auto highlight =
            reflect_microfacets(GeometryTerm::Smith, ggx_width(bsdf.alpha), wo, wi);
        const Rgb rest = fresnel(bsdf, highlight.cos_half) * highlight.value;
        const Rgb value = lobe.value_below(wi.z) * lobe.crossing_o;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c] + rest[c], all.value[c], 1e-6f);
        EXPECT_NEAR(lobe.probability() * wi.z * inverse_pi + lobe.others * highlight.pdf, all.pdf,
                    1e-6f);
      }
}

TEST(Unit_SharedLobe, IsAllOfLambertsSurfaceAndNothingOfAMirror) {
  const SharedLobe lambert = shared_lobe_of({.diffuse = Rgb(0.5f)}, 0.7f);
  EXPECT_EQ(lambert.probability(), 1);
  EXPECT_EQ(lambert.value_below(0.5f),
            evaluate_diffuse({.diffuse = Rgb(0.5f)}, {}, {0, 0, 0.5f}).value);
  EXPECT_FALSE(lambert.is_never_drawn());
  EXPECT_TRUE(shared_lobe_of({.diffuse = Rgb(0)}, 0.7f).is_never_drawn());
  EXPECT_TRUE(
      shared_lobe_of({.model = BsdfModel::Mirror, .diffuse = Rgb(1)}, 0.7f).is_never_drawn());
}

}  // namespace
}  // namespace candela
