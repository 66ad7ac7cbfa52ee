// The pilot of adaptive sampling: of which pixels, and with how many samples.
#include "integrators/pilot.h"

#include <gtest/gtest.h>

#include <atomic>

#include "integrators/render_rounds.h"
#include "tests/integrators/synthetic_tile.h"

namespace candela {
namespace {

RenderOptions options_with(int samples) {
  RenderOptions options;
  options.width = 70;
  options.height = 50;
  options.samples_per_pixel = samples;
  options.adaptive = true;
  return options;
}

TEST(Unit_Pilot, HasAQuarterOfTheSamplesUpToSixtyFour) {
  EXPECT_EQ(pilot_of(options_with(63)).samples, 0u);
  EXPECT_EQ(pilot_of(options_with(64)).samples, 16u);
  EXPECT_EQ(pilot_of(options_with(128)).samples, 32u);
  EXPECT_EQ(pilot_of(options_with(10000)).samples, 64u);
  RenderOptions options = options_with(10000);
  options.time_limit_seconds = 1;
  EXPECT_EQ(pilot_of(options).samples, 16u);
}

// Where a pixel has one sequence, pieces of it tell the pilot's noise: they need a film of its own.
TEST(Unit_Pilot, OfOneReplicateHasPieces) {
  RenderOptions options = options_with(192);
  const PixelRect whole = pilot_of(options).rect;
  EXPECT_TRUE(pilot_of(options).fits(whole, 4));
  EXPECT_FALSE(pilot_of(options).fits({0, 0, 8, 8}, 4));
  options.replicates = 1;
  const Pilot pilot = pilot_of(options);
  EXPECT_EQ(pilot.samples, 48u);
  EXPECT_EQ(pilot.sums, 4u);
  EXPECT_FALSE(pilot.fits(whole, 1));
  options.samples_per_pixel = 63;
  EXPECT_EQ(pilot_of(options).samples, 0u);
}

TEST(Unit_Pilot, IsOfTheWholePictureWhereACropHasTheSamePixels) {
  RenderOptions options = options_with(128);
  options.crop = PixelRect{33, 10, 41, 12};
  EXPECT_EQ(pilot_of(options).rect, (PixelRect{0, 0, 70, 50}));
}

// A crop that ends where it is good enough itself has pixels of its own anyway; those beside it in
// squares that share blocks are asked for.
TEST(Unit_Pilot, IsOfTheCropWhereAnotherRuleMayEndIt) {
  RenderOptions options = options_with(128);
  options.crop = PixelRect{33, 12, 41, 13};
  options.target_relmse = 1;
  EXPECT_EQ(pilot_of(options).rect, (PixelRect{32, 12, 44, 16}));
  options.target_relmse.reset();
  options.time_limit_seconds = 1;
  options.crop = PixelRect{69, 47, 70, 50};
  EXPECT_EQ(pilot_of(options).rect, (PixelRect{68, 44, 70, 50}));
}

TEST(Unit_Pilot, ACropWithAGoalRendersNothingFarFromIt) {
  RenderOptions options = options_with(1 << 12);
  options.crop = PixelRect{33, 10, 41, 13};
  options.target_relmse = 1e-3;
  Film film(options.width, options.height, *options.crop, 0, 4);
  std::atomic<bool> is_near = true;
  const RoundsDone done = render_rounds(
      options,
      [&](const TilePass& pass, Film& target) {
        const PixelRect& tile = pass.tile;
        if (tile.x0 < 32 || tile.y0 < 8 || tile.x1 > 44 || tile.y1 > 16) is_near = false;
        return test::synthetic_tile(pass, target, [](std::uint64_t bits, int x, int) {
          return 1 + (x < 37 ? 0.1 : 1) * test::unit_double(bits);
        });
      },
      film, nullptr, nullptr);
  EXPECT_EQ(done.stop, StopReason::Error);
  EXPECT_TRUE(is_near);
  EXPECT_GT(film.max_samples(), film.min_samples());
}

}  // namespace
}  // namespace candela
