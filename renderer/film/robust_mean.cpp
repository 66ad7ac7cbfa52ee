#include "renderer/film/robust_mean.h"

#include <algorithm>
#include <array>
#include <cmath>

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

// Of the replicates r with r mod `most_groups` = g.
Vec3d group_mean(const Film& film, std::size_t i, std::uint32_t g, std::uint32_t replicates) {
  Vec3d sum(0.0);
  double samples = 0;
  for (std::uint32_t r = g; r < replicates; r += most_groups) {
    sum += film.replicate_sum(i, r);
    samples += film.samples_of_replicate(i, r);
  }
  return sum / samples;
}

}  // namespace

RobustMean robust_mean(const Film& film, std::size_t i) {
  const std::uint32_t replicates = used_replicates(film, i);
  if (replicates < 3) return {film.mean(i), variance_of_mean(film, i), Vec3d(0.0)};
  const std::uint32_t groups = std::min(replicates, most_groups);
  std::array<Vec3d, most_groups> means;
  for (std::uint32_t g = 0; g < groups; ++g) means[g] = group_mean(film, i, g, replicates);
  const auto end = means.begin() + groups;
  std::iter_swap(end - 1, std::max_element(means.begin(), end, [](const Vec3d& a, const Vec3d& b) {
                   return sum_of_components(a) < sum_of_components(b);
                 }));
  const double kept = groups - 1;
  Vec3d mean(0.0);
  for (std::uint32_t g = 0; g + 1 < groups; ++g) mean += means[g] / kept;
  Vec3d variance(0.0);
  for (std::uint32_t g = 0; g + 1 < groups; ++g)
    variance += (means[g] - mean) * (means[g] - mean) / (kept - 1);
  const Trimming trimming = groups == 3 ? of_three : of_four;
  const Vec3d deviation(std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z));
  mean += trimming.missing * deviation;
  return {mean, trimming.variance * variance, film.mean(i) - mean};
}

}  // namespace candela
