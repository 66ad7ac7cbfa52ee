#include "renderer/film/robust_mean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"
#include "renderer/film/sample_sum.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

constexpr std::uint32_t most_groups = 4;

// What n numbers of a normal distribution lack without the largest: their mean, over the standard
// deviation of those that stay; and the variance of the mean with that added, over theirs
// (order statistics of the normal distribution; tests/film/robust_mean_test.cpp draws them).
struct Trimming {
  double missing;
  double variance;
};
constexpr Trimming of_three{0.70711, 0.7640};
constexpr Trimming of_four{0.49278, 0.4571};

// Sixteen pixels side by side, by group: replicate r belongs to group r mod `most_groups`.
using GroupLanes = std::array<SampleSumLanes, most_groups>;

void put_sums(const Film& film, std::size_t pixel, std::size_t lane, GroupLanes& groups) {
  const SamplesByReplicate counts = film.samples_by_replicate(pixel);
  std::array<SampleSum, most_groups> sums;
  for (std::uint32_t r = 0; r < film.replicates(); ++r)
    sums[r % most_groups].add({film.replicate_sum(pixel, r), static_cast<double>(counts.of(r))});
  for (std::size_t g = 0; g < most_groups; ++g) groups[g].set(lane, sums[g]);
}

inline Vec3d mean_of(const SampleSum& sum) {
  return sum.radiance * (sum.samples > 0 ? 1 / sum.samples : 0.0);
}

inline double light_of(const SampleSum& sum, const Vec3d& mean) {
  return sum.samples > 0 ? sum_of_components(mean) : std::numeric_limits<double>::lowest();
}

inline double is_there(const SampleSum& sum) {
  return sum.samples > 0 ? 1.0 : 0.0;
}

inline Vec3d weighted_square(double weight, const Vec3d& deviation) {
  return weight * deviation * deviation;
}

// Of three groups or four; of fewer it tells nothing. Numbers that are 1 or 0 in place of booleans,
// and no arrays: vectors know neither.
inline RobustMean robust_of(const SampleSum& sum_a, const SampleSum& sum_b, const SampleSum& sum_c,
                            const SampleSum& sum_d) {
  const Vec3d a = mean_of(sum_a), b = mean_of(sum_b), c = mean_of(sum_c), d = mean_of(sum_d);
  const double light_a = light_of(sum_a, a), light_b = light_of(sum_b, b);
  const double light_c = light_of(sum_c, c), light_d = light_of(sum_d, d);
  const double most = std::max(std::max(light_a, light_b), std::max(light_c, light_d));
  const double a_is_most = light_a == most ? 1.0 : 0.0;
  const double b_is_most = (light_b == most ? 1.0 : 0.0) * (1 - a_is_most);
  const double c_is_most = (light_c == most ? 1.0 : 0.0) * (1 - a_is_most) * (1 - b_is_most);
  const double d_is_most = 1 - a_is_most - b_is_most - c_is_most;
  const double keep_a = is_there(sum_a) - a_is_most, keep_b = is_there(sum_b) - b_is_most;
  const double keep_c = is_there(sum_c) - c_is_most, keep_d = is_there(sum_d) - d_is_most;
  const double kept = keep_a + keep_b + keep_c + keep_d;
  const Vec3d mean = (keep_a * a + keep_b * b + keep_c * c + keep_d * d) * (1 / kept);
  const Vec3d squares = weighted_square(keep_a, a - mean) + weighted_square(keep_b, b - mean) +
                        weighted_square(keep_c, c - mean) + weighted_square(keep_d, d - mean);
  const Vec3d variance = squares * (1 / (kept - 1));
  const Vec3d deviation(std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z));
  const double missing = kept < 3 ? of_three.missing : of_four.missing;
  const double of_variance = kept < 3 ? of_three.variance : of_four.variance;
  const Vec3d robust = mean + missing * deviation;
  const double samples = sum_a.samples + sum_b.samples + sum_c.samples + sum_d.samples;
  const Vec3d whole = sum_a.radiance + sum_b.radiance + sum_c.radiance + sum_d.radiance;
  return {robust, of_variance * variance, whole * (1 / samples) - robust};
}

CANDELA_LANES void set_means(const GroupLanes& groups, RobustMeanLanes& __restrict means) {
  for (std::size_t i = 0; i < block_size; ++i)
    means.set(i, robust_of(groups[0][i], groups[1][i], groups[2][i], groups[3][i]));
}

}  // namespace

void robust_means(const Film& film, std::span<const std::size_t> pixels, RobustMeanLanes& means) {
  GroupLanes groups;
  for (std::size_t i = 0; i < pixels.size(); ++i) put_sums(film, pixels[i], i, groups);
  {
    const FloatingPointTraps traps(Traps::Off);  // lanes that nothing is in, or too little
    set_means(groups, means);
  }
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (used_replicates(film, pixels[i]) < 3)
      means.set(i, {film.mean(pixels[i]), variance_of_mean(film, pixels[i]), Vec3d(0.0)});
}

RobustMean robust_mean(const Film& film, std::size_t i) {
  RobustMeanLanes means;
  robust_means(film, {&i, 1}, means);
  return means[0];
}

}  // namespace candela
