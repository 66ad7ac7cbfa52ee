#include "renderer/film/alike_sums.h"

#include <algorithm>

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

constexpr int search_radius = 2;  // where neighbours that look alike are looked for
constexpr int patch_radius = 1;   // what is compared of them
static_assert(search_radius + 2 * patch_radius <= alike_margin);
static_assert(patch_radius == 1, "nine distances are added up");

struct Level {
  double level;
  double variance;
};

// How much two pixels differ beyond what their noise explains, over it [Rousselle12, eq. 4]:
// about 0 where they have the same expectation.
inline double distance(const Level& a, const Level& b) {
  const double difference = a.level - b.level;
  const double variance = a.variance + b.variance;
  const double chance = a.variance + std::min(a.variance, b.variance);
  const double excess = difference * difference - chance;
  const double without_noise = difference == 0 ? 0.0 : 1e10;
  return variance > 0 ? excess / variance : without_noise;
}

// From the pixels at a and b on.
CANDELA_LANES void set_distances(std::size_t count, const double* levels_a,
                                 const double* variances_a, const double* levels_b,
                                 const double* variances_b, double* __restrict distances) {
  for (std::size_t i = 0; i < count; ++i)
    distances[i] = distance({levels_a[i], variances_a[i]}, {levels_b[i], variances_b[i]});
}

// The mean distance of the 3x3 pixels around the two, where it is more than what `means` has.
// `distances`: from the first of the three above on, in rows of `width`.
CANDELA_LANES void raise_to_means(std::size_t count, const double* distances, std::size_t width,
                                  double* __restrict means) {
  const double* above = distances;
  const double* here = above + width;
  const double* below = here + width;
  for (std::size_t i = 0; i < count; ++i) {
    const double sum = (above[i] + above[i + 1] + above[i + 2]) +
                       (here[i] + here[i + 1] + here[i + 2]) +
                       (below[i] + below[i + 1] + below[i + 2]);
    means[i] = std::max(sum / 9, means[i]);
  }
}

// `means`: distances, and weights behind.
CANDELA_LANES void set_weights(std::size_t count, const double* counts, double* __restrict means,
                               double* __restrict sums) {
  for (std::size_t i = 0; i < count; ++i) {
    means[i] = counts[i] / ((1 + means[i]) * (1 + means[i]));
    sums[i] += means[i];
  }
}

CANDELA_LANES void add_weighted(std::size_t count, const double* weights, const double* means,
                                const double* variances, const double* squares,
                                double* __restrict mean_sums, double* __restrict square_sums,
                                double* __restrict noise_sums) {
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weights[i];
    mean_sums[i] += weight * means[i];
    square_sums[i] += weight * squares[i];
    noise_sums[i] += weight * weight * variances[i];
  }
}

AlikeSums zeros(std::size_t count) {
  AlikeSums sums;
  sums.weights.resize(count);
  for (Planes* planes : {&sums.means, &sums.squares, &sums.noises})
    for (Plane& plane : *planes) plane.resize(count);
  return sums;
}

}  // namespace

AlikeSums alike_sums(const GreyPixels& grey, const std::array<ChannelPixels, 3>& channels,
                     std::size_t first, std::size_t count) {
  AlikeSums sums = zeros(count);
  const std::size_t reach = grey.width + patch_radius;  // back and on to the corners of a patch
  Plane distances(count + 2 * reach);
  Plane weights(count);
  for (int dy = -search_radius; dy <= search_radius; ++dy)
    for (int dx = -search_radius; dx <= search_radius; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const auto shifted = [&](std::size_t i) {
        return i + static_cast<std::size_t>(dy) * grey.width + static_cast<std::size_t>(dx);
      };
      const std::size_t a = first - reach;
      std::ranges::fill(weights, 0.0);
      const auto compare = [&](const Plane& levels, const Plane& variances) {
        set_distances(distances.size(), &levels[a], &variances[a], &levels[shifted(a)],
                      &variances[shifted(a)], distances.data());
        raise_to_means(count, distances.data(), grey.width, weights.data());
      };
      compare(grey.levels, grey.variances);
      for (const ChannelPixels& channel : channels) compare(channel.means, channel.variances);
      set_weights(count, &grey.counts[shifted(first)], weights.data(), sums.weights.data());
      for (std::size_t c = 0; c < channels.size(); ++c)
        add_weighted(count, weights.data(), &channels[c].means[shifted(first)],
                     &channels[c].variances[shifted(first)], &channels[c].squares[shifted(first)],
                     sums.means[c].data(), sums.squares[c].data(), sums.noises[c].data());
    }
  return sums;
}

}  // namespace candela
