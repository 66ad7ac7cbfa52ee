#include "renderer/sampling/bilinear.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/light/directions.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

constexpr BilinearDensity densities[] = {{1, 1, 1, 1}, {1, 2, 3, 4}, {0, 1, 0, 1},
                                         {0, 0, 0, 1}, {1, 0, 0, 1}, {1e-6f, 1, 1e-6f, 1e-6f}};

// The middle of a cell has a bilinear density's mean over it.
TEST(Statistical_Bilinear, PlacesFollowTheDensity) {
  constexpr int bins = 20;
  constexpr int count = 500'000;
  for (const BilinearDensity& density : densities) {
    std::vector<double> observed(bins * bins), expected(bins * bins);
    for (std::uint64_t i = 0; i < count; ++i) {
      const Vec2f place = density.sample(light_test::random_pair(i, 5));
      ++observed[static_cast<std::size_t>(place.x * bins) * bins +
                 static_cast<std::size_t>(place.y * bins)];
    }
    double sum = 0;
    for (int x = 0; x < bins; ++x)
      for (int y = 0; y < bins; ++y) {
        const float at = density.at(
            {(static_cast<float>(x) + 0.5f) / bins, (static_cast<float>(y) + 0.5f) / bins});
        expected[static_cast<std::size_t>(x * bins + y)] = count * double{at} / (bins * bins);
        sum += double{at} / (bins * bins);
      }
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_GT(statistics::chi_square_test(observed, expected).p_value,
              statistics::sidak_level(0.01, std::size(densities)))
        << density.w00 << " " << density.w10 << " " << density.w01 << " " << density.w11;
  }
}

TEST(Unit_Bilinear, EqualWeightsLeaveNumbersAsTheyAre) {
  for (const float u : {0.0f, 1e-20f, 0.3f, one_minus_epsilon})
    EXPECT_EQ(BilinearDensity{}.sample({u, u}), Vec2f(u, u));
}

TEST(Unit_Bilinear, StaysWithinTheSquare) {
  for (const BilinearDensity& density : densities)
    for (const float x : {0.0f, 1e-38f, 0.5f, one_minus_epsilon})
      for (const float y : {0.0f, 1e-38f, 0.5f, one_minus_epsilon}) {
        const Vec2f place = density.sample({x, y});
        EXPECT_TRUE(place.x >= 0 && place.x < 1 && place.y >= 0 && place.y < 1) << x << " " << y;
      }
}

}  // namespace
}  // namespace candela
