// Which estimators of the light at a surface an integrator uses, alone or together.
#pragma once

#include <cstdint>
#include <string_view>

namespace candela {

//            light at a surface          next direction   lamps that a path meets
//   Mis      light samples and BSDF      BSDF             weighted against light samples
//   Light    light samples               BSDF             not counted: the light samples have them
//   Bsdf     none                        BSDF             counted
//   Cosine   light samples               by the cosine    not counted
//   Uniform  light samples               uniform          not counted
//
// Lamps that a path meets after a delta lobe count for all, since no light sample has them. All
// converge to the same picture but for what they cannot see: Cosine and Uniform do not draw a delta
// lobe that others stand beside, and Bsdf does not find delta lights (check_sampling.h refuses such
// scenes).
enum class SamplingStrategy : std::uint8_t { Mis, Light, Bsdf, Cosine, Uniform };

[[nodiscard]] constexpr std::string_view name_of(SamplingStrategy strategy) {
  switch (strategy) {
    case SamplingStrategy::Mis:
      return "mis";
    case SamplingStrategy::Light:
      return "light";
    case SamplingStrategy::Bsdf:
      return "bsdf";
    case SamplingStrategy::Cosine:
      return "cosine";
    case SamplingStrategy::Uniform:
      return "uniform";
  }
  return "";
}

[[nodiscard]] constexpr bool samples_lights(SamplingStrategy strategy) {
  return strategy != SamplingStrategy::Bsdf;
}
[[nodiscard]] constexpr bool counts_met_light(SamplingStrategy strategy) {
  return strategy == SamplingStrategy::Mis || strategy == SamplingStrategy::Bsdf;
}
[[nodiscard]] constexpr bool samples_bsdfs(SamplingStrategy strategy) {
  return strategy != SamplingStrategy::Cosine && strategy != SamplingStrategy::Uniform;
}

}  // namespace candela
