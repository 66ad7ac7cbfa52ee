// The stateless sampler: Owen-scrambled Sobol points by hashing, by named dimension.
//
// Each (pixel, bounce, dimension) sees its own nested scramble of the first two Sobol dimensions
// with its sample index shuffled by another [Burley20, section 5], so every pair is a
// (0,2)-sequence in base 2 in every prefix of a power of two, and pairs are independent of each
// other; but for those of a path's first vertices, which go together (joint_pairs.h).
#pragma once

#include <cstdint>

#include "renderer/math/vec.h"
#include "renderer/sampling/dimension.h"
#include "renderer/sampling/joint_pairs.h"
#include "renderer/sampling/sobol.h"

namespace candela {

// Of one named dimension of a sequence.
[[nodiscard]] constexpr std::uint64_t dimension_key(std::uint64_t sequence_key,
                                                    std::uint32_t bounce, Dimension dimension) {
  const std::uint64_t place = (std::uint64_t{bounce} << 8) | static_cast<std::uint64_t>(dimension);
  return hash_counter(sequence_key, place);
}

// How the pairs of a path's first vertices go: together, or each in an order of its own, as all
// others do.
enum class PairOrder : std::uint8_t { Joint, Padded };

// The matrix of a pair that goes together with those before it; else null.
[[nodiscard]] constexpr const BitColumns* matrix_of(PairOrder order, std::uint32_t bounce,
                                                    Dimension dimension) {
  return order == PairOrder::Joint ? joint_matrix(bounce, dimension) : nullptr;
}

// A point of a sequence, as hashing wants it.
struct SequencePlace {
  std::uint64_t sequence_key;
  std::uint32_t reversed_index;
  PairOrder order;
};

class Sampler {
 public:
  explicit Sampler(const SequencePlace& place)
      : sequence_key_(place.sequence_key),
        reversed_index_(place.reversed_index),
        order_(place.order) {}
  // Point `index` of the sequence that belongs to `sequence_key`.
  Sampler(std::uint64_t sequence_key, std::uint32_t index, PairOrder order = PairOrder::Joint)
      : Sampler(SequencePlace{sequence_key, reverse_bits(index), order}) {}
  // Of a pixel that has one sequence only.
  Sampler(std::uint64_t seed, std::uint32_t pixel_x, std::uint32_t pixel_y, std::uint32_t index)
      : Sampler(hash_pixel(seed, pixel_x, pixel_y), index) {}

  // Both in [0, 1).
  [[nodiscard]] Vec2f sample_2d(std::uint32_t bounce, Dimension dimension) const {
    const SobolPoint point = sample_2d_bits(bounce, dimension);
    return {unit_float(point.x), unit_float(point.y)};
  }
  // As 32-bit fractions.
  [[nodiscard]] SobolPoint sample_2d_bits(std::uint32_t bounce, Dimension dimension) const {
    const std::uint64_t key = dimension_key(sequence_key_, bounce, dimension);
    if (const BitColumns* matrix = matrix_of(order_, bounce, dimension))
      return scrambled_pair(multiplied(place_in_joint_order(), *matrix), key);
    return scrambled_sobol_2d(reversed_index_, key);
  }
  // In [0, 1).
  [[nodiscard]] float sample_1d(std::uint32_t bounce, Dimension dimension) const {
    return unit_float(sample_1d_bits(bounce, dimension));
  }
  // All 32 bits: for choices among so many things that 24 bits are too coarse.
  [[nodiscard]] std::uint32_t sample_1d_bits(std::uint32_t bounce, Dimension dimension) const {
    const std::uint64_t key = dimension_key(sequence_key_, bounce, dimension);
    if (const BitColumns* matrix = matrix_of(order_, bounce, dimension))
      return scrambled_number(multiplied(place_in_joint_order(), *matrix), key);
    return scrambled_sobol_1d(reversed_index_, key);
  }

 private:
  [[nodiscard]] constexpr std::uint32_t place_in_joint_order() const {
    return joint_index(reversed_index_,
                       static_cast<std::uint32_t>(dimension_key(sequence_key_, 0, joint_order)));
  }

  std::uint64_t sequence_key_;
  std::uint32_t reversed_index_;
  PairOrder order_;
};

// A pixel's replicates: sequences that are randomised independently of each other, so that their
// means tell the variance of the pixel [LEcuyer02, section 2]. Samples are dealt out in turn.
class PixelSampler {
 public:
  PixelSampler(std::uint64_t seed, std::uint32_t pixel_x, std::uint32_t pixel_y,
               std::uint32_t replicates, PairOrder order = PairOrder::Joint)
      : pixel_key_(hash_pixel(seed, pixel_x, pixel_y)), replicates_(replicates), order_(order) {}

  [[nodiscard]] Sampler at(std::uint32_t sample) const {
    return {sequence_key(sample % replicates_), sample / replicates_, order_};
  }
  [[nodiscard]] PairOrder order() const { return order_; }
  [[nodiscard]] std::uint32_t replicates() const { return replicates_; }
  [[nodiscard]] std::uint64_t sequence_key(std::uint32_t replicate) const {
    return hash_counter(pixel_key_, replicate);
  }

 private:
  std::uint64_t pixel_key_;
  std::uint32_t replicates_;
  PairOrder order_;
};

}  // namespace candela
