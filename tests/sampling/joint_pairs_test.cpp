// Pairs that go together: each is a net by itself, all are uniform and independent over pixels, and
// what depends on two of them is known better than by padded ones.
#include "renderer/sampling/joint_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "renderer/sampling/sampler.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

struct Pair {
  std::uint32_t bounce;
  Dimension dimension;
};
constexpr Pair camera{0, Dimension::Filter};

Vec2f point_of(const Sampler& sampler, const Pair& pair) {
  return sampler.sample_2d(pair.bounce, pair.dimension);
}

std::vector<Pair> joint_pairs() {
  std::vector<Pair> pairs{camera};
  for (std::uint32_t bounce = 0; bounce < joint_bounces; ++bounce)
    for (const Dimension dimension : {Dimension::LightPoint, Dimension::Direction})
      pairs.push_back({bounce, dimension});
  return pairs;
}

// The pairs that meet in a path: of the ray that reaches a vertex, and those drawn there.
std::vector<std::pair<Pair, Pair>> pairs_that_meet() {
  std::vector<std::pair<Pair, Pair>> pairs;
  Pair arriving = camera;
  for (std::uint32_t bounce = 0; bounce < joint_bounces; ++bounce) {
    const Pair direction{bounce, Dimension::Direction};
    pairs.push_back({arriving, {bounce, Dimension::LightPoint}});
    pairs.push_back({arriving, direction});
    arriving = direction;
  }
  return pairs;
}

// Digits above and on the diagonal alone, or blocks of samples would not stay blocks.
TEST(Unit_JointPairs, MatricesAreUpperTriangular) {
  for (const BitMatrix& matrix : {to_light_point, to_direction, to_lobe_choice})
    for (std::uint32_t r = 0; r < joint_bits; ++r) {
      EXPECT_EQ(matrix[r] >> r & 1, 1);
      EXPECT_EQ(matrix[r] & ((1u << r) - 1), 0u);
      EXPECT_EQ(matrix[r] >> joint_bits, 0u);
    }
}

TEST(Unit_JointPairs, AProductIsOneMatrixAfterTheOther) {
  const BitColumns first = columns_of(to_direction);
  const BitColumns second = columns_of(to_light_point);
  const BitColumns both = columns_of(product(to_light_point, to_direction));
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const std::uint32_t index = i * 2654435761u;
    ASSERT_EQ(multiplied(multiplied(index, first), second), multiplied(index, both));
  }
}

// Every elementary interval of every aligned block of 2^k samples holds one point of each pair.
TEST(Unit_JointPairs, EachIsANet) {
  for (const Pair& pair : joint_pairs())
    for (std::uint32_t k = 0; k <= 9; ++k)
      for (const std::uint32_t block : {0u, 3u, 1u << 12}) {
        const std::uint32_t count = 1u << k;
        for (std::uint32_t column_bits = 0; column_bits <= k; ++column_bits) {
          std::vector<bool> is_hit(count);
          for (std::uint32_t i = 0; i < count; ++i) {
            const Sampler sampler(mix_bits(7), block * count + i);
            const auto [x, y] = sampler.sample_2d_bits(pair.bounce, pair.dimension);
            const std::uint64_t column = std::uint64_t{x} << column_bits >> 32;
            const std::uint64_t row = std::uint64_t{y} << (k - column_bits) >> 32;
            const std::uint64_t cell = column << (k - column_bits) | row;
            ASSERT_FALSE(is_hit[cell]) << pair.bounce << " k " << k;
            is_hit[cell] = true;
          }
        }
      }
}

// Of one sample, over pixels: a path's numbers are as good as independent ones. As counts of a grid
// of 4 x 4 x 4 x 4.
TEST(Statistical_JointPairs, AreUniformAndIndependentOverPixels) {
  std::vector<double> p_values;
  const std::vector<Pair> pairs = joint_pairs();
  for (const std::uint32_t sample : {0u, 3u, 21u})
    for (std::size_t a = 0; a < pairs.size(); ++a)
      for (std::size_t b = a + 1; b < pairs.size(); ++b) {
        std::vector<double> counts(256);
        for (std::uint32_t pixel = 0; pixel < 65536; ++pixel) {
          const Sampler sampler(0, pixel % 256, pixel / 256, sample);
          const auto cell = [](Vec2f p) {
            return static_cast<std::size_t>(p.x * 4) * 4 + static_cast<std::size_t>(p.y * 4);
          };
          ++counts[cell(point_of(sampler, pairs[a])) * 16 + cell(point_of(sampler, pairs[b]))];
        }
        p_values.push_back(
            statistics::chi_square_test(counts, std::vector<double>(256, 256)).p_value);
      }
  const double smallest = *std::min_element(p_values.begin(), p_values.end());
  EXPECT_GT(statistics::sidak_p_value(smallest, static_cast<double>(p_values.size())), 0.01);
}

