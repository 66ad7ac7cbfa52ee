// Media as the path tracer renders them: closed forms, furnaces, and an independent random walk.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/integrators/media_walk.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

using Channels = std::array<statistics::Moments, 3>;

Channels pixels_of(const SceneDescription& scene, const RenderSettings& settings) {
  Channels channels;
  const RenderResult result = rendered(scene, settings);
  const Image image = result.film.to_image(false);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) channels[c].add(double{image.pixel(x, y)[c]});
  return channels;
}

// From so near along one line that all pixels see the same.
void set_line_of_sight(SceneDescription& scene, const Vec3d& eye, const Vec3d& target) {
  set_camera(scene, eye, target, 1e-3, {0.1, 1, 0.2});
}

constexpr double eta_of_glass = 1.5;

// A surface with a medium in it.
description::MaterialHandle add_boundary(SceneDescription& scene, description::MediumHandle inside,
                                         double ior = 1, double roughness = 0) {
  description::MaterialHandle material;
  if (ior == 1) {
    material = add_material(scene, description::InterfaceMaterial{});
  } else {
    description::DielectricMaterial glass;
    glass.ior = ior;
    glass.roughness.factor = roughness;
    material = add_material(scene, glass);
  }
  scene.materials[material.index].media.inside = inside;
  return material;
}

SceneDescription described(const BoxOfMedium& b) {
  SceneDescription scene = empty_scene();
  const auto medium = add_medium(scene, b.absorption, b.scattering, b.asymmetry);
  add_mesh(scene, box(Vec3d(-1), Vec3d(1)), add_boundary(scene, medium, b.ior));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), b.lamp_radiance);
  scene.materials[lamp.index].emits_both_sides = true;
  add_mesh(scene, quad(b.lamp_corner, b.lamp_edge1, b.lamp_edge2), lamp);
  add_light(scene, description::ConstantEnvironment{b.sky, true});
  return scene;
}

struct WalkCase {
  const char* name;
  BoxOfMedium box;
  Vec3d eye;
  Vec3d target;
};

const Vec3d outside(3, 2, 4);
const Vec3d within(0.2, -0.3, 0.4);
const Vec3d middle(0.1, 0.2, 0);

std::vector<WalkCase> walk_cases() {
  BoxOfMedium lit_from_aside{.absorption = {0.1, 0.5, 0},
                             .scattering = {1, 0.5, 2},
                             .asymmetry = 0.6,
                             .sky = {0.2, 0.4, 0.1},
                             .lamp_corner = {1.5, -1, -1},
                             .lamp_edge1 = {0, 2, 0},
                             .lamp_edge2 = {0, 0, 2},
                             .lamp_radiance = {5, 3, 8}};
  BoxOfMedium lit_within = lit_from_aside;
  lit_within.asymmetry = -0.4;
  lit_within.lamp_corner = {-0.5, 0.6, -0.5};
  lit_within.lamp_edge1 = {0.5, 0, 0};
  lit_within.lamp_edge2 = {0, 0, 0.5};
  BoxOfMedium ink = lit_from_aside;
  ink.scattering = {4, 0, 0.2};
  ink.absorption = {0, 1, 3};
  const auto glass = [](BoxOfMedium b) {
    b.ior = eta_of_glass;
    return b;
  };
  return {{"from outside", lit_from_aside, outside, middle},
          {"from within", lit_from_aside, within, {1, 0.3, 0.2}},
          {"channels that do not scatter, and do not absorb", ink, outside, middle},
          {"a lamp within", lit_within, outside, middle},
          {"a lamp and the camera within", lit_within, within, middle},
          {"glass", glass(lit_from_aside), outside, middle},
          {"glass from within", glass(ink), within, {1, 0.3, 0.2}},
          {"glass with a lamp within", glass(lit_within), outside, middle}};
}

TEST(Statistical_Media, AgreeWithAnAnalogRandomWalk) {
  const std::vector<WalkCase> cases = walk_cases();
  const double level = statistics::sidak_level(0.01, 3.0 * static_cast<double>(cases.size()));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const WalkCase& c = cases[i];
    SCOPED_TRACE(c.name);
    SceneDescription scene = described(c.box);
    set_line_of_sight(scene, c.eye, c.target);
    if (c.eye == within) scene.cameras[0].medium = description::MediumHandle(0);
    const Channels found = pixels_of(scene, settings_of(16, 128, 7 + i));
    const Channels expected =
        walked_radiance(c.box, c.eye, normalize(c.target - c.eye), 100'000, 1000 * i);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GT(welch_p_value(found[k], expected[k]), level)
          << "channel " << k << ": " << found[k].mean() << " +- " << found[k].standard_error()
          << ", expected " << expected[k].mean() << " +- " << expected[k].standard_error();
      EXPECT_LT(expected[k].standard_error(), 0.03);
      EXPECT_LT(found[k].standard_error(), 0.03);
    }
  }
}

