#include "renderer/sampling/distribution.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace candela {
namespace {

// Finite weights relative to the largest; infinite ones count 1 and finite ones 0 beside them.
std::vector<double> relative_weights(std::span<const double> weights) {
  double largest = 0;
  for (const double w : weights)
    if (std::isgreater(w, largest)) largest = w;
  std::vector<double> relative(weights.size(), 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isgreater(weights[i], 0.0)) continue;
    relative[i] = std::isinf(largest) ? (std::isinf(weights[i]) ? 1.0 : 0.0) : weights[i] / largest;
  }
  return relative;
}

// Rounding leaves some steps over, or takes a few too many: the one is spread over the positive
// weights, the other taken from whoever has most.
void settle(std::vector<std::uint64_t>& steps, std::uint64_t total) {
  std::uint64_t sum = 0;
  for (const std::uint64_t s : steps) sum += s;
  while (sum > total) {
    *std::max_element(steps.begin(), steps.end()) -= 1;
    --sum;
  }
  while (sum < total)
    for (std::size_t i = 0; i < steps.size() && sum < total; ++i)
      if (steps[i] > 0) {
        ++steps[i];
        ++sum;
      }
}

}  // namespace

std::vector<std::uint64_t> proportional_steps(std::span<const double> weights,
                                              std::uint64_t total) {
  const std::vector<double> relative = relative_weights(weights);
  std::uint64_t positive_count = 0;
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    positive_count += std::isgreater(weights[i], 0.0) ? 1 : 0;
    sum += relative[i];
  }
  std::vector<std::uint64_t> steps(weights.size(), 0);
  if (positive_count == 0) return steps;
  const double shared = static_cast<double>(total - positive_count);
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (std::isgreater(weights[i], 0.0))
      steps[i] = 1 + static_cast<std::uint64_t>(relative[i] / sum * shared);
  settle(steps, total);
  return steps;
}

AliasTable::AliasTable(std::span<const double> weights) : probabilities_(weights.size(), 0.0f) {
  std::vector<std::uint64_t> steps = proportional_steps(weights, std::uint64_t{1} << 32);
  bool has_any = false;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    probabilities_[i] = static_cast<float>(static_cast<double>(steps[i]) * 0x1p-32);
    has_any = has_any || steps[i] > 0;
  }
  if (has_any) fill_slots(std::move(steps));
}

// Vose's pairing in whole numbers: it ends exactly, where floating point leaves crumbs.
void AliasTable::fill_slots(std::vector<std::uint64_t> steps) {
  const std::size_t slot_count = std::max<std::size_t>(2, std::bit_ceil(steps.size()));
  remainder_bits_ = 32u - static_cast<std::uint32_t>(std::countr_zero(slot_count));
  const std::uint64_t capacity = std::uint64_t{1} << remainder_bits_;
  steps.resize(slot_count, 0);
  slots_.resize(slot_count);
  std::vector<std::uint32_t> under, over;
  for (std::uint32_t i = 0; i < slot_count; ++i) (steps[i] < capacity ? under : over).push_back(i);
  while (!under.empty()) {
    const std::uint32_t slot = under.back();
    under.pop_back();
    const std::uint32_t donor = over.back();  // the mean is the capacity: somebody has more
    slots_[slot] = {static_cast<std::uint32_t>(steps[slot]), donor};
    steps[donor] -= capacity - steps[slot];
    if (steps[donor] >= capacity) continue;
    over.pop_back();
    under.push_back(donor);
  }
  for (const std::uint32_t slot : over) slots_[slot] = {static_cast<std::uint32_t>(capacity), slot};
}

namespace {

void write_cumulative(std::span<const double> weights, float* sums) {
  const std::vector<std::uint64_t> steps = proportional_steps(weights, std::uint64_t{1} << 24);
  std::uint64_t sum = 0;
  sums[0] = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    sum += steps[i];
    sums[i + 1] = static_cast<float>(sum) * 0x1p-24f;
  }
}

// About a step for every four intervals.
std::uint32_t guide_steps(std::uint32_t count) {
  return std::max(1u, std::bit_ceil(count) / 4);
}

// guide[k], k = 0..steps: the last of `count` intervals that begins at or before k / steps.
void write_guide(const float* sums, std::uint32_t count, std::uint32_t steps,
                 std::uint32_t* guide) {
  std::uint32_t index = 0;
  for (std::uint32_t k = 0; k <= steps; ++k) {
    const float x = static_cast<float>(k) / static_cast<float>(steps);
    while (index + 1 < count && sums[index + 1] <= x) ++index;
    guide[k] = index;
  }
}

}  // namespace

GridDistribution::GridDistribution(std::uint32_t columns, std::uint32_t rows,
                                   std::span<const double> weights) {
  GridDistributionBuilder builder(columns, rows);
  for (std::uint32_t row = 0; row < rows; ++row)
    builder.set_row(row, weights.subspan(std::size_t{row} * columns, columns));
  *this = std::move(builder).build();
}

GridDistributionBuilder::GridDistributionBuilder(std::uint32_t columns, std::uint32_t rows)
    : row_weights_(rows, 0.0) {
  const std::uint32_t steps = guide_steps(columns);
  grid_.columns_ = columns;
  grid_.rows_ = rows;
  grid_.column_guide_steps_ = static_cast<float>(steps);
  grid_.conditional_.resize(std::size_t{rows} * (columns + 1));
  grid_.conditional_guide_.resize(std::size_t{rows} * (steps + 1));
}

void GridDistributionBuilder::set_row(std::uint32_t row, std::span<const double> weights) {
  for (const double w : weights)
    if (w > 0) row_weights_[row] += w;
  const std::uint32_t columns = grid_.columns_;
  const std::uint32_t steps = guide_steps(columns);
  float* sums = grid_.conditional_.data() + std::size_t{row} * (columns + 1);
  write_cumulative(weights, sums);
  write_guide(sums, columns, steps,
              grid_.conditional_guide_.data() + std::size_t{row} * (steps + 1));
}

double GridDistributionBuilder::total_weight() const {
  return std::accumulate(row_weights_.begin(), row_weights_.end(), 0.0);
}

GridDistribution GridDistributionBuilder::build() && {
  if (!(total_weight() > 0)) return {};
  const std::uint32_t rows = grid_.rows_;
  const std::uint32_t steps = guide_steps(rows);
  grid_.row_guide_steps_ = static_cast<float>(steps);
  grid_.marginal_.resize(std::size_t{rows} + 1);
  grid_.marginal_guide_.resize(std::size_t{steps} + 1);
  write_cumulative(row_weights_, grid_.marginal_.data());
  write_guide(grid_.marginal_.data(), rows, steps, grid_.marginal_guide_.data());
  return std::move(grid_);
}

}  // namespace candela
