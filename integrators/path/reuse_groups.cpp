#include "integrators/path/reuse_groups.h"

#include <iterator>

#include "renderer/sampling/hash.h"

namespace candela {

std::vector<PixelPlace> pixels_to_deal(const PixelRect& square) {
  constexpr int side = 4;  // of a cell: of each colour as many as there are groups
  const auto place = [](const PixelPlace& pixel) {
    return hash_pixel(0, static_cast<std::uint32_t>(pixel.x), static_cast<std::uint32_t>(pixel.y));
  };
  std::vector<PixelPlace> pixels;
  for (int y0 = square.y0; y0 < square.y1; y0 += side)
    for (int x0 = square.x0; x0 < square.x1; x0 += side) {
      const std::size_t first = pixels.size();
      for (int y = y0; y < std::min(y0 + side, square.y1); ++y)
        for (int x = x0; x < std::min(x0 + side, square.x1); ++x) pixels.push_back({x, y});
      std::ranges::sort(std::span(pixels).subspan(first), {}, place);
    }
  return pixels;
}

void SampleDealer::add(const PixelPlace& pixel, const SampleRange& range) {
  for (std::uint32_t i = range.first; i < range.end; ++i)
    samples_[pixel.colour()].push_back({pixel, i});
}

std::vector<SampleColumn> SampleDealer::deal() const {
  std::vector<SampleColumn> columns;
  for (const std::vector<PixelSample>& samples : samples_) {
    std::vector<std::vector<PixelSample>> of_replicates(replicates_);
    for (const PixelSample& sample : samples)
      of_replicates[sample.index % replicates_].push_back(sample);
    for (const std::vector<PixelSample>& of_replicate : of_replicates)
      std::ranges::move(dealt(of_replicate), std::back_inserter(columns));
  }
  return columns;
}

}  // namespace candela
