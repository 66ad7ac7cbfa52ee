// Where in a pixel lamps are said to be seen: no ray elsewhere may meet one, and not much more is
// said than is true.
#include "integrators/lamp_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "integrators/path/find_lamp_pixels.h"
#include "integrators/render_options.h"
#include "renderer/accel/bvh_accel.h"
#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

RenderSettings settings_with(FilterKind filter, int size) {
  RenderSettings settings = settings_of(size, 1024);  // enough for any trial
  settings.options.filter = filter;
  settings.options.lamp_rays = 8;
  return settings;
}

std::vector<LampView> views_of(const Scene& scene, const Filter& filter,
                               const RenderOptions& options) {
  const LampTrial trial = plan_lamp_trial(scene, filter, options);
  if (trial.blocks == 0) return {};
  return trial.views({0, 0, options.width, options.height}, options.width);
}

std::vector<FilterPart> parts_of(const Scene& scene, const Filter& filter,
                                 const RenderOptions& options) {
  const FilterPart nothing{Vec2f(0), Vec2f(0)};
  std::vector<FilterPart> parts(
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height), nothing);
  for (const LampView& view : views_of(scene, filter, options)) parts[view.index] = view.part;
  return parts;
}

struct Found {
  int outside = 0;     // rays that met a lamp outside of the pixel's part
  double seen = 0;     // share of the picture's rays that met one
  double claimed = 0;  // mean of the parts
};

Found checked(const SceneDescription& description, const RenderSettings& settings) {
  const RenderOptions& options = settings.options;
  const Scene scene = compiled(description, options);
  const Filter filter = make_filter(options);
  const std::vector<FilterPart> parts = parts_of(scene, filter, options);
  const BvhAccel accelerator(scene);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  constexpr int rays = 200;
  Found found;
  const double share = 1.0 / static_cast<double>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto x = static_cast<float>(i % static_cast<std::size_t>(options.width));
    const auto y = static_cast<float>(i / static_cast<std::size_t>(options.width));
    found.claimed += share * static_cast<double>(parts[i].share());
    for (int k = 0; k < rays; ++k) {
      const Vec2f u{uniform(random), uniform(random)};
      const Vec2f place = filter.sample(u);
      const Vec2f film{(x + 0.5f + place.x) / static_cast<float>(options.width),
                       (y + 0.5f + place.y) / static_cast<float>(options.height)};
      const Hit hit = accelerator.intersect(scene.cameras[0].generate_ray(film, Vec2f(0)));
      if (!hit.is_hit()) continue;
      found.seen += share / rays;
      const Vec2f end = parts[i].first + parts[i].size;
      found.outside +=
          u.x < parts[i].first.x || u.y < parts[i].first.y || u.x > end.x || u.y > end.y;
    }
  }
  return found;
}

SceneDescription with_camera(const Vec3d& eye, double fovy) {
  SceneDescription scene = empty_scene();
  set_camera(scene, eye, {0, 0, 0}, fovy);
  return scene;
}

// Triangles and balls of all sizes about the camera's view, some behind it, one around it.
SceneDescription scattered_lamps(std::uint32_t seed, bool is_orthographic) {
  SceneDescription scene = with_camera({0.3, 0.2, 3}, 60);
  if (is_orthographic) scene.cameras[0].kind = description::CameraKind::Orthographic;
  const auto lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(1));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto place = [&] { return Vec3d(uniform(random), uniform(random), uniform(random)); };
  const double size = std::exp2(-2 - 2 * static_cast<double>(seed % 3));
  for (int i = 0; i < 4; ++i) {
    const Vec3d corner = 3.0 * place();
    add_mesh(scene, quad(corner, size * place(), size * place()), lamp);
    add_mesh(scene, exact_sphere(size), lamp, at_place(3.0 * place()));
  }
  return scene;
}

TEST(Agreement_LampViews, NoRayMeetsALampElsewhere) {
  for (const FilterKind filter : {FilterKind::Box, FilterKind::Gaussian})
    for (const bool is_orthographic : {false, true}) {
      double seen = 0;
      double claimed = 0;
      for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        const Found found =
            checked(scattered_lamps(seed, is_orthographic), settings_with(filter, 24));
        EXPECT_EQ(found.outside, 0) << seed;
        seen += found.seen;
        claimed += found.claimed;
      }
      EXPECT_GT(seen, 0.01);
      EXPECT_GT(claimed, seen);
    }
}

