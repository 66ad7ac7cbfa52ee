// The steps of many paths at once (path/plain_lanes.h) against the general kernel's, one by one:
// the same bits and the same counts, whatever the surfaces, lights and options.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "renderer/base/floating_point_traps.h"
#include "tests/image/crafted_files.h"
#include "tests/integrators/lane_steps.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/meshes.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;
using description::CoatedDiffuseMaterial;
using description::CookTorranceMaterial;
using description::MaterialHandle;
using description::SceneDescription;

CookTorranceMaterial glossy(double roughness) {
  CookTorranceMaterial material;
  material.roughness = {roughness, {}, 0};
  material.f0 = {0.9, 0.6, 0.3};
  return material;
}

// Flat and smooth surfaces, smooth ones so coarse that their normals must be bent; diffuse, glossy
// and coated ones, and such as lanes do not know.
SceneDescription room_of_all_kinds() {
  SceneDescription scene = small_room();
  CookTorranceMaterial exact = glossy(0.2);
  exact.ior = 1.5;
  exact.fresnel = description::FresnelModel::Exact;
  CookTorranceMaterial smith = glossy(0.2);
  smith.geometry = description::GeometryModel::Smith;
  const MaterialHandle diffuse_ball = add_material(scene, diffuse({0.2, 0.5, 0.7}));
  add_mesh(scene, sphere({-0.5, 0.4, 0.2}, 0.3, 1), diffuse_ball);
  add_mesh(scene, sphere({0.5, -0.6, 0.3}, 0.35, 2), add_material(scene, glossy(0.05)));
  add_mesh(scene, box({0.3, -0.2, -0.8}, {0.8, 0.3, -0.4}), add_material(scene, glossy(0.4)));
  add_mesh(scene, sphere({0.1, 0.5, -0.4}, 0.2, 1), add_material(scene, exact));
  add_mesh(scene, box({-0.9, -1, 0.3}, {-0.6, -0.6, 0.6}), add_material(scene, smith));
  description::ConductorMaterial gold;
  gold.roughness = {0.15, {}, 0};
  add_mesh(scene, sphere({-0.6, 0, -0.6}, 0.25, 2), add_material(scene, gold));
  const auto coated = [&](double roughness, double ior, double thickness, int max_depth) {
    CoatedDiffuseMaterial material{{Vec3d(0.2, 0.7, 0.4), {}}, {}};
    material.coat = {ior, {roughness, {}, 0}, {}, thickness, max_depth};
    return add_material(scene, material);
  };
  add_mesh(scene, sphere({0.6, 0.5, -0.6}, 0.25, 2), coated(0.1, 1.5, 0.01, 10));
  add_mesh(scene, sphere({0, -0.7, 0.3}, 0.2, 2), coated(0.6, 2.2, 0.3, 0));
  add_mesh(scene, sphere({-0.2, -0.7, -0.3}, 0.2, 2), coated(0, 1.5, 0.01, 10));
  return scene;
}

// Three more lamps: a triangle, a small box and one that hangs right before the wall.
SceneDescription room_of_lamps() {
  SceneDescription scene = room_of_all_kinds();
  const auto lamp = [&](const Vec3d& emission) {
    return add_material(scene, diffuse(Vec3d(0.1)), emission);
  };
  description::Mesh triangle = quad({-0.9, 0.2, -0.5}, {0, 0.4, 0}, {0, 0, 0.4});
  triangle.triangles.resize(1);
  add_mesh(scene, triangle, lamp({1, 2, 9}));
  add_mesh(scene, box({0.6, 0.6, 0.2}, {0.7, 0.7, 0.3}), lamp({20, 5, 5}));
  add_mesh(scene, quad({-0.3, -0.3, -0.99}, {0.6, 0, 0}, {0, 0.6, 0}), lamp({2, 3, 1}));
  return scene;
}

// Thousands of lamps: they are picked by a table.
SceneDescription room_of_many_lamps() {
  SceneDescription scene = room_of_all_kinds();
  add_mesh(scene, sphere({0, 0.6, 0.6}, 0.05, 4),
           add_material(scene, diffuse(Vec3d(0)), {9, 9, 5}));
  return scene;
}

