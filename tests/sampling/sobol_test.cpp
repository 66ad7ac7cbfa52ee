#include "renderer/sampling/sobol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "renderer/math/constants.h"
#include "renderer/sampling/sampler.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

TEST(Unit_Sobol, FirstPointsAreTheTextbooks) {
  const std::vector<double> first = {0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875};
  const std::vector<double> second = {0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(reverse_bits(i) * 0x1p-32, first[i]);
    EXPECT_EQ(reverse_bits(reversed_sobol_second(i)) * 0x1p-32, second[i]);
  }
}

// Against direction numbers: v_j = v_{j-1} xor v_{j-1} / 2 for the polynomial x + 1.
TEST(Unit_Sobol, SecondDimensionFollowsItsRecurrence) {
  std::uint32_t directions[32];
  directions[0] = 0x80000000u;
  for (int j = 1; j < 32; ++j) directions[j] = directions[j - 1] ^ (directions[j - 1] >> 1);
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const std::uint32_t index = i * 2654435761u;
    std::uint32_t expected = 0;
    for (unsigned j = 0; j < 32; ++j)
      if ((index >> j & 1) != 0) expected ^= directions[j];
    ASSERT_EQ(reverse_bits(reversed_sobol_second(index)), expected);
  }
}

// Every elementary interval of every aligned block of 2^k samples holds one point.
TEST(Unit_Sobol, EveryAlignedBlockIsANet) {
  for (std::uint64_t key = 1; key < 20; ++key)
    for (std::uint32_t k = 0; k <= 10; ++k)
      for (const std::uint32_t block : {0u, 1u, 5u}) {
        const std::uint32_t count = 1u << k;
        for (std::uint32_t columns_bits = 0; columns_bits <= k; ++columns_bits) {
          std::vector<bool> is_hit(count);
          for (std::uint32_t i = 0; i < count; ++i) {
            const auto [x, y] = scrambled_sobol_2d(reverse_bits(block * count + i), mix_bits(key));
            const std::uint64_t column = std::uint64_t{x} << columns_bits >> 32;
            const std::uint64_t row = std::uint64_t{y} << (k - columns_bits) >> 32;
            const std::uint64_t cell = column << (k - columns_bits) | row;
            ASSERT_FALSE(is_hit[cell]) << "key " << key << " k " << k;
            is_hit[cell] = true;
          }
        }
      }
}

TEST(Unit_Sobol, OneDimensionIsStratified) {
  for (std::uint64_t key = 1; key < 20; ++key)
    for (std::uint32_t k = 0; k <= 10; ++k)
      for (const std::uint32_t block : {0u, 3u}) {
        std::vector<bool> is_hit(1u << k);
        for (std::uint32_t i = 0; i < (1u << k); ++i) {
          const std::uint64_t x = scrambled_sobol_1d(reverse_bits((block << k) + i), mix_bits(key));
          ASSERT_FALSE(is_hit[x << k >> 32]);
          is_hit[x << k >> 32] = true;
        }
      }
}

TEST(Unit_Sobol, StaysBelowOne) {
  EXPECT_LT(unit_float(0xffffffffu), 1);
  EXPECT_EQ(unit_float(0), 0);
}

// Pairs of numbers over many pixels, as counts of a 16 x 16 grid: uniform, if each is uniform and
// they are independent.
template <class F>
double uniformity_p_value(F pair_of_pixel) {
  std::vector<double> counts(256);
  const std::vector<double> expected(256, 65536.0 / 256);
  for (std::uint32_t y = 0; y < 256; ++y)
    for (std::uint32_t x = 0; x < 256; ++x) {
      const Vec2f pair = pair_of_pixel(x, y);
      ++counts[static_cast<std::size_t>(pair.x * 16) * 16 + static_cast<std::size_t>(pair.y * 16)];
    }
  return statistics::chi_square_test(counts, expected).p_value;
}

constexpr std::uint32_t first_samples = 4;

