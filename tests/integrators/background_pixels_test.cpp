// Pixels of which it is claimed that they see only background: no ray may meet anything there, most
// of those that do see only background are found, and the picture is the one that rays would give.
#include "integrators/background_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "integrators/projected_bounds.h"
#include "integrators/render_options.h"
#include "renderer/accel/any_accel.h"
#include "renderer/accel/bvh_accel.h"
#include "renderer/math/constants.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/soups.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// A few small balls beside each other, as one mesh or as instances, in a constant sky.
SceneDescription balls(bool are_instances) {
  SceneDescription scene;
  const auto white = add_material(scene, diffuse(Vec3d(0.7)));
  const auto ball = add_mesh(scene, sphere({0, 0, 0}, 0.3, 2), white);
  const Transform placed[] = {{Mat3d(1), {-1, 0.2, 0}}, {Mat3d(1), {0.9, -0.4, -1}}};
  for (const Transform& transform : placed)
    if (are_instances)
      add_instance(scene, ball, transform);
    else
      add_mesh(scene, sphere(transform.translation, 0.3, 2), white);
  add_light(scene, description::ConstantEnvironment{Vec3d(0.2, 0.5, 0.9)});
  set_camera(scene, {0, 0, 5}, {0, 0, 0}, 50);
  return scene;
}

// The same under a sky that is an image.
SceneDescription under_map(SceneDescription scene) {
  scene.images = {light_test::write_float_map("background", 16, 16, [](int x, int y) {
    return Vec3f(static_cast<float>(x), static_cast<float>(y), (x * 5 + y * 3) % 7 == 0 ? 9.0f : 1);
  })};
  scene.lights.clear();
  add_light(scene, description::EqualAreaEnvironment{description::ImageHandle(0), Vec3d(0.1),
                                                     Mat3d(1.0), true});
  return scene;
}

struct Claim {
  int claimed = 0;  // pixels
  int wrong = 0;    // of them, with a ray that meets something
  int missed = 0;   // pixels of which no ray met anything and of which nothing was claimed
};

// Camera rays at n x n places of each pixel's filter, its edges among them.
Claim checked(const SceneDescription& description, const RenderSettings& settings) {
  const Scene scene = compiled(description, settings.options);
  const Filter filter = make_filter(settings.options);
  const BackgroundPixels background(scene, filter, settings.options);
  const BvhAccel accelerator(scene);
  const Camera& camera = scene.cameras[0];
  const auto width = static_cast<float>(settings.options.width);
  const auto height = static_cast<float>(settings.options.height);
  Claim claim;
  for (int y = 0; y < settings.options.height; ++y)
    for (int x = 0; x < settings.options.width; ++x) {
      constexpr int n = 5;
      bool meets = false;
      for (int i = 0; i < n * n; ++i) {
        Vec2f u{static_cast<float>(i % n) / (n - 1), static_cast<float>(i / n) / (n - 1)};
        Vec2f place = filter.sample(glm::min(u, Vec2f(one_minus_epsilon)));
        Vec2f film{(static_cast<float>(x) + 0.5f + place.x) / width,
                   (static_cast<float>(y) + 0.5f + place.y) / height};
        meets |= accelerator.intersect(camera.generate_ray(film, Vec2f(0))).is_hit();
      }
      const bool is_claimed = background.contains(x, y);
      claim.claimed += is_claimed;
      claim.wrong += is_claimed && meets;
      claim.missed += !is_claimed && !meets;
    }
  return claim;
}

RenderSettings settings_for(FilterKind filter, int size = 48, int samples = 64) {
  RenderSettings settings = settings_of(size, samples);
  settings.options.filter = filter;
  return settings;
}

TEST(Agreement_BackgroundPixels, NoRayMeetsAnythingAndFewAreMissed) {
  for (const bool are_instances : {false, true})
    for (const FilterKind filter : {FilterKind::Box, FilterKind::BlackmanHarris}) {
      const Claim claim = checked(balls(are_instances), settings_for(filter));
      EXPECT_EQ(claim.wrong, 0);
      EXPECT_GT(claim.claimed, 48 * 48 * 2 / 3);
      EXPECT_LT(claim.missed, 48 * 48 / 12) << "instances: " << are_instances;
    }
}

TEST(Agreement_BackgroundPixels, NeitherInOrthographicPictures) {
  SceneDescription scene = balls(false);
  scene.cameras[0].kind = CameraKind::Orthographic;
  scene.cameras[0].screen_window = description::ScreenWindow{-2, 2, -2, 2};
  const Claim claim = checked(scene, settings_for(FilterKind::Triangle));
  EXPECT_EQ(claim.wrong, 0);
  EXPECT_GT(claim.claimed, 48 * 48 / 2);
}

