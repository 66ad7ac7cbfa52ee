// Films filled with numbers of which mean and variance are known.
#pragma once

#include <optional>
#include <random>

#include "renderer/film/film.h"

namespace candela::test {

[[nodiscard]] inline Rgb radiance_of(double grey) {
  return Rgb(static_cast<float>(grey));
}
[[nodiscard]] inline Rgb radiance_of(const Rgb& colour) {
  return colour;
}

// `draw(random, x, y)`: the radiance of one sample of a pixel, grey or a colour. `balance`: the
// film's.
template <class Draw>
[[nodiscard]] Film synthetic_film(int size, int samples, std::uint32_t replicates,
                                  std::uint64_t seed, Draw draw,
                                  const std::optional<Mat3d>& balance = {}) {
  Film film(size, size, {0, 0, size, size}, 0, replicates, balance);
  std::mt19937_64 random(seed);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int s = 0; s < samples; ++s) {
        FilmSample sample;
        sample.radiance = radiance_of(draw(random, x, y));
        film.add(x, y, sample);
      }
  return film;
}

// relMSE as renderer/image/compare.h has it, of a square grey film to `truth(x, y)`.
template <class Truth>
[[nodiscard]] double relmse_to(Truth truth, const Film& film) {
  const int size = film.full_width();
  double mean = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) mean += truth(x, y) / (size * size);
  double sum = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double r = truth(x, y);
      const double error = film.mean(film.index(x, y)).x - r;
      sum += error * error / (r * r + 1e-2 * mean * mean);
    }
  return sum / (size * size);
}

}  // namespace candela::test
