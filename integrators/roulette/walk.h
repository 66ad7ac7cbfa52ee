// What another Russian roulette would have made of a path.
#pragma once

#include <vector>

#include "integrators/path_plan.h"
#include "renderer/math/vec.h"

namespace candela {

// A surface that a path left, by a roulette of its own.
struct WalkStep {
  float throughput = 0;  // that roulette went by
  float survival = 1;    // the probability with which it let the path live
  Rgb radiance{0};       // what the path had brought by then
};

// A whole path of a camera sample.
struct Walk {
  // As a film does.
  void multiply_radiance(const Mat3d& balance) {
    for (WalkStep& step : steps) step.radiance = Rgb(balance * Vec3d(step.radiance));
    radiance = Rgb(balance * Vec3d(radiance));
  }

  std::vector<WalkStep> steps;  // step i: at bounce i
  Rgb radiance{0};              // in all
};

// Expectations of another roulette, as far as one walk tells.
struct RouletteOutcome {
  Vec3d variance{0};   // of the radiance, beyond that by the walk's own roulette
  double bounces = 0;  // after the camera ray
};

// What comes after step k, R_k, is there with probability P_k = p_0 ... p_k by the walk's own
// roulette, and counts 1 / P_k; the other one has Q_k. So the second moment of a walk changes by
// the sum over k of R_k^2 (P_k / Q_k - P_k-1 / Q_k-1), and the bounces are the sum of Q_k / P_k.
[[nodiscard]] RouletteOutcome expected_under(const Walk& walk, Roulette other);

}  // namespace candela
