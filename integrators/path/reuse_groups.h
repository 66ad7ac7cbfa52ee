// Which samples share what their paths find (path_reuse.h): those in the same lane of the blocks of
// a group.
//
// They are of pixels all over an aligned square, about one of each of its cells, which one a hash
// decides: noise that repeated itself at a fixed distance would be seen as a weave. Where pixels
// get samples by their noise (renderer/film/sample_density.h), as many share as elsewhere, whatever
// their indices. All that share are of one replicate, so that replicates stay independent of each
// other, and of pixels of one colour on a chessboard, by which adaptive sampling's pilot decides
// for those of the other.
#pragma once

#include <span>
#include <vector>

#include "integrators/tile_pass.h"

namespace candela {

inline constexpr int reuse_square = 16;              // pixels, each way
inline constexpr std::size_t reuse_group_size = 16;  // blocks, of as many lanes

// Whether the pixels of a pass share.
[[nodiscard]] inline bool reuses_paths(const TilePass& pass) {
  return pass.plan.reuses_paths && pass.observer == nullptr;
}

struct PixelPlace {
  int x = 0, y = 0;
  [[nodiscard]] std::size_t colour() const { return chessboard_colour(x, y); }
};
struct PixelSample {
  PixelPlace pixel;
  std::uint32_t index = 0;  // of the pixel's samples
};

// Every so many of the cards that were dealt, which it refers to.
template <class T>
class Hand {
 public:
  Hand(std::span<const T> cards, std::size_t first, std::size_t hands)
      : first_(&cards[first]), step_(hands), size_((cards.size() - first + hands - 1) / hands) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return first_[i * step_]; }

 private:
  const T* first_;
  std::size_t step_;
  std::size_t size_;
};

// In turn to the fewest hands of reuse_group_size at most, which are added to others.
template <class T>
inline void deal(std::span<const T> cards, std::vector<Hand<T>>& hands) {
  const std::size_t count = (cards.size() + reuse_group_size - 1) / reuse_group_size;
  for (std::size_t i = 0; i < count; ++i) hands.emplace_back(cards, i, count);
}

// The pixels of a square, cell by cell, those of each cell in an order that a hash decides: so
// dealt all hands have pixels from all over the square.
[[nodiscard]] std::vector<PixelPlace> pixels_to_deal(const PixelRect& square);

// Samples that share.
using SampleColumn = Hand<PixelSample>;

// Of a square's pixels, which may have different numbers of samples.
class SampleDealer {
 public:
  explicit SampleDealer(std::uint32_t replicates)
      : replicates_(replicates), samples_(2 * replicates_) {}

  // In the order of pixels_to_deal().
  void add(const PixelPlace& pixel, const SampleRange& range) {
    std::vector<PixelSample>* const of_replicates = &samples_[pixel.colour() * replicates_];
    for (std::uint32_t i = range.first; i < range.end; ++i)
      of_replicates[i % replicates_].push_back({pixel, i});
  }
  // Calls visit(columns) for each group, with a column for each lane.
  template <class Visit>
  void for_each_group(const Visit& visit) const {
    std::vector<SampleColumn> columns;
    for (const std::vector<PixelSample>& samples : samples_) deal(std::span(samples), columns);
    std::span<const SampleColumn> left = columns;
    for (; left.size() > reuse_group_size; left = left.subspan(reuse_group_size))
      visit(left.first(reuse_group_size));
    if (!left.empty()) visit(left);
  }
  void clear() {
    for (std::vector<PixelSample>& samples : samples_) samples.clear();
  }

 private:
  std::size_t replicates_;
  std::vector<std::vector<PixelSample>> samples_;  // by colour, then by replicate
};

}  // namespace candela
