#include "renderer/film/sample_density.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/film/error_estimate.h"
#include "renderer/film/heavy_tails.h"
#include "renderer/sampling/sampler_block.h"

namespace candela {
namespace {

// Means over (2 radius + 1)^2 pixels, fewer at the edges; along rows, then along columns.
std::vector<double> smoothed(const std::vector<double>& values, int width, int height, int radius) {
  const auto mean_along = [radius](const std::vector<double>& in, int count, int lines,
                                   auto place) {
    std::vector<double> out(in.size());
    std::vector<double> sums(static_cast<std::size_t>(count) + 1, 0.0);
    for (int line = 0; line < lines; ++line) {
      for (int i = 0; i < count; ++i)
        sums[static_cast<std::size_t>(i) + 1] =
            sums[static_cast<std::size_t>(i)] + in[place(i, line)];
      for (int i = 0; i < count; ++i) {
        const int begin = std::max(i - radius, 0);
        const int end = std::min(i + radius + 1, count);
        out[place(i, line)] =
            (sums[static_cast<std::size_t>(end)] - sums[static_cast<std::size_t>(begin)]) /
            (end - begin);
      }
    }
    return out;
  };
  const auto row = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  const auto column = [&row](int y, int x) { return row(x, y); };
  return mean_along(mean_along(values, width, height, row), height, width, column);
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> costs_of(const Film& film) {
  std::vector<double> costs(film.pixel_count());
  for (std::size_t i = 0; i < costs.size(); ++i) costs[i] = film.cost(i);
  return costs;
}

std::vector<double> roots_of_error_over_cost(const Film& pilot) {
  constexpr int radius = 3;
  const auto smooth = [&](const std::vector<double>& values) {
    return smoothed(values, pilot.full_width(), pilot.full_height(), radius);
  };
  const std::vector<double> costs = smooth(costs_of(pilot));
  std::vector<double> roots = smooth(pixel_errors(pilot));
  for (std::size_t i = 0; i < roots.size(); ++i)
    roots[i] = std::sqrt(std::max(roots[i], 0.0) / std::max(costs[i], 1.0));
  return roots;
}

// To ten times the mean that is then left: one firefly shall not take all.
void limit_fireflies(std::vector<double>& values) {
  constexpr double most = 10;
  constexpr int rounds = 20;  // each takes away most of what is too much
  for (int i = 0; i < rounds; ++i) {
    const double limit = most * mean_of(values);
    for (double& value : values) value = std::min(value, limit);
  }
}

double heavy_tailed_share(const Film& film) {
  const std::vector<bool> mask = heavy_tail_mask(film);
  return static_cast<double>(std::count(mask.begin(), mask.end(), true)) /
         static_cast<double>(mask.size());
}

}  // namespace

SampleDensity::SampleDensity(const Film& pilot)
    : width_(static_cast<std::size_t>(pilot.full_width())), replicates_(pilot.replicates()) {
  // The share of the samples that all pixels get alike; all of them where light comes in samples
  // too rare for a pilot to know anything.
  constexpr double least_alike = 0.1;
  const double alike = std::max(least_alike, heavy_tailed_share(pilot));
  std::vector<double> roots = roots_of_error_over_cost(pilot);
  limit_fireflies(roots);
  const double mean = mean_of(roots);
  values_.reserve(roots.size());
  for (const double root : roots)
    values_.push_back(static_cast<float>(mean > 0 ? alike + (1 - alike) * root / mean : 1.0));
}

std::uint32_t SampleDensity::samples(int x, int y, std::uint32_t mean) const {
  if (mean == 0) return 0;
  const double wanted = static_cast<double>(at(x, y)) * mean;
  const std::uint32_t whole = std::lcm(replicates_, sampler_lanes);  // traced together
  const std::uint32_t step = wanted < 0.75 * whole ? replicates_ : whole;
  const double steps = std::max(std::floor(wanted / step + 0.5), 1.0);
  return static_cast<std::uint32_t>(steps) * step;
}

}  // namespace candela