description::ImageHandle add_image(SceneDescription& scene, const std::string& path,
                                   description::Encoding encoding) {
  scene.images.push_back({path, encoding, description::Wrap::Repeat, {}});
  return description::ImageHandle(scene.images.size() - 1);
}
description::ImageHandle add_image(SceneDescription& scene, const TemporaryFolder& folder,
                                   const std::string& name, const crafted::Samples& texel) {
  return add_image(scene, folder.put(name, crafted::png_rgba(8, 8, texel)),
                   description::Encoding::Linear);
}
// From 0 to 2.25 in the lab's encoding: what surfaces take for at most 1.
description::ImageHandle add_bright_image(SceneDescription& scene, const TemporaryFolder& folder) {
  crafted::Bytes bytes = crafted::text("PF\n4 4\n-1.0\n");
  for (int i = 0; i < 48; ++i) {
    const float value = 0.05f * static_cast<float>(i % 46);
    const auto raw = std::bit_cast<std::array<unsigned char, 4>>(value);
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  }
  return add_image(scene, folder.put("bright.pfm", bytes), description::Encoding::LabGamma);
}

// Maps of colours in the lab's encoding and without, of highlights that are black in places, of
// heights and of normals.
SceneDescription room_of_maps(const TemporaryFolder& folder) {
  SceneDescription scene = room_of_all_kinds();
  const auto colours = add_image(scene, folder, "colours.png", [](int x, int y, int c) {
    return 30u * unsigned(x ^ y) + 9u * unsigned(c);
  });
  const auto highlights = add_image(scene, folder, "highlights.png", [](int x, int y, int c) {
    return x < 4 ? 0u : 60u + 20u * unsigned(y) + 3u * unsigned(c);
  });
  const auto heights = add_image(scene, folder, "heights.png",
                                 [](int x, int y, int) { return 17u * unsigned(x ^ (7 - y)); });
  const auto normals = add_image(scene, folder, "normals.png", [](int x, int y, int c) {
    return c == 2 ? 230u : 128u + 7u * unsigned(c == 0 ? x : y);
  });
  const auto encoded =
      add_image(scene, folder.file("colours.png"), description::Encoding::LabGamma);
  const auto bright = add_bright_image(scene, folder);
  const auto surface = [&](decltype(description::Material::model) model) -> description::Material& {
    return scene.materials[add_material(scene, std::move(model)).index];
  };
  const auto last = [&] { return MaterialHandle(scene.materials.size() - 1); };
  description::Material& bumpy = surface(description::DiffuseMaterial{{Vec3d(0.9), encoded}});
  bumpy.height = heights;
  bumpy.height_scale = 0.1;
  add_mesh(scene, quad({-0.9, -0.5, -0.95}, {0.8, 0, 0}, {0, 0.8, 0}), last());
  CookTorranceMaterial rough = glossy(0.3);
  rough.diffuse.map = bright;
  surface(rough).normal_map = normals;
  add_mesh(scene, quad({0.1, -0.5, -0.95}, {0.8, 0, 0.1}, {0, 0.8, 0}), last());
  surface(description::LabMaterial{.diffuse = {Vec3d(0.5), encoded},
                                   .specular = {Vec3d(1), highlights}});
  add_mesh(scene, quad({-0.6, -0.7, 0.2}, {0.9, 0.1, 0}, {0, 0.6, -0.3}), last());
  surface(description::LabMaterial{
      .diffuse = {Vec3d(0.4), {}}, .specular = {Vec3d(0.3), {}}, .shininess = 40});
  add_mesh(scene, quad({-0.9, -0.95, -0.9}, {0, 0, 1.8}, {1.8, 0, 0}), last());
  description::ConductorMaterial metal;
  metal.roughness = {0.4, {}, 0};
  metal.reflectance = {Vec3d(0.9), colours};
  surface(metal);
  add_mesh(scene, quad({0.5, -0.9, 0.6}, {0.4, 0, -0.2}, {0, 0.5, 0.1}), last());
  CoatedDiffuseMaterial coated{{Vec3d(0.9), colours}, {.roughness = {0.25, {}, 0}}};
  surface(coated).height = heights;
  add_mesh(scene, quad({-0.9, -0.4, 0.7}, {0.7, 0, -0.2}, {0, 0.7, 0.1}), last());
  return scene;
}