// Triangles about the camera, before and behind it and across its plane, in views wide and narrow.
TEST(Agreement_BackgroundPixels, NorAmongTrianglesAllAround) {
  int claimed = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SceneDescription scene;
    const auto white = add_material(scene, diffuse(Vec3d(0.5)));
    for (const Triangle& t : random_soup(12, 0.8f, seed))
      add_mesh(scene, triangle(Vec3d(t[0]), Vec3d(t[1]), Vec3d(t[2])), white);
    const double angles[] = {0.05, 10, 60, 140};
    set_camera(scene, {0.3, -0.2, 0.4}, {1, 0.5 * static_cast<double>(seed % 5) - 1, 0},
               angles[seed % 4]);
    const Claim claim = checked(scene, settings_for(FilterKind::Box, 24, 64));
    EXPECT_EQ(claim.wrong, 0) << "seed " << seed;
    claimed += claim.claimed;
  }
  EXPECT_GT(claimed, 30 * 24 * 24 / 10);
}

// Exact spheres and instances of them.
TEST(Agreement_BackgroundPixels, NorAtExactSpheres) {
  for (const bool are_instances : {false, true}) {
    SceneDescription scene = balls(are_instances);
    for (description::Mesh& mesh : scene.meshes) {
      const auto materials = mesh.materials;
      mesh = exact_sphere(0.3);
      mesh.materials = materials;
    }
    scene.instances[1].object_to_world = at_place({0.9, -0.4, -1}, 1.5);
    const Claim claim = checked(scene, settings_for(FilterKind::Box));
    EXPECT_EQ(claim.wrong, 0);
    EXPECT_GT(claim.claimed, 48 * 48 * 2 / 3);
    EXPECT_LT(claim.missed, 48 * 48 / 12) << "instances: " << are_instances;
  }
}

// A ground that passes below the camera and behind it hides what is below the horizon alone.
TEST(Unit_BackgroundPixels, AGroundLeavesTheSky) {
  SceneDescription scene;
  const auto white = add_material(scene, diffuse(Vec3d(0.5)));
  add_mesh(scene, quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}), white);
  set_camera(scene, {0, 1, 0}, {0, 1, -5}, 60);
  const Claim claim = checked(scene, settings_for(FilterKind::Box, 32));
  EXPECT_EQ(claim.wrong, 0);
  EXPECT_GE(claim.claimed, 32 * 14);
}

TEST(Unit_ProjectedBounds, AreThoseOfTheCorners) {
  Camera camera;
  camera.right = {0.5f, 0, 0};
  camera.up = {0, 1, 0};
  const Projection projection(camera, 1);
  const std::array points{projection.point({0, 0, -2}), projection.point({1, 0, -2}),
                          projection.point({0, 1, -4})};
  const FilmBounds bounds = projection.bounds(points);
  EXPECT_NEAR(bounds.lower.x, 0, 1e-4);
  EXPECT_NEAR(bounds.upper.x, 1, 1e-4);
  EXPECT_NEAR(bounds.lower.y, 0, 1e-4);
  EXPECT_NEAR(bounds.upper.y, 0.25, 1e-4);
  EXPECT_LT(bounds.lower.x, 0);
  EXPECT_GT(bounds.upper.x, 1);
  const std::array behind{projection.point({0, 0, 2}), projection.point({1, 3, 1})};
  EXPECT_TRUE(projection.bounds(behind).is_empty());
  const std::array across{projection.point({-1, 1, -1}), projection.point({-1, 1, 1})};
  EXPECT_EQ(projection.bounds(across).lower.x, -infinity);
  EXPECT_EQ(projection.bounds(across).upper.y, infinity);
  EXPECT_NEAR(projection.bounds(across).upper.x, -2, 1e-4);
}

RenderResult with_kernel(const Scene& scene, RenderSettings settings, bool is_general) {
  settings.options.uses_general_kernel = is_general;
  return rendered(scene, settings);
}

constexpr AovSet layers = aov_bit(Aov::Albedo) | aov_bit(Aov::Depth) | aov_bit(Aov::MaterialId) |
                          aov_bit(Aov::Samples) | aov_bit(Aov::Variance);

// Within a ball, where no ray meets it, more triangles than are worth a look.
SceneDescription with_hidden_triangles(SceneDescription scene) {
  const auto white = add_material(scene, diffuse(Vec3d(0.7)));
  add_mesh(scene, sphere({0.9, -0.4, -1}, 0.2, 6), white);
  return scene;
}

