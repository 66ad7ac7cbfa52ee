// The squared errors of sixteen pixels side by side, each over what is there, told from pairs of
// replicates: loops that become vectors (renderer/base/vector_widths.h).
#pragma once

#include "renderer/film/neighbour_level.h"
#include "renderer/film/pixel_errors.h"
#include "renderer/film/sample_sum.h"

namespace candela {

struct LevelLanes {
  Vec3dLanes mean, noise, structure, wide_mean, own_variance, rare, rare_noise;
  Lanes<double> company;

  [[nodiscard]] NeighbourLevel operator[](std::size_t i) const {
    return {mean[i],         noise[i], structure[i],  wide_mean[i],
            own_variance[i], rare[i],  rare_noise[i], company[i]};
  }
  void set(std::size_t i, const NeighbourLevel& level) {
    mean.set(i, level.mean);
    noise.set(i, level.noise);
    structure.set(i, level.structure);
    wide_mean.set(i, level.wide_mean);
    own_variance.set(i, level.own_variance);
    rare.set(i, level.rare);
    rare_noise.set(i, level.rare_noise);
    company[i] = level.company;
  }
};

// Adds what replicates a and b, each of at least one sample of all, `whole`, say.
void add_errors_of_pair(const LevelLanes& near, const SampleSumLanes& whole,
                        const SampleSumLanes& a, const SampleSumLanes& b, double epsilon,
                        Lanes<double>& errors);

// The mean over the channels of `variance` over what is there.
[[nodiscard]] double error_beside(const PixelLevel& level, const Vec3d& variance, double epsilon);

}  // namespace candela
