// What random numbers cost: those that a path takes over its first bounces.
#pragma once

#include <cstdint>

namespace candela {

// Nanoseconds of CPU time of one thread a dimension, a pair being two. The best of several rounds,
// since the others were disturbed.
struct NumberFigures {
  double block_ns = 0;   // of sixteen samples side by side (SamplerBlock)
  double single_ns = 0;  // of one sample (Sampler)
};

// Over rounds of at least `seconds` each way, at least three.
[[nodiscard]] NumberFigures run_number_bench(double seconds);

}  // namespace candela