TEST(Agreement_LampViews, HoldEverythingForACameraWithinALamp) {
  SceneDescription scene = with_camera({0, 0, 0.1}, 60);
  add_mesh(scene, exact_sphere(1), add_material(scene, diffuse(Vec3d(0)), Vec3d(1)));
  const Found found = checked(scene, settings_with(FilterKind::Box, 12));
  EXPECT_EQ(found.outside, 0);
  EXPECT_NEAR(found.claimed, 1, 1e-9);
}

// One lamp's rectangles in its pixels are not much larger than itself: of a ball of half a pixel to
// ten.
TEST(Agreement_LampViews, ClaimLittleMoreThanIsSeen) {
  constexpr int size = 24;
  for (const double pixels : {0.5, 2.0, 10.0}) {
    SceneDescription scene = with_camera({0.01, 0.02, 4}, 30);
    const auto lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(1));
    const double pixel = 2 * 4 * std::tan(15 * pi_double / 180) / size;
    add_mesh(scene, exact_sphere(pixels * pixel / 2), lamp);
    const Found found = checked(scene, settings_with(FilterKind::Box, size));
    EXPECT_GT(found.seen, 0);
    EXPECT_EQ(found.outside, 0);
    EXPECT_LT(found.claimed, 1.5 * found.seen) << pixels;
  }
}

TEST(Agreement_LampViews, OfAPartAreThoseOfTheWhole) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const RenderSettings settings = settings_with(FilterKind::Gaussian, 70);
    const Scene scene = compiled(scattered_lamps(seed, false), settings.options);
    const Filter filter = make_filter(settings.options);
    const std::vector<LampView> whole = views_of(scene, filter, settings.options);
    EXPECT_GT(whole.size(), 20u);
    const LampTrial trial = plan_lamp_trial(scene, filter, settings.options);
    std::size_t found = 0;
    for (const PixelRect& rect :
         {PixelRect{0, 0, 70, 13}, {0, 13, 25, 70}, {25, 13, 70, 40}, {25, 40, 70, 70}}) {
      std::uint32_t before = 0;
      for (const LampView& view : trial.views(rect, 70)) {
        EXPECT_TRUE(
            rect.contains(static_cast<int>(view.index % 70), static_cast<int>(view.index / 70)));
        const auto same = std::ranges::find(whole, view.index, &LampView::index);
        ASSERT_NE(same, whole.end());
        EXPECT_EQ(view.part.first, same->part.first);
        EXPECT_EQ(view.part.size, same->part.size);
        EXPECT_TRUE(before < view.index || before == 0);
        before = view.index;
        ++found;
      }
    }
    EXPECT_EQ(found, whole.size());
  }
}

// Two triangles that fill the view: all of it but for the pixels at the edge that they share lies
// within one.
TEST(Unit_LampViews, HoldTheWholeOfPixelsWithinALamp) {
  SceneDescription scene = with_camera({0, 0, 1}, 60);
  const auto lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(1));
  add_mesh(scene, quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), lamp);
  for (const FilterKind filter : {FilterKind::Box, FilterKind::BlackmanHarris}) {
    const RenderSettings settings = settings_with(filter, 40);
    for (const FilterPart& part : parts_of(compiled(scene, settings.options),
                                           make_filter(settings.options), settings.options))
      EXPECT_TRUE(part.is_whole());
  }
}

// The picture is 2 wide where the lamp is: what of it lies in each of 8x8 pixels is known.
TEST(Unit_LampViews, AreExactForRectanglesAlongTheAxes) {
  SceneDescription scene = with_camera({0, 0, 1}, 90);
  const auto lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(1));
  const double pixel = 0.25;
  add_mesh(scene, quad({0, 0, 0}, {1.25 * pixel, 0, 0}, {0, 0.5 * pixel, 0}), lamp);
  const RenderSettings settings = settings_with(FilterKind::Box, 8);
  const std::vector<FilterPart> parts =
      parts_of(compiled(scene, settings.options), make_filter(settings.options), settings.options);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double expected = i == 3 * 8 + 4 ? 0.5 : i == 3 * 8 + 5 ? 0.125 : 0;
    EXPECT_NEAR(static_cast<double>(parts[i].share()), expected, 1e-4) << i;
  }
  EXPECT_NEAR(parts[3 * 8 + 5].first.x, 0, 1e-4);
  EXPECT_NEAR(parts[3 * 8 + 5].first.y, 0.5, 1e-4);
}

}  // namespace
}  // namespace candela