// A medium that takes nothing is not seen in a white sky, whatever bounds it.
TEST(Statistical_Media, WhiteOnesVanishInAFurnace) {
  for (const double ior : {1.0, eta_of_glass})
    for (const double g : {0.0, 0.8}) {
      SCOPED_TRACE(testing::Message() << "ior " << ior << ", g " << g);
      SceneDescription scene = empty_scene();
      const auto medium = add_medium(scene, Vec3d(0.0), Vec3d(1, 4, 2), g);
      add_mesh(scene, sphere({0, 0, 0}, 1, 3, ior != 1), add_boundary(scene, medium, ior));
      add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
      set_camera(scene, {0, 0, 5}, {0, 0, 0}, 30);
      for (const statistics::Moments& found : pixels_of(scene, settings_of(24, 64))) {
        EXPECT_GT(found.p_value(1), 1e-3) << found.mean() << " +- " << found.standard_error();
        EXPECT_LT(found.standard_error(), 0.01);
      }
    }
}

// Fog that only absorbs is exact: a wall of lamps behind it, and an end to it.
TEST(Unit_Media, AbsorptionIsBeersLawWithoutNoise) {
  SceneDescription scene = empty_scene();
  const auto fog = add_medium(scene, Vec3d(0.5, 0.1, 0), Vec3d(0.0));
  const auto haze = add_medium(scene, Vec3d(0, 0.3, 1), Vec3d(0.0));
  add_mesh(scene, box(Vec3d(-1), Vec3d(1)), add_boundary(scene, haze));
  scene.materials[0].media.outside = fog;
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1, 2, 3));
  add_mesh(scene, quad({-5, -5, -3}, {10, 0, 0}, {0, 10, 0}), lamp);
  set_line_of_sight(scene, {0, 0, 4}, {0, 0, 0});
  scene.cameras[0].medium = fog;
  const Channels found = pixels_of(scene, settings_of(4, 1));
  const Vec3d depth = Vec3d(0.5, 0.1, 0) * 5.0 + Vec3d(0, 0.3, 1) * 2.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int k = static_cast<int>(c);
    EXPECT_NEAR(found[c].mean(), (k + 1) * std::exp(-depth[k]), 2e-6) << c;
    EXPECT_LT(found[c].standard_error(), 1e-6);
  }
}

// A floor with ink below it and fog above, under lamps in the fog: sampled at every hit, or picked;
// by shadow rays that may meet interfaces, or not.
TEST(Unit_Media, SurfacesAreLitThroughTheMediumOnTheirSide) {
  for (const int lamps : {1, 5})
    for (const bool has_interfaces : {false, true}) {
      SCOPED_TRACE(testing::Message() << lamps << " lamps, interfaces: " << has_interfaces);
      SceneDescription scene = empty_scene();
      const auto ink = add_medium(scene, Vec3d(3, 5, 0), Vec3d(0.0));
      const auto fog = add_medium(scene, Vec3d(0.1, 0.4, 0.2), Vec3d(0.0));
      const auto floor = add_material(scene, diffuse(Vec3d(0.5)));
      scene.materials[floor.index].media = {ink, fog};
      add_mesh(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), floor);
      if (has_interfaces) {
        const auto aside = add_boundary(scene, ink);
        scene.materials[aside.index].media.outside = fog;
        add_mesh(scene, box({1, 1, 0.1}, {1.5, 1.5, 0.5}), aside);
      }
      for (int i = 0; i < lamps; ++i)
        add_light(scene, description::PointLight{{0, 0, 2}, Vec3d(1.0 / lamps)});
      set_line_of_sight(scene, {0, 0, 4}, {0, 0, 0});
      scene.cameras[0].medium = fog;
      RenderSettings settings = settings_of(4, 16);
      settings.options.max_depth = 1;
      const Channels found = pixels_of(scene, settings);
      for (std::size_t c = 0; c < 3; ++c) {
        const double depth = scene.media[fog.index].absorption[static_cast<int>(c)] * (4 + 2);
        const double expected = 0.5 / pi_double / 4 * std::exp(-depth);
        EXPECT_NEAR(found[c].mean(), expected, 1e-5 * expected) << c;
      }
    }
}

// Light of a point that scatters once on its way to the eye: an integral along the line of sight.
struct Beam {
  Vec3d absorption{0.2, 0.1, 0.4};
  Vec3d scattering{0.3, 0.6, 0.1};
  double g = 0.5;
  Vec3d eye{0, 0, 4};
  Vec3d light{3, 0.5, 0.2};

