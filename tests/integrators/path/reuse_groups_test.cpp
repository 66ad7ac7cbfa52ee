// Which samples share what their paths find.
#include "integrators/path/reuse_groups.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

namespace candela {
namespace {

using Sample = std::tuple<int, int, std::uint32_t>;

template <class T>
std::vector<T> cards_of(const Hand<T>& hand) {
  std::vector<T> cards;
  for (std::size_t i = 0; i < hand.size(); ++i) cards.push_back(hand[i]);
  return cards;
}

std::vector<std::vector<PixelPlace>> dealt_of_colour(std::size_t colour,
                                                     std::vector<PixelPlace> pixels) {
  std::erase_if(pixels, [&](const PixelPlace& pixel) { return pixel.colour() != colour; });
  std::vector<Hand<PixelPlace>> hands;
  deal(std::span<const PixelPlace>(pixels), hands);
  std::vector<std::vector<PixelPlace>> dealt;
  for (const Hand<PixelPlace>& hand : hands) dealt.push_back(cards_of(hand));
  return dealt;
}

TEST(Unit_ReuseGroups, EachHasAPixelOfEachCell) {
  const std::vector<PixelPlace> pixels = pixels_to_deal({16, 32, 32, 48});
  ASSERT_EQ(pixels.size(), 256u);
  std::set<std::pair<int, int>> dealt_pixels;
  for (std::size_t colour = 0; colour < 2; ++colour) {
    const auto groups = dealt_of_colour(colour, pixels);
    EXPECT_EQ(groups.size(), 8u);
    for (const auto& group : groups) {
      EXPECT_EQ(group.size(), reuse_group_size);
      std::set<std::pair<int, int>> cells;
      for (const PixelPlace& pixel : group) {
        EXPECT_EQ(pixel.colour(), colour);
        cells.emplace(pixel.x / 4, pixel.y / 4);
        dealt_pixels.emplace(pixel.x, pixel.y);
      }
      EXPECT_EQ(cells.size(), reuse_group_size);
    }
  }
  EXPECT_EQ(dealt_pixels.size(), pixels.size());
  EXPECT_EQ(dealt_pixels.begin()->first, 16);
  EXPECT_EQ(dealt_pixels.rbegin()->second, 47);
}

// Their places in the cells follow each other at random: of the 120 pairs of a group an eighth are
// at the same place.
TEST(Unit_ReuseGroups, NoPatternRepeatsItself) {
  std::size_t pairs = 0, same = 0;
  for (int square = 0; square < 64; ++square)
    for (const auto& group :
         dealt_of_colour(0, pixels_to_deal({16 * square, 0, 16 * square + 16, 16})))
      for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          ++pairs;
          if (group[i].x % 4 == group[j].x % 4 && group[i].y % 4 == group[j].y % 4) ++same;
        }
  EXPECT_EQ(pairs, 64u * 8 * 120);
  EXPECT_NEAR(static_cast<double>(same) / static_cast<double>(pairs), 0.125, 0.005);
}

TEST(Unit_ReuseGroups, SamplesThatShareAreOfOneReplicateAndColour) {
  for (const std::uint32_t replicates : {1u, 3u, 4u}) {
    SampleDealer dealer(replicates);
    std::set<Sample> left;
    std::map<std::pair<std::size_t, std::uint32_t>, std::size_t> counts;  // by colour and replicate
    for (const PixelPlace& pixel : pixels_to_deal({0, 0, 16, 13})) {
      // More on the right, none at some pixels.
      const auto first = static_cast<std::uint32_t>(pixel.y);
      const SampleRange range{first, first + static_cast<std::uint32_t>(pixel.x * pixel.x / 4)};
      dealer.add(pixel, range);
      for (std::uint32_t i = range.first; i < range.end; ++i) {
        left.emplace(pixel.x, pixel.y, i);
        ++counts[{pixel.colour(), i % replicates}];
      }
    }
    std::size_t columns_wanted = 0;
    for (const auto& [of, count] : counts) columns_wanted += (count + 15) / 16;
    std::size_t columns_dealt = 0;
    dealer.for_each_group([&](std::span<const SampleColumn> columns) {
      ASSERT_LE(columns.size(), block_size);
      columns_dealt += columns.size();
      for (const SampleColumn& column : columns) {
        EXPECT_GE(column.size(), 15u);
        EXPECT_LE(column.size(), reuse_group_size);
        std::set<std::pair<int, int>> pixels;
        for (const auto& [pixel, index] : cards_of(column)) {
          EXPECT_EQ(pixel.colour(), column[0].pixel.colour());
          EXPECT_EQ(index % replicates, column[0].index % replicates);
          EXPECT_EQ(left.erase({pixel.x, pixel.y, index}), 1u);
          pixels.emplace(pixel.x, pixel.y);
        }
        EXPECT_EQ(pixels.size(), column.size());
      }
    });
    EXPECT_TRUE(left.empty());
    EXPECT_EQ(columns_dealt, columns_wanted);
  }
}

}  // namespace
}  // namespace candela