void expect_same_picture(const SceneDescription& description, const RenderSettings& settings,
                         bool skips) {
  const Scene scene = compiled(description, settings.options);
  const RenderResult general = with_kernel(scene, settings, true);
  const RenderResult special = with_kernel(scene, settings, false);
  const RenderResult traced =
      with_kernel(compiled(with_hidden_triangles(description), settings.options), settings, false);
  EXPECT_EQ(special.film.to_image(true).values, traced.film.to_image(true).values);
  EXPECT_EQ(special.film.to_image(true).values, general.film.to_image(true).values);
  ASSERT_TRUE(special.error && general.error && traced.error);
  EXPECT_EQ(special.error->relmse, traced.error->relmse);
  EXPECT_EQ(traced.statistics.skipped.samples, 0u);
  EXPECT_EQ(special.statistics.skipped.samples > 0, skips);
  EXPECT_EQ(special.statistics.skipped.samples, general.statistics.skipped.samples);
  EXPECT_EQ(special.statistics.rays.camera, general.statistics.rays.camera);
  // Some rays are of pixels beside a crop (path/shared_block.h), whose skipped samples nobody
  // counts.
  if (!settings.options.crop) {
    EXPECT_EQ(special.statistics.rays.camera + special.statistics.skipped.samples,
              traced.statistics.rays.camera);
  }
  EXPECT_EQ(special.statistics.rays.indirect, traced.statistics.rays.indirect);
}

TEST(Agreement_BackgroundPixels, SkippedSamplesLeaveThePictureAsItIs) {
  RenderSettings settings = settings_for(FilterKind::BlackmanHarris, 40, 40);
  settings.options.aovs = layers;
  expect_same_picture(balls(false), settings, true);
  expect_same_picture(balls(true), settings, true);
  settings.options.transparent = true;
  settings.options.clamp = 0.3f;
  expect_same_picture(balls(false), settings, true);
  settings.options.transparent = false;
  expect_same_picture(balls(false), settings, true);
  settings.options.crop = PixelRect{3, 1, 30, 17};
  settings.options.tile_size = 7;
  expect_same_picture(balls(false), settings, true);
}

// Whose samples ask the image, but trace no ray.
TEST(Agreement_BackgroundPixels, NeitherDoThoseOfAnImage) {
  RenderSettings settings = settings_for(FilterKind::BlackmanHarris, 40, 40);
  expect_same_picture(under_map(balls(false)), settings, true);
  expect_same_picture(under_map(balls(true)), settings, true);
  settings.options.clamp = 0.3f;
  settings.options.aovs = layers;
  settings.options.crop = PixelRect{3, 1, 30, 17};
  settings.options.tile_size = 7;
  expect_same_picture(under_map(balls(false)), settings, true);
  settings = settings_for(FilterKind::Box, 64, 128);
  settings.options.adaptive = true;
  expect_same_picture(under_map(balls(false)), settings, true);
  settings.options.replicates = 5;  // whose pilot does not fill blocks, so that pixels share them
  expect_same_picture(under_map(balls(false)), settings, true);
}

// A lens changes where rays come from and where they go.
TEST(Agreement_BackgroundPixels, AnImageAloneIsTheSameThroughALens) {
  SceneDescription scene = under_map(empty_scene());
  set_camera(scene, {0, 0, 5}, {0, 0, 0}, 50);
  scene.cameras[0].lens_radius = 0.1;
  RenderSettings settings = settings_for(FilterKind::BlackmanHarris, 16, 24);
  const RenderResult skipped = rendered(compiled(scene, settings.options), settings);
  settings.options.savings.skips_background = false;
  const RenderResult traced = rendered(compiled(scene, settings.options), settings);
  EXPECT_EQ(skipped.film.to_image(true).values, traced.film.to_image(true).values);
  EXPECT_EQ(skipped.statistics.skipped.samples, 16u * 16 * 24);
  EXPECT_EQ(traced.statistics.rays.camera, 16u * 16 * 24);
}

TEST(Agreement_BackgroundPixels, AdaptiveAndSplitPicturesToo) {
  RenderSettings settings = settings_for(FilterKind::Box, 64, 128);
  settings.options.adaptive = true;
  settings.options.aovs = layers;
  settings.options.replicates = 5;  // whose pilot does not fill blocks, so that pixels share them
  expect_same_picture(balls(false), settings, true);
  settings.options.replicates = 4;
  settings.options.plan = {4, 0.25f};
  expect_same_picture(balls(false), settings, true);
}

