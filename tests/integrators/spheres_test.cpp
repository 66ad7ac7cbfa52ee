// Pictures with exact spheres against closed forms, and the invariants with them.
#include <gtest/gtest.h>

#include "integrators/path/kernels.h"
#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

statistics::Moments mean_over_seeds(const SceneDescription& description, RenderSettings settings,
                                    int replicates = 16) {
  const Scene scene = compiled(description, settings.options);
  statistics::Moments moments;
  for (int i = 0; i < replicates; ++i) {
    settings.options.seed = static_cast<std::uint64_t>(100 + i);
    moments.add(mean_of(rendered(scene, settings).film.to_image(false)));
  }
  return moments;
}

void expect_mean(const SceneDescription& scene, const RenderSettings& settings, double expected,
                 double precision = 0.01) {
  const statistics::Moments e = mean_over_seeds(scene, settings);
  if (e.standard_error() < 1e-6 * expected) {
    EXPECT_NEAR(e.mean(), expected, 5e-6 * expected);
    return;
  }
  EXPECT_GT(e.p_value(expected), 1e-4) << e.mean() << " for " << expected;
  EXPECT_LT(e.standard_error(), precision * expected) << "the test sees too little";
}

// A floor of albedo 1/2 at y = 0 under a sphere of radiance 10.
SceneDescription floor_under_a_lamp(const Vec3d& centre, double radius) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
           add_material(scene, diffuse(Vec3d(0.5))));
  add_mesh(scene, exact_sphere(radius), add_material(scene, diffuse(Vec3d(0.0)), Vec3d(10.0)),
           at_place(centre));
  set_camera(scene, {-0.5, 0.4, 0.4}, {0, 0, 0}, 0.001);
  return scene;
}

// Irradiance at the origin of a sphere that is wholly above the horizon: pi L (r / d)^2 cos.
double radiance_of_floor(const Vec3d& centre, double radius) {
  const double distance = length(centre);
  return 0.5 * 10 * square(radius / distance) * (centre.y / distance);
}

TEST(Statistical_Spheres, LampOverAFloor) {
  struct Case {
    Vec3d centre;
    double radius;
  };
  for (const auto& [centre, radius] : {Case{{0, 2, 0}, 0.5}, Case{{1, 2, -1}, 1.9},
                                       Case{{3, 4, 0}, 1e-3}, Case{{0, 1, 0}, 0.99}}) {
    SceneDescription scene = floor_under_a_lamp(centre, radius);
    if (radius == 0.99) set_camera(scene, {-0.1, 0.004, 0}, {0, 0, 0}, 0.001);  // in its gap
    expect_mean(scene, settings_of(4, 256), radiance_of_floor(centre, radius), 0.005);
  }
}

// Whatever finds the lamp.
TEST(Statistical_Spheres, AllStrategiesAgree) {
  const Vec3d centre{0.5, 2, 0};
  for (const SamplingStrategy strategy :
       {SamplingStrategy::Mis, SamplingStrategy::Light, SamplingStrategy::Bsdf}) {
    RenderSettings settings = settings_of(4, 1024);
    settings.options.sampling = strategy;
    expect_mean(floor_under_a_lamp(centre, 1.2), settings, radiance_of_floor(centre, 1.2));
  }
}

// In closed form, without noise of the lamp but that of the cosine: at 64 samples a uniform choice
// of points on the sphere would be twenty times as noisy.
TEST(Statistical_Spheres, ConesLeaveLittleNoise) {
  const Vec3d centre{0.5, 2, 0};
  RenderSettings settings = settings_of(4, 16);
  settings.options.sampling = SamplingStrategy::Light;
  const statistics::Moments e = mean_over_seeds(floor_under_a_lamp(centre, 0.3), settings);
  EXPECT_LT(e.standard_error(), 2e-3 * radiance_of_floor(centre, 0.3));
}

