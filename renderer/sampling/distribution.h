// Discrete choice with exact probabilities.
//
// Probabilities are whole multiples of a step that uniform random bits can tell apart, and every
// positive weight has at least one step: what is said to be chosen with probability p is chosen
// with probability p, to the rounding of a float, and nothing that may matter is lost, however far
// weights lie apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/math/constants.h"
#include "renderer/math/vec.h"

namespace candela {

// Splits `total` whole steps among weights in proportion as near as rounding allows; positive
// weights get at least 1, others (also NaN) 0. Infinite weights share all but that. All 0 where no
// weight is positive. There must be at most total / 2 weights.
[[nodiscard]] std::vector<std::uint64_t> proportional_steps(std::span<const double> weights,
                                                            std::uint64_t total);

// Picks one of n < 2^31 by weight in constant time [Walker77; Vose91]; probabilities are multiples
// of 2^-32. The number of slots is a power of two, so a slot is an aligned range of the 32 bits.
class AliasTable {
 public:
  AliasTable() = default;
  explicit AliasTable(std::span<const double> weights);

  // True where nothing can be picked: no weight was positive.
  [[nodiscard]] bool is_empty() const { return slots_.empty(); }
  [[nodiscard]] std::size_t size() const { return probabilities_.size(); }

  // `bits` uniform over all 32-bit numbers. Not to be called on an empty table.
  [[nodiscard]] std::uint32_t pick(std::uint32_t bits) const {
    const std::uint32_t slot = bits >> remainder_bits_;
    const std::uint32_t remainder = bits & ((1u << remainder_bits_) - 1u);
    return remainder < slots_[slot].threshold ? slot : slots_[slot].alias;
  }
  [[nodiscard]] float probability(std::uint32_t i) const { return probabilities_[i]; }

 private:
  struct Slot {
    std::uint32_t threshold = 0;  // remainders below it pick the slot's own index
    std::uint32_t alias = 0;
  };
  void fill_slots(std::vector<std::uint64_t> steps);

  std::vector<Slot> slots_;
  std::vector<float> probabilities_;
  std::uint32_t remainder_bits_ = 31;
};

// A function that is constant on each cell of a grid, as a distribution: a row by the marginal,
// then a column in it. Cumulative sums are multiples of 2^-24, which floats and the 24-bit random
// numbers hold exactly. Inversion is monotone, so well spread points stay well spread.
class GridDistribution {
 public:
  struct Cell {
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    Vec2f offset{0};        // uniform within the cell, [0, 1)
    float probability = 0;  // of the cell; > 0
  };

  GridDistribution() = default;
  // weights[row * columns + column]; at most 2^20 rows and columns each. For weights that need not
  // be there all at once: GridDistributionBuilder.
  GridDistribution(std::uint32_t columns, std::uint32_t rows, std::span<const double> weights);

  [[nodiscard]] bool is_empty() const { return marginal_.empty(); }  // no positive weight
  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }

  // u in [0, 1)^2. Not to be called on an empty distribution.
  [[nodiscard]] Cell sample(Vec2f u) const {
    const Interval row = invert(marginal_.data(), marginal_guide_.data(), row_guide_steps_, u.y);
    const Interval column =
        invert(row_sums(row.index), row_guide(row.index), column_guide_steps_, u.x);
    return {
        column.index, row.index, {column.offset, row.offset}, row.probability * column.probability};
  }
  [[nodiscard]] float probability(std::uint32_t column, std::uint32_t row) const {
    const float* sums = row_sums(row);
    return (marginal_[row + 1] - marginal_[row]) * (sums[column + 1] - sums[column]);
  }
  [[nodiscard]] std::size_t bytes() const {
    return (marginal_.size() + conditional_.size()) * sizeof(float) +
           (marginal_guide_.size() + conditional_guide_.size()) * sizeof(std::uint32_t);
  }

 private:
  friend class GridDistributionBuilder;

  struct Interval {
    std::uint32_t index;
    float offset;
    float probability;
  };

  [[nodiscard]] const float* row_sums(std::uint32_t row) const {
    return conditional_.data() + std::size_t{row} * (columns_ + 1);
  }

  [[nodiscard]] const std::uint32_t* row_guide(std::uint32_t row) const {
    return conditional_guide_.data() +
           std::size_t{row} * (static_cast<std::uint32_t>(column_guide_steps_) + 1);
  }

  // The interval with sums[index] <= u < sums[index + 1]; the sums go from 0 to 1. guide[k] is the
  // interval of k / guide_steps, so that few are left to search, near each other in memory
  // [Chen74].
  [[nodiscard]] static Interval invert(const float* sums, const std::uint32_t* guide,
                                       float guide_steps, float u) {
    const auto step = static_cast<std::uint32_t>(u * guide_steps);
    std::uint32_t index = guide[step];
    for (std::uint32_t length = guide[step + 1] - index + 1; length > 1;) {
      const std::uint32_t half = length / 2;
      index += sums[index + half] <= u ? half : 0;
      length -= half;
    }
    const float lower = sums[index];
    const float probability = sums[index + 1] - lower;
    // A random number stands for the middle of its 2^-24 step: else narrow intervals would only
    // ever see their left ends.
    const float offset = (u - lower + 0x1p-25f) / probability;
    return {index, std::min(offset, one_minus_epsilon), probability};
  }

  std::vector<float> marginal_;     // rows + 1 cumulative sums
  std::vector<float> conditional_;  // columns + 1 cumulative sums a row
  std::vector<std::uint32_t> marginal_guide_;
  std::vector<std::uint32_t> conditional_guide_;  // column_guide_steps_ + 1 a row
  // Powers of two, so that multiplying by them is exact.
  float row_guide_steps_ = 1;
  float column_guide_steps_ = 1;
  std::uint32_t columns_ = 0;
  std::uint32_t rows_ = 0;
};

// Makes a GridDistribution row by row.
class GridDistributionBuilder {
 public:
  GridDistributionBuilder(std::uint32_t columns, std::uint32_t rows);

  // Each row once, `columns` weights; threads may set different rows at once.
  void set_row(std::uint32_t row, std::span<const double> weights);

  // Of the rows that are set.
  [[nodiscard]] double total_weight() const;
  // After all rows.
  [[nodiscard]] GridDistribution build() &&;

 private:
  GridDistribution grid_;
  std::vector<double> row_weights_;
};

}  // namespace candela