// Triangles of three colours in the very same places: which of them a ray of a packet meets may
// depend on the others in it, and so on which pixels share blocks.
SceneDescription triangles_of_three_colours() {
  SceneDescription scene;
  description::Mesh mesh;
  for (const Triangle& t : random_soup(400, 0.1f, 1))
    mesh = merged(mesh, triangle(Vec3d(t[0]), Vec3d(t[1]), Vec3d(t[2])));
  for (const Vec3d& colour : {Vec3d(0.9, 0.1, 0.1), Vec3d(0.1, 0.9, 0.1), Vec3d(0.1, 0.1, 0.9)}) {
    add_mesh(scene, mesh, add_material(scene, diffuse(colour)));
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  }
  add_light(scene, description::ConstantEnvironment{Vec3d(0.5)});
  set_camera(scene, {0, 0, 5}, {0, 0, 0}, 40);
  return scene;
}

TEST(Agreement_BackgroundPixels, CoincidentSurfacesAreTheSameInCropsAndByAnyKernel) {
  constexpr int side = 128;
  RenderSettings settings = settings_for(FilterKind::Box, side, 3);
  settings.accelerator = AcceleratorKind::Embree;
  const Scene scene = compiled(triangles_of_three_colours(), settings.options);
  const RenderResult whole = rendered(scene, settings);
  EXPECT_GT(whole.statistics.skipped.samples, 0u);
  const Image image = whole.film.to_image(true);
  EXPECT_EQ(with_kernel(scene, settings, true).film.to_image(true).values, image.values);
  constexpr int part = 16;
  for (int y = 0; y < side; y += part)
    for (int x = 0; x < side; x += part) {
      settings.options.crop = PixelRect{x, y, x + part, y + part};
      expect_part(picture(scene, settings), image, *settings.options.crop);
    }
}

// The squares that huge pictures are looked at by, instead of pixels, leave no more out than that.
TEST(Agreement_BackgroundPixels, OfHugePicturesAreFoundBySquares) {
  const RenderSettings large = settings_for(FilterKind::Box, 1 << 14, 1);
  const RenderSettings small = settings_for(FilterKind::Box, 1 << 11, 64);
  const Scene scene = compiled(balls(false), small.options);
  const Filter filter = make_filter(small.options);
  const BackgroundPixels by_squares(scene, filter, large.options);
  const BackgroundPixels by_pixels(scene, filter, small.options);
  int differing = 0;
  for (int y = 0; y < 1 << 11; ++y)
    for (int x = 0; x < 1 << 11; ++x) {
      const bool is_seen = by_squares.contains(8 * x, 8 * y);
      EXPECT_EQ(by_squares.contains(8 * x + 7, 8 * y + 7), is_seen);
      differing += by_pixels.contains(x, y) != is_seen;
    }
  EXPECT_LT(differing, (1 << 22) / 100);
}

// Nothing is in the way of any camera, and a black background has no error.
TEST(Unit_BackgroundPixels, AreAllOfASceneWithoutSurfaces) {
  SceneDescription scene = empty_scene();
  add_light(scene, description::ConstantEnvironment{Vec3d(0.1), false});
  set_camera(scene, {0, 0, 5}, {0, 0, 0}, 50);
  scene.cameras[0].lens_radius = 0.1;
  RenderSettings settings = settings_for(FilterKind::BlackmanHarris, 16, 1 << 30);
  settings.options.target_relmse = 1e-4;
  const RenderResult result = rendered(compiled(scene, settings.options), settings);
  EXPECT_EQ(result.statistics.stop, StopReason::Error);
  EXPECT_EQ(result.statistics.rays.camera, 0u);
  ASSERT_TRUE(result.error);
  EXPECT_EQ(result.error->relmse, 0);
}

// Of rules that end a picture early nobody knows how many samples they leave.
TEST(Unit_BackgroundPixels, AreLookedForByTheSamplesThatAreSure) {
  RenderSettings settings = settings_for(FilterKind::Box, 16, 1 << 30);
  const Scene scene = compiled(with_hidden_triangles(balls(false)), settings.options);
  const Filter filter = make_filter(settings.options);
  EXPECT_FALSE(BackgroundPixels(scene, filter, settings.options).is_empty());
  settings.options.time_limit_seconds = 1;
  EXPECT_TRUE(BackgroundPixels(scene, filter, settings.options).is_empty());
}

TEST(Agreement_BackgroundPixels, NothingIsSkippedWhereSamplesDiffer) {
  RenderSettings settings = settings_for(FilterKind::Mitchell, 32, 64);
  expect_same_picture(balls(false), settings, false);
  settings.options.filter = FilterKind::Box;
  SceneDescription with_lens = balls(false);
  with_lens.cameras[0].lens_radius = 0.1;
  expect_same_picture(with_lens, settings, false);
  SceneDescription all_around = balls(false);
  all_around.cameras[0].kind = CameraKind::LatLong;
  expect_same_picture(all_around, settings, false);
}

}  // namespace
}  // namespace candela
