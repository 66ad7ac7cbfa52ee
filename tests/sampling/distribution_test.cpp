#include "renderer/sampling/distribution.h"

#include <gtest/gtest.h>

#include <numeric>

#include "renderer/sampling/hash.h"
#include "tests/statistics/chi_square.h"

namespace candela {
namespace {

// Random bits that are as good as independent.
std::uint32_t random_bits(std::uint64_t i, std::uint64_t stream) {
  return static_cast<std::uint32_t>(hash_combine(stream, i) >> 32);
}
float random_unit(std::uint64_t i, std::uint64_t stream) {
  return unit_float(random_bits(i, stream));
}

double probability_sum(const AliasTable& table) {
  double sum = 0;
  for (std::uint32_t i = 0; i < table.size(); ++i) sum += static_cast<double>(table.probability(i));
  return sum;
}

TEST(Unit_ProportionalSteps, SumExactlyAndKeepWhatIsPositive) {
  const std::vector<double> weights{1e-30, 0, 3, 1e30, -1, std::nan(""), 1};
  const std::vector<std::uint64_t> steps = proportional_steps(weights, 1000);
  EXPECT_EQ(std::accumulate(steps.begin(), steps.end(), std::uint64_t{0}), 1000u);
  EXPECT_EQ(steps, (std::vector<std::uint64_t>{1, 0, 1, 997, 0, 0, 1}));
}

TEST(Unit_ProportionalSteps, AreNothingWithoutPositiveWeights) {
  EXPECT_EQ(proportional_steps(std::vector<double>{0, -1}, 10), (std::vector<std::uint64_t>{0, 0}));
  EXPECT_TRUE(proportional_steps({}, 10).empty());
}

TEST(Unit_AliasTable, IsEmptyWithoutPositiveWeights) {
  EXPECT_TRUE(AliasTable().is_empty());
  EXPECT_TRUE(AliasTable(std::vector<double>{}).is_empty());
  EXPECT_TRUE(AliasTable(std::vector<double>{0, 0}).is_empty());
}

TEST(Unit_AliasTable, AlwaysPicksTheOnlyOne) {
  const AliasTable one(std::vector<double>{5e-200});
  EXPECT_EQ(one.pick(0), 0u);
  EXPECT_EQ(one.pick(0xffffffffu), 0u);
  EXPECT_EQ(one.probability(0), 1.0f);
}

// Every slot's range of bits is known, so counting over slots gives the probabilities exactly.
TEST(Unit_AliasTable, PicksExactlyAsOftenAsItSays) {
  std::vector<double> weights;
  for (std::uint64_t i = 0; i < 37; ++i)
    weights.push_back(i % 5 == 0 ? 0 : std::pow(10.0, 8 * random_unit(i, 1) - 4));
  const AliasTable table(weights);
  // All 2^32 numbers would take seconds: the upper 6 bits are the slot, and within a slot the pick
  // changes once, where bisection finds it.
  constexpr std::uint64_t slot_size = std::uint64_t{1} << 26;
  std::vector<std::uint64_t> counts(weights.size() + 64, 0);
  for (std::uint64_t slot = 0; slot < 64; ++slot) {
    const std::uint64_t first = slot * slot_size;
    std::uint64_t low = 0, high = slot_size;  // the first remainder whose pick differs from low's
    const std::uint32_t own = table.pick(static_cast<std::uint32_t>(first));
    while (high - low > 1) {
      const std::uint64_t middle = (low + high) / 2;
      (table.pick(static_cast<std::uint32_t>(first + middle)) == own ? low : high) = middle;
    }
    counts[own] += high;
    if (high < slot_size)
      counts[table.pick(static_cast<std::uint32_t>(first + high))] += slot_size - high;
  }
  for (std::uint32_t i = 0; i < weights.size(); ++i)
    EXPECT_EQ(static_cast<float>(static_cast<double>(counts[i]) * 0x1p-32), table.probability(i))
        << i;
}

TEST(Unit_AliasTable, FollowsTheWeights) {
  const std::vector<double> weights{1, 2, 3, 4, 0, 10};
  const AliasTable table(weights);
  for (std::uint32_t i = 0; i < weights.size(); ++i)
    EXPECT_NEAR(table.probability(i), weights[i] / 20, 1e-8) << i;
}

TEST(Unit_AliasTable, LosesNothingOfPowersFarApart) {
  const std::vector<double> weights{1e-30, 1, 1e30, 0, 1e-300};
  const AliasTable table(weights);
  EXPECT_GT(table.probability(0), 0.0f);
  EXPECT_GT(table.probability(1), 0.0f);
  EXPECT_EQ(table.probability(3), 0.0f);
  EXPECT_GT(table.probability(4), 0.0f);
  EXPECT_NEAR(probability_sum(table), 1, 1e-7);
}

TEST(Unit_AliasTable, HoldsAMillion) {
  std::vector<double> weights(1'000'003);
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] = 1 + random_unit(i, 2);
  const AliasTable table(weights);
  EXPECT_NEAR(probability_sum(table), 1, 1e-6);
  for (std::uint32_t i = 0; i < weights.size(); i += 997)
    EXPECT_NEAR(table.probability(i) * sum / weights[i], 1, 1e-3) << i;
}

TEST(Statistical_AliasTable, FrequenciesFitTheProbabilities) {
  std::vector<double> weights;
  for (std::uint64_t i = 0; i < 1000; ++i) weights.push_back(std::pow(random_unit(i, 3), 4));
  const AliasTable table(weights);
  constexpr std::uint64_t count = 1'000'000;
  std::vector<double> observed(weights.size(), 0), expected;
  for (std::uint64_t i = 0; i < count; ++i) observed[table.pick(random_bits(i, 4))] += 1;
  for (std::uint32_t i = 0; i < weights.size(); ++i)
    expected.push_back(static_cast<double>(table.probability(i)) * count);
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, 0.01);
}

