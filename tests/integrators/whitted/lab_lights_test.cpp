// Lamps as the point lights that whitted and raster see in their place.
#include "integrators/whitted/lab_lights.h"

#include "tests/integrators/whitted/lab_scenes.h"
#include "tests/scenes/exact_sphere.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

// What a floor below the origin's lamp shows, seen from between them.
Rgb floor_below(const description::Mesh& lamp, const Vec3d& radiance, bool both_sides = false,
                const Transform& lamp_to_world = {}) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  const auto material = add_material(scene, diffuse(Vec3d(0.0)), radiance);
  scene.materials[material.index].emits_both_sides = both_sides;
  add_mesh(scene, lamp, material, lamp_to_world);
  return seen_by_whitted(scene);
}

TEST(Unit_LabLights, ALampIsAPointOfTheSameAxialIntensity) {
  const Vec3d radiance{3, 2, 1};
  const description::Mesh lamp = quad({-0.5, 5, -0.25}, {1, 0, 0}, {0, 0, 0.5});  // shines down
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  add_light(scene, description::PointLight{{0, 5, 0}, radiance * 0.5});  // L A
  const Rgb point = seen_by_whitted(scene);
  expect_near(point, radiance * (0.5 * 0.5 / pi_double / 25));
  expect_near(floor_below(lamp, radiance), Vec3d(point));
  expect_near(floor_below(lamp, radiance, true), Vec3d(point));
}

// Triangles that face opposite ways leave no vector area, but the lamp is as flat.
TEST(Unit_LabLights, AFlatLampHasAnAxisHoweverItsTrianglesAreWound) {
  const Vec3d radiance{3, 2, 1};
  const description::Mesh lamp = quad({-0.5, 5, -0.25}, {1, 0, 0}, {0, 0, 0.5});
  description::Mesh crossed = lamp;
  std::swap(crossed.triangles[1][1], crossed.triangles[1][2]);
  const Vec3d whole(floor_below(lamp, radiance));
  expect_near(floor_below(crossed, radiance, true), whole);
  expect_near(floor_below(crossed, radiance), 0.5 * whole);
}

// The point that stands for it lies within its surface, where nothing bounds what it would bring.
TEST(Unit_LabLights, ALampDoesNotLightItself) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0}),
           add_material(scene, highlight_only(0.5, 4), Vec3d(3.0)));
  set_camera(scene, {0.1, 2, 0}, {0.1, 0, 0}, 1, {0, 0, 1});
  expect_near(seen(scene, lab_settings(IntegratorKind::Raster)), Vec3d(3.0));
}

// From far away the path tracer's area light looks the same.
TEST(Unit_LabLights, FarAwayALampIsWhatThePathTracerSees) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  scene.cameras[0].fovy_degrees = 1e-3;
  add_mesh(scene, quad({-0.05, 50, -0.05}, {0.1, 0, 0}, {0, 0, 0.1}),
           add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1e6)));
  RenderSettings path = lab_settings(IntegratorKind::Path, 1, 64);
  path.options.max_depth = 1;
  expect_near(seen_by_whitted(scene), Vec3d(seen(scene, path)), 1e-4);
}

TEST(Unit_LabLights, OfALampThatIsPartlyThereAPartOfTheLightIs) {
  for (const description::Mesh& lamp :
       {quad({-0.5, 0, -0.5}, {1, 0, 0}, {0, 0, 1}), exact_sphere(0.5)}) {
    SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
    const auto shining = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(3.0));
    add_mesh(scene, lamp, shining, at_place({0, 5, 0}));
    const Vec3d whole(seen_by_whitted(scene));
    EXPECT_GT(whole.x, 0);
    scene.materials[shining.index].opacity.factor = 0.25;
    expect_near(seen_by_whitted(scene), 0.25 * whole);
  }
}

TEST(Unit_LabLights, AnAreaLightIsALampToo) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  add_light(scene, description::TriangleLight{
                       {Vec3d(-1, 5, -1), Vec3d(2, 5, -1), Vec3d(-1, 5, 2)}, Vec3d(4.0), false});
  expect_near(seen_by_whitted(scene), Vec3d(0.5 * 4 * 4.5 / pi_double / 25));  // centroid (0, 5, 0)
}

