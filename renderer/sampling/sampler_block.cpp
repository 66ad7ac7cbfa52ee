#include "renderer/sampling/sampler_block.h"

#include <algorithm>

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

CANDELA_EACH_VECTOR_WIDTH void shuffle(const Lanes<std::uint64_t>& keys,
                                       const Lanes<std::uint32_t>& reversed_indices,
                                       Lanes<std::uint32_t>& order) {
  for (std::size_t i = 0; i < block_size; ++i)
    order[i] = shuffled_index(reversed_indices[i], static_cast<std::uint32_t>(keys[i]));
}

CANDELA_EACH_VECTOR_WIDTH void reverse(Lanes<std::uint32_t>& lanes) {
  for (std::size_t i = 0; i < block_size; ++i) lanes[i] = reverse_bits(lanes[i]);
}

// And all of them together.
CANDELA_EACH_VECTOR_WIDTH std::uint32_t joint_indices_of(
    const Lanes<std::uint64_t>& keys, const Lanes<std::uint32_t>& reversed_indices,
    Lanes<std::uint32_t>& joint_indices) {
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < block_size; ++i) {
    joint_indices[i] = joint_index(reversed_indices[i], static_cast<std::uint32_t>(keys[i]));
    all |= joint_indices[i];
  }
  return all;
}

// multiplied(), column by column, and lanes without unrolling: else GCC makes no vectors of them.
CANDELA_EACH_VECTOR_WIDTH void multiply(const Lanes<std::uint32_t>& joint_indices,
                                        const BitColumns& matrix, std::uint32_t columns,
                                        Lanes<std::uint32_t>& order) {
  for (std::size_t i = 0; i < block_size; ++i) order[i] = untouched_part(joint_indices[i]);
  for (std::uint32_t c = 0; c < columns; ++c) {
    const std::uint32_t column = matrix[c];
#pragma GCC unroll 1
    for (std::size_t i = 0; i < block_size; ++i)
      order[i] ^= chosen_column(joint_indices[i], c, column);
  }
}

CANDELA_EACH_VECTOR_WIDTH void points_of(const Lanes<std::uint64_t>& keys,
                                         const Lanes<std::uint32_t>& order,
                                         SobolPointLanes& points) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const SobolPoint point = scrambled_pair(order[i], keys[i]);
    points.x[i] = point.x;
    points.y[i] = point.y;
  }
}

CANDELA_EACH_VECTOR_WIDTH void numbers_of(const Lanes<std::uint64_t>& keys,
                                          const Lanes<std::uint32_t>& order,
                                          Lanes<std::uint32_t>& numbers) {
  for (std::size_t i = 0; i < block_size; ++i) numbers[i] = scrambled_number(order[i], keys[i]);
}

}  // namespace

SamplerBlock::SamplerBlock(const PixelSampler& pixel, std::uint32_t first_sample,
                           std::uint32_t branches, std::uint32_t branch)
    : period_(std::min<std::size_t>(pixel.replicates(), block_size)), order_(pixel.order()) {
  std::uint32_t replicate = first_sample % pixel.replicates();
  std::uint32_t index = first_sample / pixel.replicates();
  for (std::size_t i = 0; i < block_size; ++i) {
    sequence_keys_[i] = i < period_ ? pixel.sequence_key(replicate) : sequence_keys_[i - period_];
    reversed_indices_[i] = index * branches + branch;
    if (++replicate == pixel.replicates()) {
      replicate = 0;
      ++index;
    }
  }
  reverse(reversed_indices_);
  find_joint_indices();
}

SamplerBlock::SamplerBlock(const SequenceLanes& sequences)
    : sequence_keys_(sequences.keys),
      reversed_indices_(sequences.indices),
      period_(block_size),
      order_(sequences.order) {
  reverse(reversed_indices_);
  find_joint_indices();
}

void SamplerBlock::find_joint_indices() {
  if (order_ == PairOrder::Padded) return;
  joint_columns_ =
      needed_columns(joint_indices_of(keys_at(0, joint_order), reversed_indices_, joint_indices_));
}

Lanes<std::uint64_t> SamplerBlock::keys_at(std::uint32_t bounce, Dimension dimension) const {
  Lanes<std::uint64_t> keys;
  for (std::size_t i = 0; i < period_; ++i)
    keys[i] = dimension_key(sequence_keys_[i], bounce, dimension);
  for (std::size_t i = period_; i < block_size; ++i) keys[i] = keys[i - period_];
  return keys;
}

Lanes<std::uint32_t> SamplerBlock::order_of(std::uint32_t bounce, Dimension dimension,
                                            const Lanes<std::uint64_t>& keys) const {
  Lanes<std::uint32_t> order;
  if (const BitColumns* matrix = matrix_of(order_, bounce, dimension))
    multiply(joint_indices_, *matrix, joint_columns_, order);
  else
    shuffle(keys, reversed_indices_, order);
  return order;
}

void SamplerBlock::sample_2d(std::uint32_t bounce, Dimension dimension,
                             SobolPointLanes& points) const {
  const Lanes<std::uint64_t> keys = keys_at(bounce, dimension);
  points_of(keys, order_of(bounce, dimension, keys), points);
}

void SamplerBlock::sample_1d(std::uint32_t bounce, Dimension dimension,
                             Lanes<std::uint32_t>& numbers) const {
  const Lanes<std::uint64_t> keys = keys_at(bounce, dimension);
  numbers_of(keys, order_of(bounce, dimension, keys), numbers);
}

}  // namespace candela
