// lab3's direct lighting (docs/cli.md, "Whitted and raster") against closed forms: lights of each
// kind, highlights, shadows.
#include "integrators/whitted/lab_shading.h"
#include "tests/integrators/whitted/lab_scenes.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

const Vec3d colour{0.2, 0.5, 0.8};

TEST(Unit_WhittedLight, PointLightsFallOffWithTheSquareOfTheDistance) {
  for (const double far : {1.0, 3.0, 50.0}) {
    SceneDescription scene = floor_seen_from(2, diffuse(colour));
    add_lab_point_light(scene, {0.6 * far, 0.8 * far, 0}, 7);
    expect_near(seen_by_whitted(scene), colour * (7 / (far * far) * 0.8));
  }
}

TEST(Unit_WhittedLight, DirectionalLightsDoNotFallOff) {
  SceneDescription scene = floor_seen_from(2, diffuse(colour));
  add_light(scene, description::DirectionalLight{{0.6, 0.8, 0}, Vec3d(pi_double * 3)});
  expect_near(seen_by_whitted(scene), colour * (3 * 0.8));
}

TEST(Unit_WhittedLight, SpotLightsAreDarkOutsideOfTheirCone) {
  for (const double tilt : {0.0, 0.5}) {
    SceneDescription scene = floor_seen_from(2, diffuse(colour));
    const Vec3d axis{std::sin(tilt), -std::cos(tilt), 0};
    add_light(scene, description::SpotLight{{0, 4, 0}, axis, Vec3d(pi_double * 8), 0.2, 0.4});
    expect_near(seen_by_whitted(scene), tilt == 0 ? colour * (8 / 16.0) : Vec3d(0.0));
  }
}

TEST(Unit_WhittedLight, AllLightsAddUp) {
  SceneDescription scene = floor_seen_from(2, diffuse(colour));
  add_lab_point_light(scene, {0, 4, 0}, 16);
  add_lab_point_light(scene, {0, 2, 0.5}, 1);
  add_light(scene, description::DirectionalLight{{0, 1, 0}, Vec3d(pi_double * 2)});
  const double oblique = 1 / 4.25 * (2 / std::sqrt(4.25));
  expect_near(seen_by_whitted(scene), colour * (1 + oblique + 2));
}

TEST(Unit_WhittedLight, AmbientLightKnowsNoShadow) {
  SceneDescription scene = floor_seen_from(2, diffuse(colour));
  scene.lab_ambient = {0.1, 0.2, 0.3};
  add_sheet(scene, 3, add_material(scene, diffuse(Vec3d(0.5))));
  expect_near(seen_by_whitted(scene), colour * *scene.lab_ambient);
}

TEST(Unit_WhittedLight, AConstantEnvironmentIsAmbientLightWhereTheFileHasNone) {
  SceneDescription scene = floor_seen_from(2, diffuse(colour));
  add_light(scene, description::ConstantEnvironment{Vec3d(0.4), true});
  expect_near(seen_by_whitted(scene), colour * 0.4);
  scene.lab_ambient = Vec3d(0.1);
  expect_near(seen_by_whitted(scene), colour * 0.1);
  scene.lab_ambient = Vec3d(0.0);  // none was asked for
  expect_near(seen_by_whitted(scene), Vec3d(0.0));
}

// The path tracer is given pi times the Intensity and divides by pi.
TEST(Unit_WhittedLight, IsAsBrightAsThePathTracersDirectLight) {
  SceneDescription scene = floor_seen_from(2, diffuse(colour));
  scene.cameras[0].fovy_degrees = 1e-3;
  add_lab_point_light(scene, {3, 4, 1}, 30);
  RenderSettings path = lab_settings(IntegratorKind::Path);
  path.options.max_depth = 1;
  const Rgb reference = seen(scene, path);
  EXPECT_GT(reference.x, 0.1f);
  expect_near(seen_by_whitted(scene), Vec3d(reference));
}

// Light from (sin, cos, 0), seen from straight above: n.h = cos(angle / 2), r.v = cos(angle).
TEST(Unit_WhittedLight, HighlightsFollowTheHalfVectorOrTheMirroredDirection) {
  const double ks = 102 / 255.0, exponent = 256 * 51 / 255.0, angle = 0.3;
  for (const SpecularModel model : {SpecularModel::Blinn, SpecularModel::Phong}) {
    SceneDescription scene = empty_scene();
    add_sheet(scene, 0, add_material(scene, highlight_only(ks, exponent)));
    set_camera(scene, {0, 2, 0}, {0, 0, 0}, 40, {0, 0, 1});
    add_light(scene, description::DirectionalLight{{std::sin(angle), std::cos(angle), 0},
                                                   Vec3d(pi_double * 5)});
    RenderSettings settings = lab_settings(IntegratorKind::Whitted);
    settings.options.specular = model;
    const double cosine = std::cos(model == SpecularModel::Blinn ? angle / 2 : angle);
    const double local = 5 * ks * std::pow(cosine, exponent);
    expect_near(seen(scene, settings), Vec3d((1 - ks / 2) * local), 1e-4);
  }
}

// To the power of nothing all is 1, as std::pow has it, also where the highlight would be none.
TEST(Unit_WhittedLight, HighlightsOfAnExponentOf0AreEverywhere) {
  for (const SpecularModel model : {SpecularModel::Blinn, SpecularModel::Phong}) {
    EXPECT_EQ(lab_highlight(model, 0, {0, 1, 0}, {1, 0, 0}, {0.6f, 0.8f, 0}), 1);
    EXPECT_EQ(lab_highlight(model, 0, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}), 1);
  }
}

