#include "renderer/film/neighbour_level.h"

#include <algorithm>

#include "renderer/film/robust_mean.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

constexpr int search_radius = 2;  // where neighbours that look alike are looked for
constexpr int patch_radius = 1;   // what is compared of them
constexpr int wide_radius = 4;    // those near by
constexpr int margin = std::max(search_radius + 2 * patch_radius, wide_radius);

double grey(const Vec3d& v) {
  return sum_of_components(v) / 3;
}

// The block and a margin around it; beyond the picture's edge its last pixels are repeated, and do
// not count.
class Surroundings {
 public:
  Surroundings(const Film& film, const PixelRect& block)
      : width_(block.width() + 2 * margin), height_(block.height() + 2 * margin) {
    const PixelRect& crop = film.crop();
    resize();
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const int film_x = block.x0 + x - margin;
        const int film_y = block.y0 + y - margin;
        const int inside_x = std::clamp(film_x, crop.x0, crop.x1 - 1);
        const int inside_y = std::clamp(film_y, crop.y0, crop.y1 - 1);
        fill(at(x, y), film, film.index(inside_x, inside_y));
        counts[at(x, y)] = film_x == inside_x && film_y == inside_y ? 1 : 0;
      }
    even_out();
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  std::vector<Vec3d> means;
  std::vector<Vec3d> own_variances;  // of the means
  std::vector<Vec3d> variances;      // those of 3x3 pixels together, since one's is a guess
  std::vector<double> greys;
  std::vector<double> grey_variances;  // likewise
  std::vector<double> counts;          // 1 within the picture, 0 beyond
  std::vector<Vec3d> rare;

 private:
  void resize() {
    const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    means.resize(count);
    own_variances.resize(count);
    variances.resize(count);
    greys.resize(count);
    grey_variances.resize(count);
    counts.resize(count);
    rare.resize(count);
  }

  void fill(std::size_t to, const Film& film, std::size_t i) {
    const RobustMean robust = robust_mean(film, i);
    means[to] = robust.mean;
    own_variances[to] = variances[to] = robust.variance;
    rare[to] = robust.rare;
    greys[to] = grey(means[to]);
    // Noise is mostly in phase over the channels: a pessimist's guess of the grey's.
    const Vec3d deviations(std::sqrt(variances[to].x), std::sqrt(variances[to].y),
                           std::sqrt(variances[to].z));
    grey_variances[to] = grey(deviations) * grey(deviations);
  }

  void even_out() {
    const std::vector<double> raw_greys = grey_variances;
    for (int y = 1; y + 1 < height_; ++y)
      for (int x = 1; x + 1 < width_; ++x) {
        Vec3d sum(0.0);
        double grey_sum = 0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            sum += own_variances[at(x + dx, y + dy)];
            grey_sum += raw_greys[at(x + dx, y + dy)];
          }
        variances[at(x, y)] = sum / 9.0;
        grey_variances[at(x, y)] = grey_sum / 9;
      }
  }

  int width_;
  int height_;
};

// How much two pixels differ beyond what their noise explains, over it [Rousselle12, eq. 4]:
// about 0 where they have the same expectation.
double distance(const Surroundings& s, std::size_t a, std::size_t b) {
  const double difference = s.greys[a] - s.greys[b];
  const double variance = s.grey_variances[a] + s.grey_variances[b];
  const double chance = s.grey_variances[a] + std::min(s.grey_variances[a], s.grey_variances[b]);
  const double excess = difference * difference - chance;
  return variance > 0 ? excess / variance : (difference == 0 ? 0 : 1e10);
}

// The weights of the neighbours at (dx, dy), for all pixels of the block.
class ShiftedWeights {
 public:
  explicit ShiftedWeights(const Surroundings& s)
      : s_(s), distances_(s.means.size()), row_sums_(s.means.size()) {}

  void shift(int dx, int dy) {
    constexpr int edge = margin - patch_radius;
    for (int y = edge; y < s_.height() - edge; ++y) {
      for (int x = edge; x < s_.width() - edge; ++x)
        distances_[s_.at(x, y)] = distance(s_, s_.at(x, y), s_.at(x + dx, y + dy));
      for (int x = margin; x < s_.width() - margin; ++x) {
        const std::size_t at = s_.at(x, y);
        row_sums_[at] = distances_[at - 1] + distances_[at] + distances_[at + 1];
      }
    }
  }
  // From the mean distance of the 3x3 pixels around the two.
  [[nodiscard]] double weight(int x, int y) const {
    const double sum =
        row_sums_[s_.at(x, y - 1)] + row_sums_[s_.at(x, y)] + row_sums_[s_.at(x, y + 1)];
    const double mean = std::max(sum / 9, 0.0);
    return 1 / ((1 + mean) * (1 + mean));
  }

 private:
  const Surroundings& s_;
  std::vector<double> distances_;
  std::vector<double> row_sums_;
};
static_assert(patch_radius == 1, "ShiftedWeights adds up three by three");

// Weighted sums over the neighbours of a pixel.
struct Sums {
  double weight = 0;
  Vec3d mean{0.0};
  Vec3d square{0.0};
  Vec3d variance{0.0};
  Vec3d squared_weight_variance{0.0};

  void add(double w, const Vec3d& m, const Vec3d& v) {
    weight += w;
    mean += w * m;
    square += w * m * m;
    variance += w * v;
    squared_weight_variance += w * w * v;
  }
};