// Glass and mirrors, where lights are not sampled; and what lanes leave to single steps, so that
// paths come from there and go there: rough glass, panes and spheres. And an instance.
SceneDescription room_of_strangers(const TemporaryFolder& folder) {
  SceneDescription scene = room_of_maps(folder);
  const auto glass = add_material(scene, description::DielectricMaterial{});
  add_mesh(scene, sphere({0.5, 0.1, 0.5}, 0.3, 4), glass);
  add_mesh(scene, sphere({-0.2, 0.2, 0.6}, 0.15, 1),
           add_material(
               scene, description::DielectricMaterial{.ior = 2.2, .transmittance = {1, 0.9, 0.5}}));
  add_mesh(scene, sphere({0, -0.3, 0.6}, 0.2, 1),
           add_material(scene, description::DielectricMaterial{.roughness = {0.3, {}, 0}}));
  add_mesh(scene, quad({-0.3, 0.6, -0.2}, {0.5, 0, 0.2}, {0, 0.1, 0.5}),
           add_material(scene, description::DielectricMaterial{.is_thin = true}));
  const auto mirror = add_material(scene, description::MirrorMaterial{{Vec3d(0.9), {}}});
  add_mesh(scene, quad({-0.98, -0.9, -0.9}, {0, 0, 1.5}, {0, 1.5, 0}), mirror);
  add_mesh(scene, exact_sphere(0.2), add_material(scene, diffuse({0.2, 0.8, 0.4})),
           at_place({-0.5, 0, 0.5}));
  const auto box_mesh = add_mesh(scene, box({0, 0, 0}, {0.2, 0.2, 0.2}),
                                 add_material(scene, diffuse({0.8, 0.2, 0.4})));
  add_instance(scene, box_mesh, at_place({0.3, 0.4, 0.1}));
  return scene;
}

// Of flat and of smooth meshes, one of them with bumps: turned, stretched and mirrored.
SceneDescription room_of_instances(const TemporaryFolder& folder) {
  SceneDescription scene = room_of_maps(folder);
  const Transform turned{Mat3d({0.8, 0.3, 0}, {-0.3, 0.8, 0.2}, {0, -0.2, 0.7}), {0.4, 0.1, 0.3}};
  const Transform mirrored{Mat3d({-0.9, 0, 0.2}, {0, 1.6, 0}, {0.2, 0, 0.5}), {-0.4, -0.3, 0.2}};
  const auto place_twice = [&](const description::Mesh& mesh, MaterialHandle material) {
    add_instance(scene, add_mesh(scene, mesh, material, turned), mirrored);
  };
  place_twice(box({0.1, 0.1, 0}, {0.3, 0.4, 0.2}), add_material(scene, diffuse({0.8, 0.2, 0.4})));
  place_twice(sphere({-0.1, -0.2, 0.1}, 0.2, 2), add_material(scene, glossy(0.3)));
  const MaterialHandle bumpy = add_material(scene, description::LabMaterial{});
  scene.materials[bumpy.index].height = description::ImageHandle(2);
  scene.materials[bumpy.index].height_scale = 0.2;
  place_twice(quad({-0.5, 0, 0.3}, {0.4, 0, 0.1}, {0, 0.4, 0}), bumpy);
  return scene;
}

void expect_general(const SceneDescription& description, const RenderSettings& settings,
                    const std::string& what) {
  expect_single_steps(description, settings, "path/lanes", what);
}

// Whole blocks and parts of them.
TEST(Agreement_PlainLanes, AreSingleStepsOnEverySurface) {
  for (const int samples : {64, 21, 3})
    expect_general(room_of_all_kinds(), settings_of(32, samples), fmt::format("{} spp", samples));
}

TEST(Agreement_PlainLanes, AreSingleStepsUnderEveryLamp) {
  for (const LightSampling sampling :
       {LightSampling::Triangles, LightSampling::Area, LightSampling::SolidAngle}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.light_sampling = sampling;
    const std::string what = fmt::format("sampling {}", static_cast<int>(sampling));
    expect_general(room_of_lamps(), settings, what);
    expect_general(room_of_many_lamps(), settings, what + ", many");
  }
}

TEST(Agreement_PlainLanes, AreSingleStepsOfSplitPaths) {
  for (const std::uint32_t splitting : {2u, 5u}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.plan.splitting = splitting;
    settings.options.plan.roulette_threshold = 0.5f;
    settings.options.lamp_rays = 3;
    expect_general(room_of_lamps(), settings, fmt::format("splitting {}", splitting));
  }
}