// Every aligned block of 2^k samples has a number in every 2^k-th.
TEST(Unit_JointPairs, LobeChoicesAreEvenlySpread) {
  for (std::uint32_t bounce = 0; bounce < joint_bounces; ++bounce)
    for (std::uint32_t k = 0; k <= 12; ++k)
      for (const std::uint32_t block : {0u, 3u, 1u << 12}) {
        std::vector<bool> is_hit(std::size_t{1} << k);
        for (std::uint32_t i = 0; i < 1u << k; ++i) {
          const Sampler sampler(mix_bits(7), (block << k) + i);
          const std::uint64_t cell =
              std::uint64_t{sampler.sample_1d_bits(bounce, Dimension::LobeChoice)} << k >> 32;
          ASSERT_FALSE(is_hit[cell]) << bounce << " k " << k;
          is_hit[cell] = true;
        }
      }
}

// Over pixels, of the mean of `count` samples of an integrand over two pairs.
template <class F>
statistics::Moments estimates(PairOrder order, const Pair& a, const Pair& b, std::uint32_t count,
                              F integrand) {
  statistics::Moments moments;
  for (std::uint32_t pixel = 0; pixel < 4000; ++pixel) {
    double sum = 0;
    const PixelSampler samples(3, pixel, 5, 1, order);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Sampler sampler = samples.at(i);
      sum += integrand(point_of(sampler, a), point_of(sampler, b));
    }
    moments.add(sum / count);
  }
  return moments;
}

// A shadow's edge, and something smooth, over both pairs. The ratio of two variances of 4000
// estimates each has a standard deviation of sqrt(4 / 4000). Sixteen points are too few for an edge
// over four dimensions.
TEST(Statistical_JointPairs, BeatPaddedOnesWhereTheyMeet) {
  const auto edge = [](Vec2f p, Vec2f q) {
    return p.x + 0.7f * p.y - 0.9f * q.x + 0.5f * q.y < 0.7f ? 1.0 : 0.0;
  };
  const auto bell = [](Vec2f p, Vec2f q) {
    const Vec2f a = p - Vec2f(0.4f), b = q - Vec2f(0.6f);
    return std::exp(-4.0 * double{dot(a, a) + dot(b, b)});
  };
  const double chance = 3 * std::sqrt(4.0 / 4000);
  for (const std::uint32_t count : {16u, 64u}) {
    const double most_edge = count == 16 ? 1 + chance : 1 - chance;
    const double most_bell = 1 - chance;
    for (const auto& [a, b] : pairs_that_meet()) {
      const auto ratio = [&, &a = a, &b = b](auto integrand) {
        return estimates(PairOrder::Joint, a, b, count, integrand).variance() /
               estimates(PairOrder::Padded, a, b, count, integrand).variance();
      };
      EXPECT_LT(ratio(edge), most_edge) << a.bounce << " " << count;
      EXPECT_LT(ratio(bell), most_bell) << a.bounce << " " << count;
    }
  }
}

// Two lobes, whose directions bring different light.
TEST(Statistical_JointPairs, LobesHaveDirectionsThatAreEvenlySpread) {
  for (std::uint32_t bounce = 0; bounce < joint_bounces; ++bounce) {
    const auto variance = [&](PairOrder order) {
      statistics::Moments moments;
      for (std::uint32_t pixel = 0; pixel < 4000; ++pixel) {
        const PixelSampler samples(3, pixel, 5, 1, order);
        double sum = 0;
        for (std::uint32_t i = 0; i < 16; ++i) {
          const Sampler sampler = samples.at(i);
          const Vec2f p = sampler.sample_2d(bounce, Dimension::Direction);
          const bool is_first = sampler.sample_1d(bounce, Dimension::LobeChoice) < 0.4f;
          if (is_first ? p.x > 0.3f : p.y > 0.6f) sum += is_first ? 2 : 1;
        }
        moments.add(sum / 16);
      }
      return moments.variance();
    };
    const double chance = 3 * std::sqrt(4.0 / 4000);
    EXPECT_LT(variance(PairOrder::Joint), (1 - chance) * variance(PairOrder::Padded)) << bounce;
  }
}

}  // namespace
}  // namespace candela
