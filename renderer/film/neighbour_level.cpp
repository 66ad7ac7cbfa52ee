#include "renderer/film/neighbour_level.h"

#include <algorithm>
#include <span>

#include "renderer/film/alike_sums.h"
#include "renderer/film/robust_mean.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

constexpr int margin = alike_margin;  // near by, too: sum_near_by()
constexpr int rows_at_once = 4;       // whose sums stay in the nearest cache

double grey(const Vec3d& v) {
  return sum_of_components(v) / 3;
}

Vec3d of_pixel(const Planes& planes, std::size_t i) {
  return {planes[0][i], planes[1][i], planes[2][i]};
}

// The block and a margin around it; beyond the picture's edge its last pixels are repeated, and do
// not count.
class Surroundings {
 public:
  Surroundings(const Film& film, const PixelRect& block)
      : width_(block.width() + 2 * margin), height_(block.height() + 2 * margin) {
    resize();
    const PixelRect& crop = film.crop();
    std::vector<std::size_t> pixels;  // of the film, by place
    pixels.reserve(greys.counts.size());
    for (int y = block.y0 - margin; y < block.y1 + margin; ++y)
      for (int x = block.x0 - margin; x < block.x1 + margin; ++x) {
        greys.counts[pixels.size()] = crop.contains(x, y) ? 1 : 0;
        pixels.push_back(
            film.index(std::clamp(x, crop.x0, crop.x1 - 1), std::clamp(y, crop.y0, crop.y1 - 1)));
      }
    for (std::size_t first = 0; first < pixels.size(); first += block_size)
      fill(first, film, std::span(pixels).subspan(first));
    even_out();
  }

  [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(width_); }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * width() + static_cast<std::size_t>(x);
  }
  [[nodiscard]] Vec3d mean(std::size_t i) const {
    return {channels[0].means[i], channels[1].means[i], channels[2].means[i]};
  }
  // Those of 3x3 pixels together, since one's is a guess.
  [[nodiscard]] Vec3d variance(std::size_t i) const {
    return {channels[0].variances[i], channels[1].variances[i], channels[2].variances[i]};
  }

  GreyPixels greys;  // with variances of 3x3 pixels together
  std::array<ChannelPixels, 3> channels;
  Planes own_variances;  // of the means
  Planes rare;

 private:
  void resize() {
    const std::size_t count = width() * static_cast<std::size_t>(height_);
    greys.width = width();
    greys.levels.resize(count);
    greys.counts.resize(count);
    for (std::size_t c = 0; c < 3; ++c) {
      channels[c].means.resize(count);
      own_variances[c].resize(count);
      rare[c].resize(count);
    }
  }

  // The places from the first on, up to sixteen.
  void fill(std::size_t first, const Film& film, std::span<const std::size_t> pixels) {
    const std::size_t count = std::min<std::size_t>(pixels.size(), block_size);
    RobustMeanLanes robust;
    robust_means(film, pixels.first(count), robust);
    for (std::size_t i = 0; i < count; ++i) set(first + i, robust[i]);
  }
  void set(std::size_t to, const RobustMean& robust) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto channel = static_cast<int>(c);
      channels[c].means[to] = robust.mean[channel];
      own_variances[c][to] = robust.variance[channel];
      rare[c][to] = robust.rare[channel];
    }
    greys.levels[to] = grey(robust.mean);
  }

  void even_out() {
    greys.variances = mean_of_nine(variance_in_phase(own_variances), width());
    for (std::size_t c = 0; c < 3; ++c) {
      channels[c].variances = mean_of_nine(own_variances[c], width());
      channels[c].squares = product(channels[c].means, channels[c].means);
      for (std::size_t i = 0; i < channels[c].squares.size(); ++i)
        channels[c].squares[i] -= channels[c].variances[i];
    }
  }

  int width_;
  int height_;
};

// Over all near by.
struct Wide {
  Vec3d mean{0.0};
  Vec3d rare{0.0};
  Vec3d rare_noise{0.0};
};