// L = Le / (1 - rho) inside.
TEST(Statistical_Spheres, Furnace) {
  for (const double albedo : {0.0, 0.6, 0.9}) {
    for (const bool faces_inwards : {true, false}) {
      SceneDescription scene = furnace(exact_sphere(3, faces_inwards), albedo, 0.25);
      scene.materials[0].emits_both_sides = !faces_inwards;
      set_camera(scene, {0.3, -1, 2}, {1, 0.5, 0.2}, 90);
      expect_mean(scene, settings_of(8, 64), 0.25 / (1 - albedo));
    }
  }
}

// A point light in the centre: irradiance I / r^2 everywhere, exact now.
TEST(Statistical_Spheres, ALightInTheCentre) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, exact_sphere(2), add_material(scene, diffuse(Vec3d(0.5))));
  add_light(scene, description::PointLight{{0, 0, 0}, Vec3d(8.0)});
  set_camera(scene, {0, 0, 0}, {0, 0, 1}, 90);
  expect_mean(scene, settings_of(16, 64), 0.5 / pi_double * (8.0 / 4.0) / (1 - 0.5));
}

TEST(Statistical_Spheres, WhiteOnesVanishInAWhiteSky) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, exact_sphere(1), add_material(scene, diffuse(Vec3d(1.0))));
  add_light(scene, description::ConstantEnvironment{Vec3d(0.75), true});
  set_camera(scene, {0, 0, 4}, {0, 0, 0}, 40);
  expect_mean(scene, settings_of(16, 64), 0.75);
}

TEST(Statistical_Spheres, GlassVanishesInAWhiteSky) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, exact_sphere(1), add_material(scene, description::DielectricMaterial{}));
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, {0, 0, 4}, {0, 0, 0}, 40);
  expect_mean(scene, settings_of(16, 64), 1);
}

// Straight through its middle: Beer's law over the diameter.
TEST(Unit_Spheres, AbsorbingBall) {
  SceneDescription scene = empty_scene();
  const auto medium = add_medium(scene, {0.2, 0.5, 1.0}, Vec3d(0.0));
  const auto boundary = add_material(scene, description::InterfaceMaterial{});
  scene.materials[boundary.index].media.inside = medium;
  add_mesh(scene, exact_sphere(1.5), boundary);
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, {0, 0, 4}, {0, 0, 0}, 0.001);
  const Image image = rendered(scene, settings_of(4, 4)).film.to_image(false);
  const double absorption[3] = {0.2, 0.5, 1.0};
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(image.pixel(2, 2)[c], std::exp(-3 * absorption[c]), 1e-5);
}

// Half of the rays meet each of its two sides: what shines within is seen through the near side.
TEST(Statistical_Spheres, HolesLetTheFarSideShine) {
  SceneDescription scene = empty_scene();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
  scene.materials[lamp.index].emits_both_sides = true;
  scene.materials[lamp.index].opacity.factor = 0.5;
  add_mesh(scene, exact_sphere(1), lamp);
  set_camera(scene, {0, 0, 4}, {0, 0, 0}, 0.001);
  expect_mean(scene, settings_of(8, 64), 0.75);
}

// Glass, a metal, a lamp, holes, and two instances of one sphere.
SceneDescription room_with_spheres() {
  SceneDescription scene = small_room();
  add_mesh(scene, exact_sphere(0.25), add_material(scene, description::DielectricMaterial{}),
           at_place({-0.4, -0.2, 0.3}));
  description::ConductorMaterial metal;
  metal.roughness.factor = 0.2;
  const auto shared =
      add_mesh(scene, exact_sphere(0.2), add_material(scene, metal), at_place({0.5, -0.6, 0.4}));
  add_instance(scene, shared, at_place({-0.6, 0.5, -0.5}, 0.7));
  add_mesh(scene, exact_sphere(0.1), add_material(scene, diffuse(Vec3d(0.2)), Vec3d(6, 5, 4)),
           at_place({0.4, 0.4, 0}));
  const auto half = add_material(scene, diffuse(Vec3d(0.8)));
  scene.materials[half.index].opacity.factor = 0.5;
  add_mesh(scene, exact_sphere(0.2), half, at_place({0, 0.1, 0.5}));
  return scene;
}

