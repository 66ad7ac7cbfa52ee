// What every lamp owes to every point, however close, grazing or far.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/light/light.h"

namespace candela::light_test {

// `count` samples from each point, with the normals none, z and x: no NaN, no infinity, unit
// directions, and densities, of what is met straight along z as well, that are not negative.
void expect_finite_samples(const Light& light, std::span<const Vec3f> points,
                           std::uint64_t count = 1000);

}  // namespace candela::light_test