class WideSums {
 public:
  explicit WideSums(const Surroundings& s) : counts_(sum_near_by(s.greys.counts, s.width())) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Plane rare = product(s.greys.counts, s.rare[c]);
      means_[c] = sum_near_by(product(s.greys.counts, s.channels[c].means), s.width());
      rare_[c] = sum_near_by(rare, s.width());
      rare_squares_[c] = sum_near_by(product(rare, rare), s.width());
    }
  }

  // `own`: where there is nobody else, in a picture of one pixel.
  [[nodiscard]] Wide around(std::size_t i, const Vec3d& own) const {
    if (!(counts_[i] > 0)) return {own, Vec3d(0.0), Vec3d(0.0)};
    const Vec3d rare = of_pixel(rare_, i) / counts_[i];
    const Vec3d rare_variance =
        max(of_pixel(rare_squares_, i) / counts_[i] - rare * rare, Vec3d(0.0));
    return {of_pixel(means_, i) / counts_[i], rare, rare_variance / counts_[i]};
  }

 private:
  Plane counts_;
  Planes means_;
  Planes rare_;
  Planes rare_squares_;
};

// Where less than one neighbour looks alike, in sum, the pixel's own mean, `own`, is as far from
// theirs as their levels are apart: far beyond noise. `at`: the pixel's place in the sums.
NeighbourLevel level_of(const AlikeSums& sums, std::size_t at, const Wide& wide, const Vec3d& own) {
  NeighbourLevel level;
  level.wide_mean = wide.mean;
  level.rare = wide.rare;
  level.rare_noise = wide.rare_noise;
  constexpr double nobody = 1e-6;
  constexpr double company = 0.25;
  const double weight = sums.weights[at];
  const bool is_alone = !(weight > nobody);
  level.company = std::min(weight / company, 1.0);
  level.mean = is_alone ? wide.mean : of_pixel(sums.means, at) / weight;
  const Vec3d apart = own - level.mean;
  level.structure = std::max(1 - weight, 0.0) * apart * apart;
  if (is_alone) return level;
  level.noise = of_pixel(sums.noises, at) / (weight * weight);
  level.structure =
      max(level.structure, of_pixel(sums.squares, at) / weight - level.mean * level.mean);
  return level;
}

// Of a pixel's mean, rare light included: it is in the samples by which the mean is judged.
// But one that met such light is not for that reason unsure of everything: a limit.
Vec3d own_variance(const Surroundings& s, std::size_t at, const Vec3d& variance_of_mean) {
  constexpr double most = 6;  // times the variance without it; between 4 and 6 nothing changes
  const Vec3d of_nine = s.variance(at);
  const Vec3d robust = max(of_nine, of_pixel(s.own_variances, at));
  return min(most * robust, max(of_nine, variance_of_mean));
}

}  // namespace

std::vector<NeighbourLevel> neighbour_levels(const Film& film, const PixelRect& block) {
  const Surroundings surroundings(film, block);
  const WideSums wide(surroundings);
  std::vector<NeighbourLevel> levels;
  levels.reserve(static_cast<std::size_t>(block.width()) *
                 static_cast<std::size_t>(block.height()));
  for (int y0 = 0; y0 < block.height(); y0 += rows_at_once) {
    const int y1 = std::min(y0 + rows_at_once, block.height());
    const std::size_t first = surroundings.at(margin, margin + y0);
    const std::size_t end = surroundings.at(margin + block.width(), margin + y1 - 1);
    const AlikeSums sums =
        alike_sums(surroundings.greys, surroundings.channels, first, end - first);
    for (int y = y0; y < y1; ++y)
      for (int x = 0; x < block.width(); ++x) {
        const std::size_t at = surroundings.at(margin + x, margin + y);
        const Vec3d own = surroundings.mean(at);
        levels.push_back(level_of(sums, at - first, wide.around(at, own), own));
        levels.back().own_variance = own_variance(
            surroundings, at, variance_of_mean(film, film.index(block.x0 + x, block.y0 + y)));
      }
  }
  return levels;
}

}  // namespace candela
