// A pixel's mean without the light that one replicate alone has met, and what that light adds.
//
// A sample that meets a rare, bright light (a caustic, a lamp by chance) makes a pixel look like
// none of its neighbours, and its variance so large that it looks like all of them. Without its
// brightest replicate it is what the other samples see; what is rare is told apart, to be averaged
// over many pixels.
#pragma once

#include <span>

#include "renderer/film/film.h"
#include "renderer/math/lanes.h"

namespace candela {

struct RobustMean {
  Vec3d mean{0.0};      // what the pixel's mean would be without rare light
  Vec3d variance{0.0};  // of `mean`
  Vec3d rare{0.0};      // the pixel's mean less `mean`: 0 on average where noise is normal
};

// Of the i-th pixel, from three or four replicates (more are put together to four groups): the mean
// without the brightest of them, and as much more as would be missing on average were all of them
// normal. With two replicates no light is known to be rare.
[[nodiscard]] RobustMean robust_mean(const Film& film, std::size_t i);

struct RobustMeanLanes {
  Vec3dLanes mean, variance, rare;

  [[nodiscard]] RobustMean operator[](std::size_t i) const {
    return {mean[i], variance[i], rare[i]};
  }
  void set(std::size_t i, const RobustMean& robust) {
    mean.set(i, robust.mean);
    variance.set(i, robust.variance);
    rare.set(i, robust.rare);
  }
};

// The same of up to sixteen pixels at once, bit by bit.
void robust_means(const Film& film, std::span<const std::size_t> pixels, RobustMeanLanes& means);

}  // namespace candela
