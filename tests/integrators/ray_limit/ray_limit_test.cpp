// What --ray-limit measures.
#include <gtest/gtest.h>

#include "integrators/ray_limit/ray_limit.h"
#include "renderer/math/lanes.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

// One pixel by one sample without a bounce is a block of rays in each of at most a thousand rounds.
TEST(Unit_RayLimit, IsOfTheCropAlone) {
  RenderOptions options = test::settings_of(64, 1).options;
  options.max_depth = 0;
  options.crop = PixelRect{41, 37, 42, 38};
  const Scene scene = test::compiled(test::small_room(), options);
  const AnyAccelerator accelerator = build_accelerator(scene, AcceleratorKind::Auto);
  const auto limit = measure_ray_limit(scene, accelerator, options, nullptr);
  ASSERT_TRUE(limit);
  EXPECT_GT(limit->rays, 0u);
  EXPECT_LE(limit->rays, 1000u * block_size);
}

// Paths of one bounce have nothing to share, so that a render with sharing has none.
TEST(Unit_RayLimit, IsOfWhatARenderDoes) {
  RenderOptions options = test::settings_of(16, 1024).options;  // enough for one round
  options.max_depth = 1;
  const Scene scene = test::compiled(test::small_room(), options);
  const AnyAccelerator accelerator = build_accelerator(scene, AcceleratorKind::Auto);
  const auto rays = [&](bool reuses_paths) {
    options.plan.reuses_paths = reuses_paths;
    return measure_ray_limit(scene, accelerator, options, nullptr)->rays;
  };
  EXPECT_EQ(rays(true), rays(false));
}

}  // namespace
}  // namespace candela
