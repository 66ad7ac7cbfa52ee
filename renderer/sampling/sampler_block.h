// The numbers of sixteen samples at once, consecutive ones of a pixel or those of several pixels:
// the same bits as Sampler's, side by side in the lanes of the processor's vectors.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/math/lanes.h"
#include "renderer/sampling/sampler.h"

namespace candela {

// 32-bit fractions; unit_float() makes numbers in [0, 1) of them.
struct SobolPointLanes {
  Lanes<std::uint32_t> x;
  Lanes<std::uint32_t> y;
};

// Sixteen points, each of a sequence of its own.
struct SequenceLanes {
  Lanes<std::uint64_t> keys{};
  Lanes<std::uint32_t> indices{};
  PairOrder order = PairOrder::Joint;

  void set(std::size_t i, const PixelSampler& pixel, std::uint32_t sample) {
    keys[i] = pixel.sequence_key(sample % pixel.replicates());
    indices[i] = sample / pixel.replicates();
  }
};

class SamplerBlock {
 public:
  // Samples first_sample to first_sample + 15 of the pixel. Where a sample's path is split, each of
  // its `branches` has a point of its own: branch b of point i is point i * branches + b.
  SamplerBlock(const PixelSampler& pixel, std::uint32_t first_sample, std::uint32_t branches = 1,
               std::uint32_t branch = 0);
  explicit SamplerBlock(const SequenceLanes& sequences);

  [[nodiscard]] Sampler lane(std::size_t i) const {
    return Sampler(SequencePlace{sequence_keys_[i], reversed_indices_[i], order_});
  }
  void sample_2d(std::uint32_t bounce, Dimension dimension, SobolPointLanes& points) const;
  void sample_1d(std::uint32_t bounce, Dimension dimension, Lanes<std::uint32_t>& numbers) const;

 private:
  void find_joint_indices();
  [[nodiscard]] Lanes<std::uint64_t> keys_at(std::uint32_t bounce, Dimension dimension) const;
  // The indices in the order of a dimension, whose keys these are.
  [[nodiscard]] Lanes<std::uint32_t> order_of(std::uint32_t bounce, Dimension dimension,
                                              const Lanes<std::uint64_t>& keys) const;

  Lanes<std::uint64_t> sequence_keys_;
  Lanes<std::uint32_t> reversed_indices_;
  Lanes<std::uint32_t> joint_indices_;  // joint_index() of each
  std::uint32_t joint_columns_ = 0;     // needed_columns() of all of them
  std::size_t period_;                  // of the sequence keys over the lanes
  PairOrder order_;
};

}  // namespace candela
