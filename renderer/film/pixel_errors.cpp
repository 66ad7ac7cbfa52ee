#include "renderer/film/pixel_errors.h"

#include <algorithm>
#include <numeric>

#include "renderer/base/parallel.h"
#include "renderer/film/neighbour_level.h"
#include "renderer/film/pair_errors.h"
#include "renderer/film/tiles.h"
#include "renderer/film/variance.h"
#include "renderer/image/relmse.h"

namespace candela {
namespace {

// Up to sixteen pixels side by side, with samples of as many replicates.
class PixelRun {
 public:
  explicit PixelRun(const Film& film) : film_(film), sums_(film.replicates()) {}

  [[nodiscard]] bool takes(std::size_t i) const {
    return size_ == 0 || (size_ < block_size && used_replicates(film_, i) == replicates_);
  }
  void add(std::size_t i, const NeighbourLevel& level) {
    if (size_ == 0) replicates_ = used_replicates(film_, i);
    const SamplesByReplicate counts = film_.samples_by_replicate(i);
    SampleSum whole;
    for (std::uint32_t r = 0; r < replicates_; ++r) {
      const SampleSum sum{film_.replicate_sum(i, r), static_cast<double>(counts.of(r))};
      sums_[r].set(size_, sum);
      whole.add(sum);
    }
    whole_.set(size_, whole);
    levels_.set(size_, level);
    pixels_[size_++] = i;
  }

  // Over pairs of neighbours in the ring of the replicates, one or two steps apart: all pairs of up
  // to five replicates, and not too many of more.
  void end(double epsilon, std::vector<double>& errors) {
    Lanes<double> sums{};
    std::uint32_t pairs = 0;
    for (std::uint32_t step = 1; step <= 2 && 2 * step <= replicates_; ++step) {
      const std::uint32_t count = 2 * step == replicates_ ? step : replicates_;  // no pair twice
      for (std::uint32_t a = 0; a < count; ++a)
        add_errors_of_pair(levels_, whole_, sums_[a], sums_[(a + step) % replicates_], epsilon,
                           sums);
      pairs += count;
    }
    for (std::size_t i = 0; i < size_; ++i) errors[pixels_[i]] = sums[i] / pairs;
    size_ = 0;
  }

 private:
  const Film& film_;
  std::vector<SampleSumLanes> sums_;  // by replicate
  SampleSumLanes whole_;
  LevelLanes levels_;
  Lanes<std::size_t> pixels_{};
  std::size_t size_ = 0;
  std::uint32_t replicates_ = 0;
};

void estimate_block(const Film& film, const PixelRect& block, PixelErrors& result) {
  const std::vector<NeighbourLevel> levels = neighbour_levels(film, block);
  PixelRun run(film);
  std::size_t next = 0;
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x) {
      const std::size_t i = film.index(x, y);
      if (!run.takes(i)) run.end(result.epsilon, result.errors);
      run.add(i, levels[next++]);
    }
  run.end(result.epsilon, result.errors);
}

double mean_radiance(const Film& film) {
  const auto width = static_cast<std::size_t>(film.crop().width());
  std::vector<double> rows(static_cast<std::size_t>(film.crop().height()));
  parallel_for(rows.size(), [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) rows[y] += sum_of_components(film.mean(y * width + x));
  });
  const double sum = std::accumulate(rows.begin(), rows.end(), 0.0);
  return sum / (3.0 * static_cast<double>(film.pixel_count()));
}

}  // namespace

std::optional<PixelErrors> estimate_pixel_errors(const Film& film) {
  const std::uint32_t replicates = std::min(film.min_samples(), film.replicates());
  if (replicates < 2) return {};
  PixelErrors result;
  result.errors.resize(film.pixel_count());
  result.epsilon = relmse_epsilon(mean_radiance(film));
  if (result.is_black()) return result;
  constexpr int side = 64;
  const std::vector<PixelRect> blocks = tiles_of(film.crop(), side);
  parallel_for(blocks.size(), [&](std::size_t b) { estimate_block(film, blocks[b], result); });
  return result;
}

double error_at_level(const Film& film, std::size_t i, const PixelLevel& level, double epsilon) {
  return error_beside(level, variance_of_mean(film, i), epsilon);
}

}  // namespace candela
