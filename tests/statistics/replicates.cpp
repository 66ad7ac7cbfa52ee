#include "tests/statistics/replicates.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela::statistics {
namespace {

struct Rect {
  int x0, y0, x1, y1;
};

double mean_over(const std::vector<double>& image, int width, const Rect& rect) {
  double sum = 0;
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x) sum += image[static_cast<std::size_t>(y * width + x)];
  return sum / ((rect.x1 - rect.x0) * (rect.y1 - rect.y0));
}

Moments moments_over(const Replicates& replicates, const Rect& rect) {
  Moments moments;
  for (const auto& image : replicates.images) moments.add(mean_over(image, replicates.width, rect));
  return moments;
}

double p_value_over(const Replicates& a, const Replicates& b, const Rect& rect) {
  return welch_p_value(moments_over(a, rect), moments_over(b, rect));
}

std::vector<double> p_values(const Replicates& a, const Replicates& b, int side) {
  std::vector<double> values;
  for (int y = 0; y < a.height; y += side)
    for (int x = 0; x < a.width; x += side)
      values.push_back(
          p_value_over(a, b, {x, y, std::min(x + side, a.width), std::min(y + side, a.height)}));
  return values;
}

// Both in units of their common mean, pixel by pixel: else the edge of a lamp, which is brighter
// and noisier than all the rest, drowns it in the means over blocks and the whole. The same weights
// for both, from both alike, leave equal expectations equal.
void divide_by_common_mean(Replicates& a, Replicates& b) {
  for (std::size_t i = 0; i < a.images[0].size(); ++i) {
    double mean = 0;
    for (const Replicates* replicates : {&a, &b})
      for (const auto& image : replicates->images)
        mean += 0.5 * image[i] / static_cast<double>(replicates->images.size());
    for (Replicates* replicates : {&a, &b})
      for (auto& image : replicates->images) image[i] /= mean > 0 ? mean : 1;
  }
}

// P(X >= k) of a binomial X.
double binomial_survival(double k, double n, double p) {
  return k <= 0 ? 1 : incomplete_beta(k, n - k + 1, p);
}

}  // namespace

Agreement compare_replicates(Replicates a, Replicates b, const AgreementOptions& options) {
  divide_by_common_mean(a, b);
  const std::vector<double> pixels = p_values(a, b, 1);
  const std::vector<double> blocks = p_values(a, b, options.block);
  Agreement result;
  double least = 1;
  std::vector<std::string> shares;
  for (const double level : options.pixel_levels) {
    const auto beyond = static_cast<double>(
        std::count_if(pixels.begin(), pixels.end(), [&](double p) { return p < level; }));
    const auto count = static_cast<double>(pixels.size());
    least = std::min(least, binomial_survival(beyond, count, level));
    shares.push_back(fmt::format("{:.4f} beyond {}", beyond / count, level));
  }
  result.pixels_p_value = sidak_p_value(least, static_cast<double>(options.pixel_levels.size()));
  result.blocks_p_value = sidak_p_value(*std::min_element(blocks.begin(), blocks.end()),
                                        static_cast<double>(blocks.size()));
  const Rect whole{0, 0, a.width, a.height};
  result.whole_p_value = p_value_over(a, b, whole);
  result.whole_ratio = moments_over(a, whole).mean() / moments_over(b, whole).mean();
  const double needed = sidak_level(options.level, 3);
  result.passed =
      std::min({result.pixels_p_value, result.blocks_p_value, result.whole_p_value}) >= needed;
  result.message = fmt::format(
      "{} and {}: p-values pixels {:.3g} ({}), blocks {:.3g}, whole {:.3g}, each needs {:.3g}; "
      "ratio of the means {:.5f}",
      a.name, b.name, result.pixels_p_value, fmt::join(shares, ", "), result.blocks_p_value,
      result.whole_p_value, needed, result.whole_ratio);
  return result;
}

}  // namespace candela::statistics