std::vector<Sums> sums_of_alike(const Surroundings& s, const PixelRect& block) {
  std::vector<Sums> sums(static_cast<std::size_t>(block.width()) *
                         static_cast<std::size_t>(block.height()));
  ShiftedWeights weights(s);
  for (int dy = -search_radius; dy <= search_radius; ++dy)
    for (int dx = -search_radius; dx <= search_radius; ++dx) {
      if (dx == 0 && dy == 0) continue;
      weights.shift(dx, dy);
      std::size_t i = 0;
      for (int y = margin; y < margin + block.height(); ++y)
        for (int x = margin; x < margin + block.width(); ++x, ++i) {
          const std::size_t neighbour = s.at(x + dx, y + dy);
          sums[i].add(weights.weight(x, y) * s.counts[neighbour], s.means[neighbour],
                      s.variances[neighbour]);
        }
    }
  return sums;
}

// Over all near by.
struct Wide {
  Vec3d mean{0.0};
  Vec3d rare{0.0};
  Vec3d rare_noise{0.0};
};

struct WideSum {
  double count = 0;
  Vec3d mean{0.0};
  Vec3d rare{0.0};
  Vec3d rare_square{0.0};

  void add(const WideSum& more) {
    count += more.count;
    mean += more.mean;
    rare += more.rare;
    rare_square += more.rare_square;
  }
};

// Sums over the pixels near by without the one in the middle, which nothing is subtracted for: it
// may be larger than all others together. Each row's serves those above and below.
class WideSums {
 public:
  explicit WideSums(const Surroundings& s) : s_(s), pixels_(s.means.size()), rows_(s.means.size()) {
    for (std::size_t i = 0; i < pixels_.size(); ++i)
      pixels_[i] = {s.counts[i], s.counts[i] * s.means[i], s.counts[i] * s.rare[i],
                    s.counts[i] * s.rare[i] * s.rare[i]};
    for (int y = 0; y < s.height(); ++y)
      for (int x = wide_radius; x < s.width() - wide_radius; ++x) {
        rows_[s.at(x, y)] = beside(x, y);
        rows_[s.at(x, y)].add(pixels_[s.at(x, y)]);
      }
  }

  [[nodiscard]] WideSum around(int x, int y) const {
    WideSum sum = beside(x, y);
    for (int dy = 1; dy <= wide_radius; ++dy) {
      sum.add(rows_[s_.at(x, y - dy)]);
      sum.add(rows_[s_.at(x, y + dy)]);
    }
    return sum;
  }

 private:
  // In the same row.
  [[nodiscard]] WideSum beside(int x, int y) const {
    WideSum sum;
    for (int dx = 1; dx <= wide_radius; ++dx) {
      sum.add(pixels_[s_.at(x - dx, y)]);
      sum.add(pixels_[s_.at(x + dx, y)]);
    }
    return sum;
  }

  const Surroundings& s_;
  std::vector<WideSum> pixels_;
  std::vector<WideSum> rows_;
};

// `own`: where there is nobody else, in a picture of one pixel.
Wide wide_of(const WideSum& sum, const Vec3d& own) {
  if (!(sum.count > 0)) return {own, Vec3d(0.0), Vec3d(0.0)};
  const Vec3d rare = sum.rare / sum.count;
  const Vec3d rare_variance = max(sum.rare_square / sum.count - rare * rare, Vec3d(0.0));
  return {sum.mean / sum.count, max(rare, Vec3d(0.0)), rare_variance / sum.count};
}

// Where less than one neighbour looks alike, in sum, the pixel's own mean, `own`, is as far from
// theirs as their levels are apart: far beyond noise.
NeighbourLevel level_of(const Sums& sums, const Wide& wide, const Vec3d& own) {
  NeighbourLevel level;
  level.wide_mean = wide.mean;
  level.rare = wide.rare;
  level.rare_noise = wide.rare_noise;
  constexpr double nobody = 1e-6;
  const bool is_alone = !(sums.weight > nobody);
  level.mean = is_alone ? wide.mean : sums.mean / sums.weight;
  const Vec3d apart = own - level.mean;
  level.structure = std::max(1 - sums.weight, 0.0) * apart * apart;
  if (is_alone) return level;
  level.noise = sums.squared_weight_variance / (sums.weight * sums.weight);
  level.structure =
      max(level.structure, (sums.square - sums.variance) / sums.weight - level.mean * level.mean);
  return level;
}

// Of a pixel's mean, rare light included: it is in the samples by which the mean is judged.
// But one that met such light is not for that reason unsure of everything: a limit.
Vec3d own_variance(const Surroundings& s, std::size_t at, const Vec3d& variance_of_mean) {
  constexpr double most = 6;  // times the variance without it; between 4 and 6 nothing changes
  const Vec3d robust = max(s.variances[at], s.own_variances[at]);
  return min(most * robust, max(s.variances[at], variance_of_mean));
}

}  // namespace

std::vector<NeighbourLevel> neighbour_levels(const Film& film, const PixelRect& block) {
  const Surroundings surroundings(film, block);
  const WideSums wide(surroundings);
  std::vector<NeighbourLevel> levels;
  levels.reserve(static_cast<std::size_t>(block.width()) *
                 static_cast<std::size_t>(block.height()));
  for (const Sums& sums : sums_of_alike(surroundings, block)) {
    const int x = margin + static_cast<int>(levels.size()) % block.width();
    const int y = margin + static_cast<int>(levels.size()) / block.width();
    const Vec3d& own = surroundings.means[surroundings.at(x, y)];
    levels.push_back(level_of(sums, wide_of(wide.around(x, y), own), own));
    const std::size_t i = film.index(block.x0 + x - margin, block.y0 + y - margin);
    levels.back().own_variance =
        own_variance(surroundings, surroundings.at(x, y), variance_of_mean(film, i));
  }
  return levels;
}

}  // namespace candela