std::vector<double> random_weights(std::size_t count, std::uint64_t stream) {
  std::vector<double> weights(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = random_unit(i, stream);
    weights[i] = x < 0.3f ? 0 : std::pow(10.0, 4 * static_cast<double>(x));
  }
  return weights;
}

TEST(Unit_GridDistribution, IsEmptyWithoutPositiveWeights) {
  EXPECT_TRUE(GridDistribution().is_empty());
  EXPECT_TRUE(GridDistribution(2, 2, std::vector<double>(4, 0.0)).is_empty());
}

TEST(Unit_GridDistribution, ProbabilitiesSumToOneAndFollowTheWeights) {
  const std::vector<double> weights = random_weights(31 * 17, 5);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const GridDistribution grid(31, 17, weights);
  double total = 0;
  for (std::uint32_t row = 0; row < 17; ++row)
    for (std::uint32_t column = 0; column < 31; ++column) {
      const double p = static_cast<double>(grid.probability(column, row));
      total += p;
      EXPECT_NEAR(p, weights[row * 31 + column] / sum, 1e-5);
      EXPECT_EQ(p > 0, weights[row * 31 + column] > 0);
    }
  EXPECT_NEAR(total, 1, 1e-7);
}

TEST(Unit_GridDistribution, OneBrightCellLosesNoneOfTheDimOnes) {
  std::vector<double> weights(64 * 64, 1.0);
  weights[1234] = 1e9;
  weights[77] = 0;
  const GridDistribution grid(64, 64, weights);
  for (std::uint32_t i = 0; i < 64 * 64; ++i)
    EXPECT_EQ(grid.probability(i % 64, i / 64) > 0, i != 77) << i;
}

// Inversion at the ends of each interval: the first and the last random number of a cell.
TEST(Unit_GridDistribution, InvertsAtTheEndsOfEachInterval) {
  const std::vector<double> weights{0, 0, 3, 0, 1, 0};
  const GridDistribution grid(6, 1, weights);
  EXPECT_EQ(grid.sample({0, 0}).column, 2u);
  EXPECT_EQ(grid.sample({0.75f - 0x1p-24f, 0.5f}).column, 2u);
  EXPECT_EQ(grid.sample({0.75f, 0.5f}).column, 4u);
  EXPECT_EQ(grid.sample({one_minus_epsilon, one_minus_epsilon}).column, 4u);
  EXPECT_LT(grid.sample({one_minus_epsilon, one_minus_epsilon}).offset.x, 1.0f);
  EXPECT_EQ(grid.sample({0, 0}).probability, 0.75f);
  EXPECT_EQ(grid.probability(0, 0), 0.0f);
}

// Cells are cut 2 x 2 so that the offsets within them are tested too.
TEST(Statistical_GridDistribution, SamplesFitTheDensity) {
  constexpr std::uint32_t columns = 20, rows = 12;
  const GridDistribution grid(columns, rows, random_weights(columns * rows, 6));
  constexpr std::uint64_t count = 1'000'000;
  std::vector<double> observed(columns * rows * 4, 0), expected(columns * rows * 4, 0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const GridDistribution::Cell cell = grid.sample({random_unit(i, 7), random_unit(i, 8)});
    ASSERT_EQ(cell.probability, grid.probability(cell.column, cell.row));
    const std::uint32_t x = 2 * cell.column + (cell.offset.x < 0.5f ? 0 : 1);
    const std::uint32_t y = 2 * cell.row + (cell.offset.y < 0.5f ? 0 : 1);
    observed[y * 2 * columns + x] += 1;
  }
  for (std::uint32_t y = 0; y < 2 * rows; ++y)
    for (std::uint32_t x = 0; x < 2 * columns; ++x)
      expected[y * 2 * columns + x] =
          0.25 * count * static_cast<double>(grid.probability(x / 2, y / 2));
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, 0.01);
}

}  // namespace
}  // namespace candela
