// What random numbers cost: those that a path takes over its first bounces.
#pragma once

namespace candela {

// Nanoseconds of CPU time of one thread a dimension, a pair being two; medians of rounds.
struct NumberFigures {
  double block_ns = 0;   // of sixteen samples side by side (SamplerBlock)
  double single_ns = 0;  // of one sample (Sampler)
};

// Both ways in turn, at least five times, until they have taken `seconds` each in the mean.
[[nodiscard]] NumberFigures run_number_bench(double seconds);

}  // namespace candela
