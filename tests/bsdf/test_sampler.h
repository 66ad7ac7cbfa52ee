// The chi-square test of a BSDF's own sampler.
#pragma once

#include "renderer/bsdf/dispatch.h"
#include "tests/statistics/direction_sampling.h"

namespace candela::tests {

[[nodiscard]] inline statistics::DirectionTestResult test_sampler(
    const Bsdf& bsdf, const Vec3f& wo, const statistics::DirectionGrid& grid, std::uint64_t seed,
    int count) {
  const auto sampler = [&](float lobe, Vec2f direction) -> std::optional<Vec3f> {
    const BsdfSample sample = sample_bsdf(bsdf, wo, lobe, direction);
    if (!(sample.pdf > 0)) return std::nullopt;
    return sample.wi;
  };
  const auto density = [&](const Vec3f& wi) { return double{evaluate_bsdf(bsdf, wo, wi).pdf}; };
  return statistics::test_directions(sampler, density, grid, seed, count);
}

}  // namespace candela::tests