  [[nodiscard]] double expected(int channel) const {
    const double extinction = absorption[channel] + scattering[channel];
    constexpr int panels = 20'000;
    double sum = 0;
    for (int i = 0; i < panels; ++i) {
      const Vec3d p(0, 0, 1 - 2 * (i + 0.5) / panels);
      const Vec3d to_light = light - p;
      const double within = length(to_light) / to_light.x;  // to the box's side at x = 1
      const double cosine = dot(Vec3d(0, 0, -1), to_light) / length(to_light);
      const double phase =
          (1 - g * g) / (4 * pi_double) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
      sum += std::exp(-extinction * (1 - p.z + within)) * phase / length_squared(to_light) * 2 /
             panels;
    }
    return scattering[channel] * sum;
  }
};

TEST(Statistical_Media, SingleScatteringIsTheIntegralAlongTheRay) {
  const Beam beam;
  SceneDescription scene = empty_scene();
  const auto medium = add_medium(scene, beam.absorption, beam.scattering, beam.g);
  add_mesh(scene, box(Vec3d(-1), Vec3d(1)), add_boundary(scene, medium));
  add_light(scene, description::PointLight{beam.light, Vec3d(1.0)});
  set_line_of_sight(scene, beam.eye, {0, 0, 0});
  RenderSettings settings = settings_of(24, 64);
  settings.options.max_depth = 1;
  const Channels found = pixels_of(scene, settings);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_GT(found[c].p_value(beam.expected(static_cast<int>(c))), 1e-3)
        << found[c].mean() << " +- " << found[c].standard_error() << ", expected "
        << beam.expected(static_cast<int>(c));
}

// Fog around the camera in a room of fog, a ball of milk in glass and one of smoke in it, two boxes
// of smoke in each other, lamps and a sky.
SceneDescription foggy_room() {
  SceneDescription scene = small_room();
  const auto fog = add_medium(scene, Vec3d(0.05), Vec3d(0.1, 0.15, 0.3), 0.3);
  const auto milk = add_medium(scene, Vec3d(0.1, 0.3, 0.6), Vec3d(8, 7, 6));
  const auto smoke = add_medium(scene, Vec3d(1, 0.5, 0.2), Vec3d(3, 3, 3), 0.7);
  const auto place = [&](const description::Mesh& mesh, description::MediumHandle inside,
                         description::MediumHandle around, double ior = 1, double roughness = 0) {
    const auto material = add_boundary(scene, inside, ior, roughness);
    scene.materials[material.index].media.outside = around;
    add_mesh(scene, mesh, material);
  };
  place(box({-0.95, -0.95, -0.95}, {0.95, 0.95, 3.8}), fog, {});
  place(sphere({0.4, -0.4, 0}, 0.3, 2), milk, fog, 1.4, 0.3);
  place(box({-0.8, -0.6, -0.4}, {-0.2, 0.2, 0.2}), smoke, fog);
  place(box({-0.6, -0.4, -0.2}, {-0.4, 0, 0}), milk, smoke);
  add_light(scene, description::ConstantEnvironment{Vec3d(0.1, 0.2, 0.4), true});
  scene.cameras[0].medium = fog;
  return scene;
}

// With and without light sampling: what shadow rays bring, and its weights, against walks that find
// the lights by themselves.
TEST(Statistical_Media, LightSamplingChangesNoMean) {
  const SceneDescription scene = foggy_room();
  RenderSettings settings = settings_of(32, 32);
  const Image mis = rendered(scene, settings).film.to_image(false);
  settings.options.seed = 2;
  for (const SamplingStrategy strategy : {SamplingStrategy::Bsdf, SamplingStrategy::Light}) {
    settings.options.sampling = strategy;
    settings.options.samples_per_pixel = strategy == SamplingStrategy::Bsdf ? 256 : 64;
    const RenderResult other = rendered(scene, settings);
    EXPECT_EQ(other.statistics.kernel, "path/strategies");
    const std::vector<double> a = grey(mis), b = grey(other.film.to_image(false));
    statistics::Moments difference;
    for (std::size_t i = 0; i < a.size(); ++i) difference.add(a[i] - b[i]);
    EXPECT_GT(difference.p_value(0), 1e-3)
        << difference.mean() << " +- " << difference.standard_error() << " of " << mean_of(mis);
    EXPECT_LT(difference.standard_error(), 0.03 * mean_of(mis));
  }
}

TEST(Statistical_Media, BothAcceleratorsAgree) {
  const SceneDescription scene = foggy_room();
  RenderSettings settings = settings_of(32, 32);
  const std::vector<double> embree = grey(rendered(scene, settings).film.to_image(false));
  settings.accelerator = AcceleratorKind::Bvh;
  settings.options.seed = 2;
  const std::vector<double> bvh = grey(rendered(scene, settings).film.to_image(false));
  statistics::Moments difference;
  for (std::size_t i = 0; i < bvh.size(); ++i) difference.add(bvh[i] - embree[i]);
  EXPECT_GT(difference.p_value(0), 1e-3);
}

}  // namespace
}  // namespace candela
