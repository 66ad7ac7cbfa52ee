#include "renderer/film/sample_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "renderer/base/parallel.h"
#include "renderer/film/heavy_tails.h"
#include "renderer/film/tiles.h"
#include "renderer/film/variance.h"
#include "renderer/image/relmse.h"
#include "renderer/sampling/even_counts.h"

namespace candela {
namespace {

int first_of_row(int y, const PixelRect& rect, std::size_t colour) {
  return chessboard_colour(rect.x0, y) == colour ? rect.x0 : rect.x0 + 1;
}

// How many of the colour are in the rows above row y.
std::size_t pixels_before(int y, const PixelRect& rect, std::size_t colour) {
  const std::size_t all = rect.index(rect.x0, y);
  return (all + (chessboard_colour(rect.x0, rect.y0) == colour ? 1 : 0)) / 2;
}

// Calls f with the index of each pixel of the colour, in rows from the top.
template <class F>
void for_each_pixel(const Film& film, std::size_t colour, const F& f) {
  const PixelRect& rect = film.crop();
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = first_of_row(y, rect, colour); x < rect.x1; x += 2) f(film.index(x, y));
}

// How much a pixel has to say about another one: by |dx| and |dy|.
constexpr int reach = 5;
constexpr auto weights_of_places = [] {
  std::array<std::array<double, reach + 1>, reach + 1> weights{};
  for (int dy = 0; dy <= reach; ++dy)
    for (int dx = 0; dx <= reach; ++dx)
      weights[static_cast<std::size_t>(dy)][static_cast<std::size_t>(dx)] =
          1.0 / (1 + 2 * (dx * dx + dy * dy));
  return weights;
}();

// What a pixel's own samples say.
struct Sign {
  double root_of_error = 0;  // of its part of relMSE
  double cost = 0;
};

double mean_radiance(const Film& film, std::size_t colour) {
  double sum = 0;
  std::size_t count = 0;
  for_each_pixel(film, colour, [&](std::size_t i) {
    sum += sum_of_components(film.mean(i)) / 3;
    ++count;
  });
  return sum / static_cast<double>(count);
}

// Of the pixels of one colour; those of the other stay empty. A pixel that met rare light says too
// little of its error, by its own high mean: by all that such light brings it would decide for
// those that are near by, where samples would seldom meet any.
std::vector<Sign> signs_of(std::size_t colour, const Film& film) {
  const double epsilon = relmse_epsilon(mean_radiance(film, colour));
  std::vector<Sign> signs(film.pixel_count());
  for_each_pixel(film, colour, [&](std::size_t i) {
    signs[i].cost = film.cost(i);
    if (!(epsilon > 0)) return;
    const Vec3d level = film.mean(i);
    const Vec3d errors = variance_of_mean(film, i) / (level * level + epsilon);
    signs[i].root_of_error = std::sqrt(sum_of_components(errors) / 3);
  });
  return signs;
}

// Neyman's allocation for a pixel of the other colour: the weighted mean of the roots near by over
// the root of the mean cost.
double value_at(int x, int y, const std::vector<Sign>& signs, const Film& pilot) {
  const PixelRect& rect = pilot.crop();
  const int last_x = std::min(x + reach, rect.x1 - 1);
  const int last_y = std::min(y + reach, rect.y1 - 1);
  Sign sum;
  double weights = 0;
  for (int at_y = std::max(y - reach, rect.y0); at_y <= last_y; ++at_y) {
    const auto& of_row = weights_of_places[static_cast<std::size_t>(std::abs(at_y - y))];
    int at_x = std::max(x - reach, rect.x0);
    if (chessboard_colour(at_x, at_y) == chessboard_colour(x, y)) ++at_x;
    for (; at_x <= last_x; at_x += 2) {
      const double weight = of_row[static_cast<std::size_t>(std::abs(at_x - x))];
      const Sign& sign = signs[pilot.index(at_x, at_y)];
      sum.root_of_error += weight * sign.root_of_error;
      sum.cost += weight * sign.cost;
      weights += weight;
    }
  }
  return sum.root_of_error / weights / std::sqrt(std::max(sum.cost / weights, 1.0));
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
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

// The share of the samples that all pixels get alike, by what pixels of one colour say: the larger
// the more of them have their light from samples so rare that a pilot meets them by chance.
double share_for_all(std::size_t colour, const Film& film) {
  std::size_t lit = 0;
  std::size_t dominated = 0;
  for_each_pixel(film, colour, [&](std::size_t i) {
    if (!(max_component(film.mean(i)) > 0)) return;
    ++lit;
    if (is_dominated(film, i)) ++dominated;
  });
  if (lit == 0) return 1;
  const double rare = static_cast<double>(dominated) / static_cast<double>(lit);
  constexpr double least = 0.1;
  return least + (1 - least) * rare;
}

// What the pixels of the other colour say that those of `colour` should get, in rows from the top,
// relative to a mean of 1.
std::vector<double> density_of(std::size_t colour, const Film& pilot) {
  const std::vector<Sign> signs = signs_of(1 - colour, pilot);
  const PixelRect& rect = pilot.crop();
  std::vector<double> values(pixels_before(rect.y1, rect, colour));
  parallel_for(static_cast<std::size_t>(rect.height()), [&](std::size_t row) {
    const int y = rect.y0 + static_cast<int>(row);
    std::size_t next = pixels_before(y, rect, colour);
    for (int x = first_of_row(y, rect, colour); x < rect.x1; x += 2)
      values[next++] = value_at(x, y, signs, pilot);
  });
  limit_fireflies(values);
  const double alike = share_for_all(1 - colour, pilot);
  const double mean = mean_of(values);
  for (double& value : values) value = mean > 0 ? alike + (1 - alike) * value / mean : 1.0;
  return values;
}

// In [-1/2, 1/2), about as often each in every part of a picture: fractions of multiples of the
// plastic number's first two inverse powers.
double evenly_spread(int x, int y) {
  const double turns = 0.7548776662466927 * x + 0.5698402909980532 * y;
  return turns - std::floor(turns) - 0.5;
}

}  // namespace

SampleDensity::SampleDensity(const Film& pilot, int side)
    : rect_(pilot.crop()),
      side_(side),
      sequences_(pilot.sequences()),
      pilot_samples_(pilot.samples(0)),
      values_(pilot.pixel_count()),
      wish_of_pixel_(pilot.pixel_count()) {
  for (std::size_t colour = 0; colour < wishes_.size(); ++colour) {
    const std::vector<double> values = density_of(colour, pilot);
    std::size_t next = 0;
    for_each_pixel(pilot, colour,
                   [&](std::size_t i) { values_[i] = static_cast<float>(values[next++]); });
  }
  if (side_ > 1) even_out_squares();
  for (int y = rect_.y0; y < rect_.y1; ++y)
    for (int x = rect_.x0; x < rect_.x1; ++x) {
      wish_of_pixel_[index(x, y)] = wish_at(x, y);
      wishes_[chessboard_colour(x, y)].push_back(wish_of_pixel_[index(x, y)]);
    }
  for (Wishes& wishes : wishes_) std::sort(wishes.begin(), wishes.end());
}

void SampleDensity::even_out_squares() {
  for (const PixelRect& square : tiles_of(rect_, side_))
    for (std::size_t colour = 0; colour < wishes_.size(); ++colour) even_out(square, colour);
}

// The error of the same number for all over that of the best numbers is that of the mean square
// over the square of the mean.
void SampleDensity::even_out(const PixelRect& square, std::size_t colour) {
  constexpr double most = 1.1;
  const auto for_each_value = [&](const auto& visit) {
    for (int y = square.y0; y < square.y1; ++y)
      for (int x = first_of_row(y, square, colour); x < square.x1; x += 2)
        visit(values_[index(x, y)]);
  };
  double count = 0;
  double sum = 0;
  double sum_of_squares = 0;
  for_each_value([&](double value) {
    ++count;
    sum += value;
    sum_of_squares += value * value;
  });
  if (sum_of_squares * count > most * sum * sum) return;
  for_each_value(
      [&](float& value) { value = static_cast<float>(std::sqrt(sum_of_squares / count)); });
}

// The value, and up to 5 % more or less: where many are alike not all of them turn to the next
// level at the same mean.
float SampleDensity::wish_at(int x, int y) const {
  constexpr double octaves = 0.125;
  const double turn = evenly_spread(x / side_ - rect_.x0 / side_, y / side_ - rect_.y0 / side_);
  return static_cast<float>(static_cast<double>(at(x, y)) * std::exp2(octaves * turn));
}

std::uint32_t SampleDensity::samples(int x, int y, const Scales& scales) const {
  const double wanted =
      scales[chessboard_colour(x, y)] * static_cast<double>(wish_of_pixel_[index(x, y)]);
  if (wanted <= pilot_samples_) return pilot_samples_;
  constexpr double most = 1u << 31;  // that fits
  int level = nearest_level(wanted / sequences_);
  while (sequences_ * even_count(level) > most) --level;
  return std::max(pilot_samples_, static_cast<std::uint32_t>(sequences_ * even_count(level)));
}

double SampleDensity::sum_of_samples(const Wishes& wishes, double scale) const {
  double last = pilot_samples_;
  double sum = last * static_cast<double>(wishes.size());
  for (int level = nearest_level(last / sequences_);; ++level) {
    const double samples = sequences_ * even_count(level);
    if (samples <= last) continue;
    const double first_wish = sequences_ * lower_end_of_level(level) / scale;
    const auto first = std::lower_bound(wishes.begin(), wishes.end(), first_wish);
    if (first == wishes.end()) return sum;
    sum += (samples - last) * static_cast<double>(wishes.end() - first);
    last = samples;
  }
}

// The nearest of scales that are 1/64 octave apart.
double SampleDensity::scale_of(const Wishes& wishes, std::uint32_t mean) const {
  if (mean <= pilot_samples_) return 0;
  const auto scale_at = [](int step) { return std::exp2(step / 64.0); };
  const double wanted = static_cast<double>(mean) * static_cast<double>(wishes.size());
  int low = 0;
  int high = 64 * 40;  // beyond all numbers of samples, be the least of wishes a tenth
  while (low < high) {
    const int middle = (low + high) / 2;
    if (sum_of_samples(wishes, scale_at(middle)) >= wanted)
      high = middle;
    else
      low = middle + 1;
  }
  const bool is_one_less_nearer = wanted - sum_of_samples(wishes, scale_at(low - 1)) <
                                  sum_of_samples(wishes, scale_at(low)) - wanted;
  return scale_at(is_one_less_nearer ? low - 1 : low);
}

SampleDensity::Scales SampleDensity::scales(std::uint32_t mean) const {
  return {scale_of(wishes_[0], mean), scale_of(wishes_[1], mean)};
}

}  // namespace candela
