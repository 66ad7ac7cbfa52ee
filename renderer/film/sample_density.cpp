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

std::size_t colour_of(int x, int y) {
  return static_cast<std::size_t>(x + y) & 1;
}

// The pixels of one colour, pushed together along rows. Where a row ends with the other colour, its
// last pixel stands twice.
Film pixels_of(const Film& film, std::size_t colour) {
  const int width = (film.full_width() + 1) / 2;
  Film pixels(width, film.full_height(), {0, 0, width, film.full_height()}, 0, film.replicates());
  for (int y = 0; y < film.full_height(); ++y)
    for (int x = 0; x < width; ++x) {
      const int wanted = 2 * x + (colour_of(0, y) == colour ? 0 : 1);
      const int there = wanted < film.full_width() ? wanted : wanted - 2;
      pixels.take_pixel(pixels.index(x, y), film, film.index(there, y));
    }
  return pixels;
}

// What the pixels of one colour, as pixels_of() has them, say over all pixels: means over those of
// 7x7.
std::vector<double> spread(const std::vector<double>& of_colour, std::size_t colour,
                           const Film& pilot) {
  constexpr int radius = 3;
  const auto width = static_cast<std::size_t>(pilot.full_width());
  std::vector<double> values(pilot.pixel_count(), 0.0);
  std::vector<double> counts(pilot.pixel_count(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t x = i % width;
    const std::size_t y = i / width;
    if (colour_of(static_cast<int>(x), static_cast<int>(y)) != colour) continue;
    values[i] = of_colour[y * ((width + 1) / 2) + x / 2];
    counts[i] = 1;
  }
  values = smoothed(values, pilot.full_width(), pilot.full_height(), radius);
  counts = smoothed(counts, pilot.full_width(), pilot.full_height(), radius);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] /= counts[i];
  return values;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> costs_of(const Film& film) {
  std::vector<double> costs(film.pixel_count());
  for (std::size_t i = 0; i < costs.size(); ++i) costs[i] = film.cost(i);
  return costs;
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

// What the pixels of one colour say that all pixels should get, relative to a mean of 1.
std::vector<double> density_by(std::size_t colour, const Film& pilot) {
  const Film pixels = pixels_of(pilot, colour);
  const std::vector<double> costs = spread(costs_of(pixels), colour, pilot);
  std::vector<double> roots = spread(pixel_errors(pixels), colour, pilot);
  for (std::size_t i = 0; i < roots.size(); ++i)
    roots[i] = std::sqrt(std::max(roots[i], 0.0) / std::max(costs[i], 1.0));
  limit_fireflies(roots);
  // The share of the samples that all pixels get alike; all of them where light comes in samples
  // too rare for a pilot to know anything.
  constexpr double least_alike = 0.1;
  const double alike = std::max(least_alike, heavy_tailed_share(pixels));
  const double mean = mean_of(roots);
  for (double& root : roots) root = mean > 0 ? alike + (1 - alike) * root / mean : 1.0;
  return roots;
}

}  // namespace

SampleDensity::SampleDensity(const Film& pilot)
    : width_(static_cast<std::size_t>(pilot.full_width())),
      replicates_(pilot.replicates()),
      pilot_samples_(pilot.samples(0)) {
  const std::array<std::vector<double>, 2> by{density_by(0, pilot), density_by(1, pilot)};
  values_.reserve(pilot.pixel_count());
  for (std::size_t i = 0; i < pilot.pixel_count(); ++i) {
    const std::size_t colour =
        colour_of(static_cast<int>(i % width_), static_cast<int>(i / width_));
    values_.push_back(static_cast<float>(by[1 - colour][i]));
    colours_[colour].values.push_back(static_cast<double>(values_.back()));
  }
  for (Colour& colour : colours_) {
    std::sort(colour.values.begin(), colour.values.end());
    colour.sums = colour.values;
    for (std::size_t i = colour.sums.size() - 1; i-- > 0;) colour.sums[i] += colour.sums[i + 1];
  }
}

// The first `i` pixels get the least, the others a scale times their values: the smallest i at
// which that is not too little for the first of the others.
double SampleDensity::Colour::scale(double pilot_samples, double mean) const {
  const double all = mean * static_cast<double>(values.size());
  const auto scale_from = [&](std::size_t i) {
    return (all - pilot_samples * static_cast<double>(i)) / sums[i];
  };
  std::size_t low = 0;
  std::size_t high = values.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (scale_from(middle) * values[middle] >= pilot_samples)
      high = middle;
    else
      low = middle + 1;
  }
  return scale_from(low);
}

std::uint32_t SampleDensity::samples(int x, int y, std::uint32_t mean) const {
  const double wanted =
      static_cast<double>(at(x, y)) * colours_[colour_of(x, y)].scale(pilot_samples_, mean) -
      pilot_samples_;
  if (mean <= pilot_samples_ || wanted <= 0) return pilot_samples_;
  const std::uint32_t whole = std::lcm(replicates_, sampler_lanes);  // traced together
  const std::uint32_t step = wanted < 0.75 * whole ? replicates_ : whole;
  return pilot_samples_ + static_cast<std::uint32_t>(wanted / step + 0.5) * step;
}

}  // namespace candela