TEST(Statistical_Sampler, PointsAreUniformAndIndependentOverPixels) {
  std::vector<double> p_values;
  const auto sampler = [](std::uint32_t x, std::uint32_t y, std::uint32_t i, std::uint64_t seed) {
    return Sampler(seed, x, y, i);
  };
  for (std::uint32_t i = 0; i < first_samples; ++i) {
    const auto test = [&](auto pair) { p_values.push_back(uniformity_p_value(pair)); };
    // one point
    test([&](auto x, auto y) { return sampler(x, y, i, 0).sample_2d(2, Dimension::Direction); });
    // its fine digits
    test([&](auto x, auto y) {
      const Vec2f p = sampler(x, y, i, 0).sample_2d(2, Dimension::Direction) * 4096.0f;
      return p - glm::floor(p);
    });
    // two dimensions, two bounces, two samples, two seeds, neighbours
    test([&](auto x, auto y) {
      const Sampler s = sampler(x, y, i, 0);
      return Vec2f{s.sample_1d(1, Dimension::LobeChoice), s.sample_1d(1, Dimension::Roulette)};
    });
    test([&](auto x, auto y) {
      const Sampler s = sampler(x, y, i, 0);
      return Vec2f{s.sample_2d(1, Dimension::Direction).x, s.sample_2d(2, Dimension::Direction).x};
    });
    test([&](auto x, auto y) {
      return Vec2f{sampler(x, y, i, 0).sample_2d(1, Dimension::Direction).y,
                   sampler(x, y, i, 1).sample_2d(1, Dimension::Direction).y};
    });
    test([&](auto x, auto y) {
      return Vec2f{sampler(x, y, i, 0).sample_2d(1, Dimension::Direction).x,
                   sampler(x + 1, y, i, 0).sample_2d(1, Dimension::Direction).x};
    });
    test([&](auto x, auto y) {
      return Vec2f{sampler(x, y, i, 0).sample_1d(1, Dimension::LightChoice),
                   sampler(x, y + 1, i, 0).sample_1d(1, Dimension::LightChoice)};
    });
  }
  const double smallest = *std::min_element(p_values.begin(), p_values.end());
  EXPECT_GT(statistics::sidak_p_value(smallest, static_cast<double>(p_values.size())), 0.01);
}

// The mean over pixels of 64-sample estimates has no bias, and their variance is what
// stratification promises: far below that of independent numbers within a pair, no worse across
// padded pairs.
template <class F>
statistics::Moments estimates_over_pixels(F integrand) {
  statistics::Moments estimates;
  for (std::uint32_t pixel = 0; pixel < 4000; ++pixel) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 64; ++i) sum += integrand(Sampler(9, pixel, 3, i));
    estimates.add(sum / 64);
  }
  return estimates;
}

TEST(Statistical_Sampler, IntegratesBetterThanIndependentNumbers) {
  const auto product = estimates_over_pixels([](const Sampler& s) {
    const Vec2f u = s.sample_2d(1, Dimension::Direction);
    return double{u.x * u.y};
  });
  const double independent = (1.0 / 9 - 1.0 / 16) / 64;
  EXPECT_GT(product.p_value(0.25), 0.001);
  EXPECT_LT(product.variance(), independent / 200);

  const auto edge = estimates_over_pixels([](const Sampler& s) {
    const Vec2f u = s.sample_2d(1, Dimension::Direction);
    return u.x + u.y < 0.7f ? 1.0 : 0.0;
  });
  EXPECT_GT(edge.p_value(0.245), 0.001);
  EXPECT_LT(edge.variance(), 0.245 * 0.755 / 64 / 5);
}

// Of squares finer than what the points stratify each is a toss of a coin: also where a power of
// two of them fit between 0 and 1, which the points' digits alone decide.
TEST(Statistical_Sampler, IsNoWorseThanIndependentNumbersOnFineChessboards) {
  for (const double squares : {7.3, 8.0, 9.2, 16.0})
    for (const std::uint32_t count : {16u, 64u}) {
      statistics::Moments means;
      for (std::uint32_t pixel = 0; pixel < 4000; ++pixel) {
        const Vec2f phase = Sampler(4, pixel, 1, 0).sample_2d(0, Dimension::Lens);
        const auto row = [&](float u, float shift) {
          return static_cast<int>(squares * double{u} + 2 * double{shift});
        };
        double sum = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
          const Vec2f u = Sampler(9, pixel, 3, i).sample_2d(1, Dimension::Direction);
          sum += ((row(u.x, phase.x) + row(u.y, phase.y)) & 1) == 0 ? 1 : -1;
        }
        means.add(sum / count);
      }
      EXPECT_GT(means.p_value(0), 0.001);
      EXPECT_LT(means.variance() * count, 1.3) << squares << " squares, " << count << " points";
    }
}

TEST(Statistical_Sampler, PaddedDimensionsDoNotConspire) {
  const auto disk = estimates_over_pixels([](const Sampler& s) {
    const float a = s.sample_1d(0, Dimension::LobeChoice) - 0.3f;
    const float b = s.sample_2d(1, Dimension::Direction).x - 0.6f;
    return a * a + b * b < 0.09f ? 1.0 : 0.0;
  });
  const double area = pi_double * 0.09;
  EXPECT_GT(disk.p_value(area), 0.001);
  EXPECT_LT(disk.variance(), area * (1 - area) / 64);
}

}  // namespace
}  // namespace candela
