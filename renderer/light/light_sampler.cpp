#include "renderer/light/light_sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace candela {
namespace {

// Nothing that shines is picked less often than every tenth of an equal share: what is dim may be
// all that lights the place where it stands.
void lift_dim_lights(std::vector<double>& weights) {
  double sum = 0;
  double count = 0;
  for (const double weight : weights)
    if (weight > 0) {
      sum += weight;
      ++count;
    }
  if (!std::isfinite(sum)) return;
  for (double& weight : weights)
    if (weight > 0) weight = std::max(weight, 0.1 * sum / count);
}

}  // namespace

LightSampler::LightSampler(std::span<const Light> lights, std::span<const double> powers) {
  std::vector<double> weights(powers.begin(), powers.end());
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (lights[i].is_delta() && powers[i] > 0) {
      always_.push_back(i);
      if (always_.size() > delta_limit) break;
    }
  if (always_.size() > delta_limit) always_.clear();
  for (const std::uint32_t i : always_) weights[i] = 0;
  lift_dim_lights(weights);
  table_ = AliasTable(weights);
  keep_few(weights);
}

// The same steps as the table's, so that its probabilities hold.
void LightSampler::keep_few(std::span<const double> weights) {
  constexpr std::uint64_t all = std::uint64_t{1} << 32;
  constexpr std::uint64_t fewest_steps = 1u << 22;
  if (table_.is_empty()) return;
  std::uint64_t first = 0;
  const std::vector<std::uint64_t> steps = proportional_steps(weights, all);
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    if (steps[i] == 0) continue;
    if (steps[i] < fewest_steps) return few_.clear();
    few_.push_back({static_cast<std::uint32_t>(first), i, 1 / static_cast<float>(steps[i]),
                    table_.probability(i)});
    first += steps[i];
  }
  make_guide();
}

void LightSampler::make_guide() {
  const auto guide_bits = static_cast<unsigned>(std::bit_width(2 * few_.size()));
  guide_shift_ = 32 - guide_bits;
  std::uint16_t index = 0;
  for (std::uint64_t cell = 0; cell <= std::uint64_t{1} << guide_bits; ++cell) {
    while (index + 1u < few_.size() && few_[index + 1u].first <= cell << guide_shift_) ++index;
    guide_.push_back(index);
  }
}

}  // namespace candela
