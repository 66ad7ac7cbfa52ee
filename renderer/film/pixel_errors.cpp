#include "renderer/film/pixel_errors.h"

#include <algorithm>

#include "renderer/base/parallel.h"
#include "renderer/film/neighbour_level.h"
#include "renderer/film/tiles.h"
#include "renderer/film/variance.h"
#include "renderer/image/relmse.h"

namespace candela {
namespace {

// 1 / (r^2 + epsilon) of one channel from an estimate of r with a known variance. Plugging it in
// overstates where it is noisy; the second-order term of Taylor's series takes that away.
double inverse_square(double estimate, double variance, double epsilon) {
  const double square = estimate * estimate;
  const double sum = square + epsilon;
  const double curvature = (6 * square - 2 * epsilon) / (sum * sum);  // of the inverse, over it
  constexpr double most = 0.5;  // of the correction, where the series says nothing
  return (1 - std::clamp(0.5 * curvature * variance, -most, most)) / sum;
}

// The mean over the channels of `variance` over what is there.
double error_beside(const PixelLevel& level, const Vec3d& variance, double epsilon) {
  double sum = 0;
  for (int c = 0; c < 3; ++c)
    sum += variance[c] * inverse_square(level.mean[c], level.variance[c], epsilon);
  return sum / 3;
}

// Between the neighbours that look alike and `own`, the pixel's mean over a share of its samples:
// as near to it as its noise is small beside their structure [James61]; never far below them, since
// a pixel whose light comes in rare samples is black without those. Where too much noise is left,
// all that is near by. Rare light comes on top: the pixel's own says little of how rare it is.
PixelLevel level_of(const NeighbourLevel& near, const Vec3d& own, double own_share,
                    double epsilon) {
  PixelLevel level;
  for (int c = 0; c < 3; ++c) {
    const double own_noise = own_share > 0 ? near.own_variance[c] / own_share : 0;
    const double trust = own_share > 0 && near.structure[c] > 0
                             ? near.structure[c] / (near.structure[c] + own_noise)
                             : 0;
    constexpr double lowest = 1.0 / 3;
    level.mean[c] = std::max(near.mean[c] + trust * (own[c] - near.mean[c]), lowest * near.mean[c]);
    level.variance[c] = (1 - trust) * (1 - trust) * near.noise[c];
  }
  constexpr double much = 0.3;  // variance over level: at twice that nothing else counts
  const double noise = sum_of_components(level.variance / (level.mean * level.mean + epsilon)) / 3;
  const double blend = std::clamp(noise / much - 1, 0.0, 1.0);
  return {mix(level.mean, near.wide_mean, blend) + near.rare,
          level.variance * (1 - blend) * (1 - blend) + near.rare_noise};
}

// The squared error of a pixel over what is there, from a pair of replicates. The level that it is
// held against is made without the pair: were it of the same noise, pixels that are too bright by
// chance would hide their own error.
double error_of_pair(const Film& film, std::size_t i, std::uint32_t a, std::uint32_t b,
                     const NeighbourLevel& near, double epsilon) {
  const double samples = film.samples(i);
  const double samples_a = film.samples_of_replicate(i, a);
  const double samples_b = film.samples_of_replicate(i, b);
  const Vec3d& sum_a = film.replicate_sum(i, a);
  const Vec3d& sum_b = film.replicate_sum(i, b);
  const Vec3d difference = sum_a / samples_a - sum_b / samples_b;
  // One sample's variance is that of the difference over 1 / samples_a + 1 / samples_b.
  const Vec3d variance = difference * difference / ((1 / samples_a + 1 / samples_b) * samples);
  const double left = samples - samples_a - samples_b;
  const Vec3d own = left > 0 ? (samples * film.mean(i) - sum_a - sum_b) / left : Vec3d(0.0);
  return error_beside(level_of(near, own, left / samples, epsilon), variance, epsilon);
}

// Over pairs of neighbours in the ring of the replicates, one or two steps apart: all pairs of up
// to five replicates, and not too many of more.
double relative_error(const Film& film, std::size_t i, const NeighbourLevel& near, double epsilon) {
  const std::uint32_t replicates = used_replicates(film, i);
  double sum = 0;
  std::uint32_t pairs = 0;
  for (std::uint32_t step = 1; step <= 2 && 2 * step <= replicates; ++step) {
    const std::uint32_t count = 2 * step == replicates ? step : replicates;  // no pair twice
    for (std::uint32_t a = 0; a < count; ++a)
      sum += error_of_pair(film, i, a, (a + step) % replicates, near, epsilon);
    pairs += count;
  }
  return sum / pairs;
}

double mean_radiance(const Film& film) {
  double sum = 0;
  for (std::size_t i = 0; i < film.pixel_count(); ++i) sum += sum_of_components(film.mean(i));
  return sum / (3.0 * static_cast<double>(film.pixel_count()));
}

}  // namespace

std::optional<PixelErrors> estimate_pixel_errors(const Film& film) {
  const std::uint32_t replicates = std::min(film.min_samples(), film.replicates());
  if (replicates < 2) return {};
  PixelErrors result;
  result.errors.resize(film.pixel_count());
  result.epsilon = relmse_epsilon(mean_radiance(film));
  if (result.is_black()) return result;
  constexpr int block_size = 64;
  const std::vector<PixelRect> blocks = tiles_of(film.crop(), block_size);
  parallel_for(blocks.size(), [&](std::size_t b) {
    const std::vector<NeighbourLevel> levels = neighbour_levels(film, blocks[b]);
    std::size_t next = 0;
    for (int y = blocks[b].y0; y < blocks[b].y1; ++y)
      for (int x = blocks[b].x0; x < blocks[b].x1; ++x) {
        const std::size_t i = film.index(x, y);
        result.errors[i] = relative_error(film, i, levels[next++], result.epsilon);
      }
  });
  return result;
}

double error_at_level(const Film& film, std::size_t i, const PixelLevel& level, double epsilon) {
  return error_beside(level, variance_of_mean(film, i), epsilon);
}

}  // namespace candela