Scene with_spheres(const RenderSettings& settings) {
  return compiled(room_with_spheres(), settings.options);
}

TEST(Agreement_Spheres, TheSameBitsForAnyThreads) {
  RenderSettings settings = settings_of(40, 32);
  const Scene scene = with_spheres(settings);
  settings.threads = 1;
  const auto one = rendered(scene, settings).film.to_image(true).values;
  settings.threads = 2;
  EXPECT_EQ(rendered(scene, settings).film.to_image(true).values, one);
  settings.options.crop = PixelRect{10, 5, 30, 25};
  const Image crop = rendered(scene, settings).film.to_image(false);
  const std::size_t channels = one.size() / (40 * 40);
  EXPECT_EQ(crop.pixel(3, 4)[0], one[channels * (13 + 40 * 9)]);
}

TEST(Agreement_Spheres, TheSameBitsFromAllKernels) {
  const RenderSettings settings = settings_of(32, 32);
  const Scene scene = with_spheres(settings);
  const EmbreeAccel accelerator(scene);
  const Filter filter = make_filter(settings.options);
  const auto context = make_path_context(scene, accelerator, filter, settings.options);
  const PixelRect all{0, 0, 32, 32};
  const auto picture_of = [&](TileKernel<EmbreeAccel> kernel) {
    Film film(32, 32, all, 0, 4);
    (void)kernel(context, {all, {0, 32}, nullptr, settings.options.seed}, film);
    return film.to_image(true).values;
  };
  EXPECT_EQ(picture_of(&render_tile<strategy_features>), picture_of(&render_tile<media_features>));
  EXPECT_FALSE(general_features.covers(scene.features));
  EXPECT_TRUE(lane_features.covers(scene.features));
}

TEST(Agreement_Spheres, PowersOfTwoGiveTheSameBits) {
  const RenderSettings settings = settings_of(32, 16);
  const auto picture_of = [&](double scale) {
    SceneDescription scene = room_with_spheres();
    for (description::Instance& instance : scene.instances) {
      instance.object_to_world.linear *= scale;
      instance.object_to_world.translation *= scale;
    }
    for (description::Camera& camera : scene.cameras) {
      camera.eye *= scale;
      camera.target *= scale;
    }
    return rendered(scene, settings).film.to_image(true).values;
  };
  const auto expected = picture_of(1);
  for (const int k : {-40, -7, 20}) EXPECT_EQ(picture_of(std::ldexp(1.0, k)), expected) << k;
}

TEST(Statistical_Spheres, BothAcceleratorsGiveTheSamePicture) {
  RenderSettings settings = settings_of(32, 64);
  const Scene scene = with_spheres(settings);
  const double embree = mean_of(rendered(scene, settings).film.to_image(false));
  settings.accelerator = AcceleratorKind::Bvh;
  EXPECT_NEAR(mean_of(rendered(scene, settings).film.to_image(false)), embree, 1e-3 * embree);
}

// The room's spheres as fine meshes: the same mean.
TEST(Statistical_Spheres, FineMeshesLookTheSame) {
  const RenderSettings settings = settings_of(24, 64);
  SceneDescription meshes = room_with_spheres();
  for (description::Mesh& mesh : meshes.meshes) {
    if (!mesh.sphere) continue;
    description::Mesh fine = sphere({0, 0, 0}, mesh.sphere->radius * 1.0008, 4);
    fine.materials = mesh.materials;
    mesh = fine;
  }
  const statistics::Moments exact = mean_over_seeds(room_with_spheres(), settings);
  const statistics::Moments fine = mean_over_seeds(meshes, settings);
  EXPECT_GT(statistics::welch_p_value(exact, fine), 1e-4) << exact.mean() << " " << fine.mean();
  EXPECT_LT(exact.standard_error(), 0.003 * exact.mean());
}

}  // namespace
}  // namespace candela
