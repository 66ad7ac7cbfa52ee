#include "renderer/film/doubtful_pixels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/film/robust_mean.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

// The most that the pixel's error may be: as it is stated, or were the pixel no brighter than
// without its rare light.
double greatest_error(const Film& film, std::size_t i, const PixelErrors& errors) {
  const Vec3d variance = variance_of_mean(film, i);
  const Vec3d level = robust_mean(film, i).mean;
  return std::max(errors.errors[i],
                  sum_of_components(variance / (level * level + errors.epsilon)) / 3);
}

// One more sample as bright as what made the error e brings sqrt(e) times the level to the mean of
// as many samples as the pixel has, and this share of the level to that of those wanted.
double wanted_samples(const Film& film, std::size_t i, double greatest) {
  constexpr double share = 0.25;
  return film.samples(i) * std::sqrt(greatest) / share;
}

struct Candidate {
  std::size_t index;
  double greatest;
};

std::vector<Candidate> candidates(const Film& film, const PixelErrors& errors) {
  constexpr double share = 1.0 / 256;  // of all pixels' errors: less does not matter
  constexpr double rare = 1;           // below, the pixel's own samples tell
  const double sum = std::accumulate(errors.errors.begin(), errors.errors.end(), 0.0);
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    const double greatest = greatest_error(film, i, errors);
    if (greatest > std::max(rare, share * sum)) found.push_back({i, greatest});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.greatest > b.greatest; });
  return found;
}

}  // namespace

std::vector<DoubtfulPixel> doubtful_pixels(const Film& film, const PixelErrors& errors,
                                           std::uint64_t budget) {
  std::vector<DoubtfulPixel> doubtful;
  if (!(errors.epsilon > 0)) return doubtful;  // a black picture
  for (const Candidate& candidate : candidates(film, errors)) {
    if (budget == 0) break;
    const double wanted = wanted_samples(film, candidate.index, candidate.greatest);
    const auto samples = static_cast<std::uint32_t>(
        std::min(wanted, static_cast<double>(std::min<std::uint64_t>(budget, 1u << 31))));
    doubtful.push_back({candidate.index, samples});
    budget -= samples;
  }
  return doubtful;
}

}  // namespace candela