TEST(Agreement_PlainLanes, AreSingleStepsUpToADepth) {
  for (const int depth : {0, 1, 2, 5}) {
    for (const std::uint32_t splitting : {1u, 3u}) {
      RenderSettings settings = settings_of(24, 32);
      settings.options.max_depth = depth;
      settings.options.plan.splitting = splitting;
      expect_general(room_of_lamps(), settings, fmt::format("depth {}, {}", depth, splitting));
    }
  }
}

TEST(Agreement_PlainLanes, AreSingleStepsWhateverMapsSay) {
  const TemporaryFolder folder;
  for (const std::uint32_t splitting : {1u, 3u}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.plan.splitting = splitting;
    const std::string what = fmt::format("splitting {}", splitting);
    expect_general(room_of_maps(folder), settings, what);
    expect_general(room_of_strangers(folder), settings, what + ", strangers");
  }
}

TEST(Agreement_PlainLanes, AreSingleStepsOnInstances) {
  const TemporaryFolder folder;
  for (const std::uint32_t splitting : {1u, 3u}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.plan.splitting = splitting;
    const SceneDescription scene = room_of_instances(folder);
    ASSERT_EQ(compiled(scene, settings.options).instances.size(), 6u);
    expect_general(scene, settings, fmt::format("splitting {}", splitting));
  }
}

// Lights that are sampled at every hit, of each kind, or picked, where they are more than four.
TEST(Agreement_PlainLanes, AreSingleStepsUnderLightsWithoutArea) {
  const TemporaryFolder folder;
  const RenderSettings settings = settings_of(32, 32);
  SceneDescription scene = room_of_strangers(folder);
  const auto check = [&](const auto& light, const std::string& what) {
    add_light(scene, light);
    expect_general(scene, settings, what);
  };
  check(description::PointLight{{0.2, 0.3, 0.4}, {0.2, 0.3, 0.1}}, "a point");
  check(description::SpotLight{{0, 0.2, 0.9}, {0, -0.6, -0.8}, Vec3d(3), 0.2, 0.6}, "a spot");
  check(description::DirectionalLight{{0, 0.6, 0.8}, {1, 0.9, 0.8}}, "a sun");
  check(
      description::ProjectionLight{
          .position = {0.1, 0.1, 0.8}, .intensity = Vec3d(2), .image = description::ImageHandle(0)},
      "a projector");
  check(description::PointLight{{-0.5, 0.6, 0.1}, {0.1, 0.1, 0.4}}, "more than four");
  check(description::ConstantEnvironment{{0.3, 0.4, 0.5}}, "a sky");
}

TEST(Agreement_PlainLanes, AreSingleStepsUnderLampsThatAreNoPlainTriangles) {
  const TemporaryFolder folder;
  SceneDescription scene = room_of_maps(folder);
  add_mesh(scene, exact_sphere(0.1), add_material(scene, diffuse(Vec3d(0)), Vec3d(9)),
           at_place({-0.6, 0.3, 0.3}));
  const auto textured = add_material(scene, diffuse(Vec3d(0)), {6, 5, 4});
  scene.materials[textured.index].emission_map = description::ImageHandle(0);
  add_mesh(scene, quad({0.98, -0.3, -0.3}, {0, 0, 0.6}, {0, 0.6, 0}), textured);
  expect_general(scene, settings_of(32, 32), "a ball and a screen");
}

// From outside and from within, by both sides, with an image; and beside flat lamps.
TEST(Agreement_PlainLanes, AreSingleStepsUnderSpheresThatShine) {
  const TemporaryFolder folder;
  SceneDescription scene = room_of_maps(folder);
  const auto add_ball = [&](const description::Mesh& ball, double emission, const Vec3d& place) {
    const MaterialHandle lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(emission));
    add_mesh(scene, ball, lamp, at_place(place));
    return lamp.index;
  };
  add_ball(exact_sphere(0.1), 9, {-0.6, 0.3, 0.3});
  expect_general(scene, settings_of(32, 32), "a ball");
  add_ball(exact_sphere(5, true), 0.2, {0, 0, 0});
  expect_general(scene, settings_of(32, 32), "all about");
  scene.materials[add_ball(exact_sphere(0.3), 0.5, {0.5, -0.5, 0.2})].emits_both_sides = true;
  expect_general(scene, settings_of(32, 32), "both sides");
  scene.materials[add_ball(exact_sphere(0.1), 3, {0.4, 0.4, 0.4})].emission_map =
      description::ImageHandle(0);
  expect_general(scene, settings_of(32, 32), "an image");
}