// What hangs together is one lamp, what is apart is not, whatever comes between them in the file.
TEST(Unit_LabLights, AreaLightsApartAreLampsApart) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  const auto add_triangle = [&](double x, Vec3d second, Vec3d third) {
    const Vec3d shift{x, 0, 0};
    add_light(scene,
              description::TriangleLight{
                  {Vec3d(-1, 5, -1) + shift, second + shift, third + shift}, Vec3d(4.0), false});
  };
  for (const double x : {-3.0, 3.0}) add_triangle(x, {1, 5, -1}, {1, 5, 1});
  for (const double x : {-3.0, 3.0}) add_triangle(x, {1, 5, 1}, {-1, 5, 1});
  const double r2 = 9 + 25;
  expect_near(seen_by_whitted(scene), Vec3d(2 * 0.5 * 4 * 4 / pi_double / r2 * 5 / std::sqrt(r2)));
  const RenderOptions options = lab_settings(IntegratorKind::Whitted).options;
  EXPECT_EQ(lab_lights(compiled(scene, options)).size(), 2u);
}

// A bulb's intensity is L pi r^2; its own mesh, which lies about the point, casts no shadow.
TEST(Unit_LabLights, AClosedLampShinesThroughItself) {
  expect_near(floor_below(sphere({0, 5, 0}, 0.4, 4, false), Vec3d(2.0)), Vec3d(0.5 * 2 * 0.16 / 25),
              0.01);
}

// From outside nobody sees the other side.
TEST(Unit_LabLights, ClosedLampsAreAsBrightWhicheverSidesShine) {
  const description::Mesh cube = box({-0.2, 4.8, -0.2}, {0.2, 5.2, 0.2});
  const Rgb outside = floor_below(cube, Vec3d(2.0));
  expect_near(outside, Vec3d(0.5 * 2 * (6 * 0.16 / 4) / pi_double / 25));
  expect_near(floor_below(cube, Vec3d(2.0), true), Vec3d(outside));
  const Rgb ball = floor_below(exact_sphere(0.4), Vec3d(2.0), false, at_place({0, 5, 0}));
  expect_near(ball, Vec3d(0.5 * 2 * 0.16 / 25));
  expect_near(floor_below(exact_sphere(0.4), Vec3d(2.0), true, at_place({0, 5, 0})), Vec3d(ball));
}

// Each sphere is a lamp of its own, and exactly as bright as it is.
TEST(Unit_LabLights, SpheresShineFromTheirCentres) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  const auto bulb = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(2.0));
  add_mesh(scene, exact_sphere(0.4), bulb, at_place({0, 5, 0}));
  add_mesh(scene, exact_sphere(0.8), bulb, at_place({3, 4, 0}, 0.5));
  expect_near(seen_by_whitted(scene), Vec3d(0.5 * 2 * 0.16 / 25 * (1 + 0.8)), 1e-5);
}

// Also where both wear one material and are one geometry.
TEST(Unit_LabLights, SpheresStandInEachOthersWay) {
  for (const auto& [first, second] : {std::pair{5, 10}, {10, 5}}) {
    SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
    const auto bulb = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(2.0));
    add_mesh(scene, exact_sphere(0.4), bulb, at_place({0, first, 0}));
    add_mesh(scene, exact_sphere(0.4), bulb, at_place({0, second, 0}));
    expect_near(seen_by_whitted(scene), Vec3d(0.5 * 2 * 0.16 / 25), 1e-5);
  }
}

TEST(Unit_LabLights, OtherMeshesStandInALampsWay) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  add_mesh(scene, sphere({0, 5, 0}, 0.4, 2, false),
           add_material(scene, diffuse(Vec3d(0.0)), Vec3d(2.0)));
  add_sheet(scene, 3, add_material(scene, diffuse(Vec3d(0.5))));
  expect_near(seen_by_whitted(scene), Vec3d(0.0));
}

TEST(Unit_LabLights, EachLampMeshIsOneLight) {
  SceneDescription scene = floor_seen_from(1, diffuse(Vec3d(0.5)));
  for (const double x : {-1.0, 1.0})
    add_mesh(scene, box({x - 0.1, 3, -0.1}, {x + 0.1, 3.2, 0.1}),
             add_material(scene, diffuse(Vec3d(0.0)), Vec3d(2.0)));
  add_lab_point_light(scene, {0, 4, 0}, 1);
  add_light(scene, description::ConstantEnvironment{Vec3d(0.4), true});
  const RenderOptions options = lab_settings(IntegratorKind::Whitted).options;
  EXPECT_EQ(lab_lights(compiled(scene, options)).size(), 3u);
}

}  // namespace
}  // namespace candela
