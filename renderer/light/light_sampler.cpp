#include "renderer/light/light_sampler.h"

#include <cmath>
#include <limits>

#include "renderer/light/dim_lights.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

bool is_finite_in_space(const Light& light) {
  return light.kind != LightKind::Directional && light.kind != LightKind::Environment;
}

// Fewer are not worth asking for the place; more are at every hit.
constexpr std::size_t fewest_for_cells = 8;
constexpr std::size_t most_few = 1 << 10;

}  // namespace

LightSampler::LightSampler(std::span<const Light> lights, std::span<const double> powers)
    : weights_(powers.begin(), powers.end()) {
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (lights[i].is_delta() && powers[i] > 0) {
      always_.push_back(i);
      if (always_.size() > delta_limit) break;
    }
  if (always_.size() > delta_limit) always_.clear();
  for (const std::uint32_t i : always_) weights_[i] = 0;
  lift_dim_lights(weights_);
  table_ = AliasTable(weights_);
  keep_few();
}

// The same steps as the table's, so that its probabilities hold.
void LightSampler::keep_few() {
  constexpr std::uint64_t all = std::uint64_t{1} << 32;
  constexpr std::uint64_t fewest_steps = 1u << 22;
  if (table_.is_empty()) return;
  std::uint64_t first = 0;
  std::vector<LightRange> ranges;
  const std::vector<std::uint64_t> steps = proportional_steps(weights_, all);
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    if (steps[i] == 0) continue;
    if (steps[i] < fewest_steps) return;
    ranges.push_back({static_cast<std::uint32_t>(first), i, 1 / static_cast<float>(steps[i]),
                      table_.probability(i)});
    first += steps[i];
  }
  few_ = LightRanges(std::move(ranges));
}

void LightSampler::make_cells(std::span<const Light> lights, const Bounds3f& box) {
  std::size_t picked = 0;
  std::vector<float> probabilities(lights.size());
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (weights_[i] > 0) {
      ++picked;
      if (!std::isfinite(weights_[i]) || !is_finite_in_space(lights[i])) return;
    }
    probabilities[i] = table_.probability(i);
  }
  const bool has_extent = !box.is_empty() && max_component(box.extent()) > 0;
  if (picked < fewest_for_cells || !has_extent) return;
  cells_ = LightCells(lights, weights_, probabilities, box);
  bounces_with_cells_ = picked > most_few ? std::numeric_limits<std::uint32_t>::max() : 1;
}

// Of the lights that the cell's list lacks, and of the others as well: by power. What is left of
// the number has too few values for a table of 10^5 lights.
LightPick LightSampler::pick_other(std::uint32_t bits, std::uint32_t cell, Vec2f u) const {
  const auto bits_of = [](float x) { return static_cast<std::uint64_t>(x * 0x1p24f); };
  const std::uint64_t mixed = hash_combine(bits, bits_of(u.x) << 24 | bits_of(u.y));
  const std::uint32_t light = table_.pick(static_cast<std::uint32_t>(mixed >> 32));
  return {light, probability(light, cell)};
}

}  // namespace candela
