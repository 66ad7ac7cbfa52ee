// The nearest hit by asking every triangle in double: the oracle of both accelerators.
#pragma once

#include "integrators/ray_bench/compare_hits.h"

namespace candela::test {

// Empty where the answer is possible in float arithmetic, else what is wrong with it. Possible:
// what was hit is hit, at that distance, within error bounds, and no triangle that is hit clearly
// lies nearer. Cut-outs are not asked.
[[nodiscard]] std::string brute_force_complaint(const Scene& scene, const Ray& ray,
                                                const Hit& answer);

}  // namespace candela::test
