#include "renderer/light/light_sampler.h"

#include <algorithm>

namespace candela {

LightSampler::LightSampler(std::span<const Light> lights, std::span<const double> powers) {
  std::vector<double> weights(powers.begin(), powers.end());
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (lights[i].is_delta() && powers[i] > 0) {
      always_.push_back(i);
      if (always_.size() > delta_limit) break;
    }
  if (always_.size() > delta_limit) always_.clear();
  for (const std::uint32_t i : always_) weights[i] = 0;
  table_ = AliasTable(weights);
}

}  // namespace candela