TEST(Agreement_PlainLanes, AreSingleStepsUnderASky) {
  const TemporaryFolder folder;
  SceneDescription scene = room_of_maps(folder);
  description::LatLongEnvironment sky;
  sky.image = description::ImageHandle(0);
  add_light(scene, sky);
  for (const std::uint32_t splitting : {1u, 3u}) {
    RenderSettings settings = settings_of(32, 32);
    settings.options.plan.splitting = splitting;
    expect_general(scene, settings, fmt::format("splitting {}", splitting));
  }
}

TEST(Agreement_PlainLanes, NeedNoLamp) {
  SceneDescription scene = furnace(inside_out(sphere({0, 0, 0}, 1, 2)), 0.5, 0.5);
  RenderSettings settings = settings_of(8, 32);
  const Scene lit = compiled(scene, settings.options);
  for (description::Material& material : scene.materials) material.emission = Vec3d(0);
  const RenderResult dark = rendered(compiled(scene, settings.options), settings);
  EXPECT_EQ(dark.statistics.kernel, "path/lanes");
  EXPECT_EQ(dark.statistics.rays.shadow, 0u);
  EXPECT_EQ(mean_of(dark.film.to_image(false)), 0);
  EXPECT_GT(mean_of(picture(lit, settings)), 0.9);
}

// Which blocks travel together depends on where passes are cut, and changes nothing.
TEST(Agreement_PlainLanes, DoNotDependOnWhoTravelsAlong) {
  RenderSettings settings = settings_of(20, 64);
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(room_of_lamps(), settings.options);
  expect_same_over_cuts<lane_features>(scene, settings, {0, 64},
                                       {{0, 16, 32, 48, 64}, {0, 48, 64}, {0, 1, 17, 60, 64}});
}

// Else what a lane without a path has of earlier ones is weighed: no picture shows it, but
// divisions by nothing end builds with traps.
TEST(Unit_PlainLanes, LanesWithoutAPathHaveNoSampleOfALamp) {
  for (const bool is_sphere : {false, true}) {
    PlainLanes lanes;
    lanes.filled = 1;
    lanes.light_samples.pdf.fill(1);  // of a light that all hits ask
    (is_sphere ? lanes.lamps.is_sphere : lanes.lamps.is_other)[0] = 1;
    lanes.lamps.is_sphere[1] = 1;
    lanes.lamps.position.x.fill(3);
    lanes.lamps.edge1.x.fill(1);  // the radius
    lanes.lamps.emission.x.fill(1);
    lanes.met.position.x[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(sample_lamps(lanes), is_sphere ? 0u : 1u);
    for (std::size_t i = 1; i < block_size; ++i) EXPECT_EQ(lanes.light_samples.pdf[i], 0) << i;
    EXPECT_EQ(lanes.light_samples.pdf[0] > 0, is_sphere);
  }
}

// As any ray that goes astray makes its sample an invalid one (set_ray()).
TEST(Unit_PlainLanes, PathsWhoseRaysCannotBeTracedAreLost) {
  PlainLanes lanes;
  lanes.filled = all_lanes;
  lanes.met.normal.z.fill(1);
  lanes.met.shading_normal.z.fill(1);
  lanes.met.throughput.x.fill(1);
  lanes.met.roulette_scale.fill(1);
  lanes.bsdfs.diffuse.x.fill(0.5f);
  lanes.scattered.direction_x.fill(0.4f);
  lanes.scattered.direction_y.fill(0.7f);
  lanes.met.position.x[3] = 1e16f;
  lanes.met.position.z[9] = std::numeric_limits<float>::quiet_NaN();
  lanes.scattered.bounce[9] = lanes.scattered.bounce[10] = Roulette{}.first_bounce;
  lanes.scattered.roulette[10] = 0.99f;        // ended: of a throughput below it
  const FloatingPointTraps traps(Traps::Off);  // comparisons with NaN raise them
  const ScatterMasks masks = scatter(PlainModel::Diffuse, Roulette{}, lanes);
  EXPECT_EQ(masks.lost, 1u << 3 | 1u << 9);
  EXPECT_EQ(masks.going_on, all_lanes & ~(1u << 3 | 1u << 9 | 1u << 10));
}

}  // namespace
}  // namespace candela