// A sheet between floor and light; the camera is below it.
Rgb floor_below_sheets(const std::vector<double>& opacities, double light_height) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  add_lab_point_light(scene, {0, light_height, 0}, light_height * light_height);
  for (std::size_t i = 0; i < opacities.size(); ++i)
    add_sheet(scene, 2 + 0.25 * static_cast<double>(i), add_cutout(scene, 0.5, opacities[i]));
  return seen_by_whitted(scene);
}

TEST(Unit_WhittedLight, ShadowRaysStepThroughHolesAndStopAtTheRest) {
  const Vec3d lit(0.5), dark(0.0);
  expect_near(floor_below_sheets({}, 4), lit);
  expect_near(floor_below_sheets({0.0}, 4), lit);
  expect_near(floor_below_sheets({0.199}, 4), lit);
  expect_near(floor_below_sheets({0.201}, 4), dark);  // wholly, not by a fifth
  expect_near(floor_below_sheets({1.0}, 4), dark);
  expect_near(floor_below_sheets({0.1, 0.1, 0.0, 0.1, 0.1}, 4), lit);
  expect_near(floor_below_sheets({0.1, 0.1, 0.0, 0.1, 0.5}, 4), dark);
}

// A blocker just behind a hole: the step is that of rounding, not of some length.
TEST(Unit_WhittedLight, StepsThroughHolesSkipNothing) {
  for (const double gap : {1e-1, 1e-3, 1e-4}) {
    SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
    add_lab_point_light(scene, {0, 4, 0}, 16);
    add_sheet(scene, 2, add_cutout(scene, 0.5, 0.1));
    expect_near(seen_by_whitted(scene), Vec3d(0.5));
    add_sheet(scene, 2 + gap, add_cutout(scene, 0.5, 1.0));
    expect_near(seen_by_whitted(scene), Vec3d(0.0));
  }
}

// Vertex normals that lean apart by the angle t meet at (0, cos t, 0) in the middle: the lab shades
// with that, and turned away from the viewer if the file's are.
TEST(Unit_WhittedLight, NormalsAreUnitAndFaceTheViewerUnlessTheLabsAreAskedFor) {
  const float c = 0.8f, s = 0.6f;
  for (const float side : {1.0f, -1.0f}) {
    SceneDescription scene = empty_scene();
    description::Mesh sheet = quad({-10, 0, 8}, {20, 0, 0}, {0, 0, -18});
    for (const Vec3d& p : sheet.positions)
      sheet.normals.push_back(side * Vec3f(p.x < 0 ? -s : s, c, 0));
    add_mesh(scene, sheet, add_material(scene, diffuse(Vec3d(0.5))));
    set_camera(scene, {0, 2, 0}, {0, 0, 0}, 40, {0, 0, 1});
    add_light(scene, description::DirectionalLight{{0, 1, 0}, Vec3d(pi_double)});
    RenderSettings settings = lab_settings(IntegratorKind::Whitted);
    expect_near(seen(scene, settings), Vec3d(0.5));
    settings.options.lab_normals = true;
    expect_near(seen(scene, settings), side > 0 ? Vec3d(0.5 * 0.8) : Vec3d(0.0));
  }
}

TEST(Unit_WhittedLight, BlockersBeyondALightDoNotCount) {
  expect_near(floor_below_sheets({0.0, 1.0}, 2.125), Vec3d(0.5));  // the light hangs between them
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  add_light(scene, description::DirectionalLight{{0, 1, 0}, Vec3d(pi_double)});
  add_sheet(scene, 1000, add_material(scene, diffuse(Vec3d(0.5))));
  expect_near(seen_by_whitted(scene), Vec3d(0.0));  // a direction has no beyond
}

// A straight edge's shadow under a sun, 16 samples a pixel: of each row one pixel at most lies
// between light and shadow.
TEST(Unit_WhittedLight, ShadowsAreHard) {
  SceneDescription scene = floor_seen_from(4, diffuse(Vec3d(1.0)));
  add_light(scene, description::DirectionalLight{normalize(Vec3d(1, 1, 0)), Vec3d(pi_double)});
  add_mesh(scene, quad({5.3, 5, 9}, {20, 0, 0}, {0, 0, -18}),
           add_material(scene, diffuse(Vec3d(0.5))));
  const Image image =
      rendered(scene, lab_settings(IntegratorKind::Whitted, 48, 16)).film.to_image(false);
  const auto lit = static_cast<float>(std::sqrt(0.5));
  for (int y = 0; y < 48; ++y) {
    int bright = 0, dark = 0;
    for (int x = 0; x < 48; ++x) {
      bright += std::abs(image.pixel(x, y)[0] - lit) < 1e-5f ? 1 : 0;
      dark += image.pixel(x, y)[0] == 0 ? 1 : 0;
    }
    EXPECT_GE(bright + dark, 47) << "row " << y;
    EXPECT_GT(bright, 15);
    EXPECT_GT(dark, 15);
  }
}

// Factors of lab materials are kept in 8 bits, as the lab keeps them; path does not do that.
TEST(Unit_WhittedLight, FactorsOfLabMaterialsAreRoundedToEightBits) {
  SceneDescription scene = empty_scene();
  description::LabMaterial grey;
  grey.diffuse.factor = Vec3d(0.5);  // 127.5 of 255
  add_sheet(scene, 0, add_material(scene, grey));
  set_camera(scene, {0, 2, 0}, {0, 0, 0}, 1e-3, {0, 0, 1});
  add_lab_point_light(scene, {0, 1, 0}, 1);
  expect_near(seen_by_whitted(scene), Vec3d(std::pow(128 / 255.0, 2.2)));
  RenderSettings path = lab_settings(IntegratorKind::Path);
  path.options.max_depth = 1;
  expect_near(seen(scene, path), Vec3d(std::pow(0.5, 2.2)));
}

}  // namespace
}  // namespace candela
