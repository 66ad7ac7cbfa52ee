// Picks lights for next-event estimation.
//
// With at most `delta_limit` delta lights each of them is sampled at every hit, and one more light
// is picked by power among the rest (triangles, environment). With more delta lights all are picked
// by power. Black lights are never picked, dim ones not less than every tenth of an equal share.
//
// Few lights are picked by inversion, neighbours side by side, and what is left of the number is
// good for a place on the light: points that are well spread over [0, 1)^2 are then well spread
// over all lights together, such as the two triangles of a lamp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/light/light.h"
#include "renderer/sampling/distribution.h"

namespace candela {

struct LightPick {
  std::uint32_t light = 0;
  float probability = 0;  // > 0
  float rest = 0;         // of the number that chose, in [0, 1): see has_few()
};

class LightSampler {
 public:
  static constexpr std::size_t delta_limit = 4;

  LightSampler() = default;
  // `powers`: one a light, from light_power(); 0 or NaN: black.
  LightSampler(std::span<const Light> lights, std::span<const double> powers);

  // Lights that are sampled at every hit, beside the one that is picked.
  [[nodiscard]] const std::vector<std::uint32_t>& always() const { return always_; }

  // False where only `always` has lights, or nothing has.
  [[nodiscard]] bool has_table() const { return !table_.is_empty(); }

  // Whether pick() tells what is left of the number, 22 bits of it at least.
  [[nodiscard]] bool has_few() const { return !few_.empty(); }

  // `bits`: 32 random bits (Sampler::sample_1d_bits). Only where has_table().
  [[nodiscard]] LightPick pick(std::uint32_t bits) const {
    if (has_few()) return pick_of_few(bits);
    const std::uint32_t light = table_.pick(bits);
    return {light, table_.probability(light)};
  }
  // With which pick() gives this light; 0 for black ones and those in `always`.
  [[nodiscard]] float probability(std::uint32_t light) const { return table_.probability(light); }

 private:
  // The 32-bit numbers that pick a light: from `first` up to the next one's.
  struct Range {
    std::uint32_t first;
    std::uint32_t light;
    float inverse_width;
    float probability;
  };

  [[nodiscard]] LightPick pick_of_few(std::uint32_t bits) const {
    const std::uint32_t cell = bits >> guide_shift_;
    std::size_t index = guide_[cell];
    for (std::size_t length = guide_[cell + 1] - index + 1; length > 1;) {
      const std::size_t half = length / 2;
      index += few_[index + half].first <= bits ? half : 0;
      length -= half;
    }
    const Range& range = few_[index];
    const float rest = static_cast<float>(bits - range.first) * range.inverse_width;
    return {range.light, range.probability, std::min(rest, one_minus_epsilon)};
  }
  void keep_few(std::span<const double> weights);
  void make_guide();

  std::vector<std::uint32_t> always_;
  AliasTable table_;        // over all lights; weight 0 for those in `always`
  std::vector<Range> few_;  // of the lights in the table; empty where they are many
  // By the leading bits of a number: where in `few_` the search for its light begins, and by the
  // next entry where it ends [Chen74].
  std::vector<std::uint16_t> guide_;
  unsigned guide_shift_ = 0;
};

}  // namespace candela
