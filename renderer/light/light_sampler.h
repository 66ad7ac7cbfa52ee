// Picks lights for next-event estimation.
//
// With at most `delta_limit` delta lights each of them is sampled at every hit, and one more light
// is picked by power among the rest (triangles, environment). With more delta lights all are picked
// by power. Black lights are never picked, dim ones not less than every tenth of an equal share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/light/light.h"
#include "renderer/sampling/distribution.h"

namespace candela {

struct LightPick {
  std::uint32_t light = 0;
  float probability = 0;  // > 0
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

  // `bits`: 32 random bits (Sampler::sample_1d_bits). Only where has_table().
  [[nodiscard]] LightPick pick(std::uint32_t bits) const {
    const std::uint32_t light = table_.pick(bits);
    return {light, table_.probability(light)};
  }
  // With which pick() gives this light; 0 for black ones and those in `always`.
  [[nodiscard]] float probability(std::uint32_t light) const { return table_.probability(light); }

 private:
  std::vector<std::uint32_t> always_;
  AliasTable table_;  // over all lights; weight 0 for those in `always`
};

}  // namespace candela
