#include "renderer/film/doubtful_pixels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "renderer/base/parallel.h"
#include "renderer/film/robust_mean.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

// The most that a pixel's error may be: as it is stated, or were the pixel no brighter than without
// its rare light, `level`.
double greatest_error(const Film& film, std::size_t i, const Vec3d& level,
                      const PixelErrors& errors) {
  const Vec3d variance = variance_of_mean(film, i);
  return std::max(errors.errors[i],
                  sum_of_components(variance / (level * level + errors.epsilon)) / 3);
}

std::vector<double> greatest_errors(const Film& film, const PixelErrors& errors) {
  std::vector<double> greatest(film.pixel_count());
  parallel_for((greatest.size() + block_size - 1) / block_size, [&](std::size_t part) {
    Lanes<std::size_t> pixels;
    std::iota(pixels.begin(), pixels.end(), part * block_size);
    const std::size_t count = std::min<std::size_t>(greatest.size() - pixels[0], block_size);
    RobustMeanLanes robust;
    robust_means(film, std::span(pixels).first(count), robust);
    for (std::size_t i = 0; i < count; ++i)
      greatest[pixels[i]] = greatest_error(film, pixels[i], robust.mean[i], errors);
  });
  return greatest;
}

// One more sample as bright as what made the error e brings sqrt(e) times the level to the mean of
// as many samples as the pixel has, and this share of the level to that of those wanted.
std::uint64_t wanted_samples(const Film& film, std::size_t i, double greatest) {
  constexpr double share = 0.25;
  constexpr double most = 1e15;
  return static_cast<std::uint64_t>(std::min(film.samples(i) * std::sqrt(greatest) / share, most));
}

}  // namespace

std::vector<DoubtfulPixel> doubtful_pixels(const Film& film, const PixelErrors& errors) {
  constexpr double rare = 1;           // below, the pixel's own samples tell
  constexpr double share = 1.0 / 256;  // of all pixels' errors: less does not matter
  std::vector<DoubtfulPixel> doubtful;
  if (errors.is_black()) return doubtful;
  const std::vector<double> greatest = greatest_errors(film, errors);
  const double sum = std::accumulate(errors.errors.begin(), errors.errors.end(), 0.0);
  for (std::size_t i = 0; i < greatest.size(); ++i)
    if (greatest[i] > std::max(rare, share * sum))
      doubtful.push_back({i, wanted_samples(film, i, greatest[i])});
  std::stable_sort(doubtful.begin(), doubtful.end(),
                   [&](const DoubtfulPixel& a, const DoubtfulPixel& b) {
                     return greatest[a.index] > greatest[b.index];
                   });
  return doubtful;
}

}  // namespace candela
