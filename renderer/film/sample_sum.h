// Sums over some of a pixel's samples, of one pixel and of sixteen side by side.
#pragma once

#include "renderer/math/lanes.h"

namespace candela {

struct SampleSum {
  Vec3d radiance{0.0};
  double samples = 0;

  void add(const SampleSum& more) {
    radiance += more.radiance;
    samples += more.samples;
  }
};

struct SampleSumLanes {
  Vec3dLanes radiance;
  Lanes<double> samples{};

  [[nodiscard]] SampleSum operator[](std::size_t i) const { return {radiance[i], samples[i]}; }
  void set(std::size_t i, const SampleSum& sum) {
    radiance.set(i, sum.radiance);
    samples[i] = sum.samples;
  }
};

}  // namespace candela
