#include "renderer/film/neighbour_level.h"

#include <gtest/gtest.h>

#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

constexpr int size = 16;

// Left half dark, right half bright, noise of 10 %.
Film halves() {
  return test::synthetic_film(size, 16, 4, 3, [](std::mt19937_64& random, int x, int) {
    return (x < 8 ? 1 : 10) * std::uniform_real_distribution<double>(0.8, 1.2)(random);
  });
}

TEST(Unit_NeighbourLevel, DoesNotReachOverAnEdge) {
  const Film film = halves();
  const auto levels = neighbour_levels(film, film.crop());
  ASSERT_EQ(levels.size(), static_cast<std::size_t>(size * size));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double truth = x < 8 ? 1 : 10;
      EXPECT_NEAR(levels[film.index(x, y)].mean.x, truth, 0.1 * truth) << x << "," << y;
    }
}

TEST(Unit_NeighbourLevel, LeavesThePixelItselfOut) {
  Film film = halves();
  const auto before = neighbour_levels(film, film.crop())[film.index(4, 4)];
  FilmSample sample;
  sample.radiance = Rgb(2);
  for (int s = 0; s < 16; ++s) film.add(4, 4, sample);
  const auto after = neighbour_levels(film, film.crop())[film.index(4, 4)];
  EXPECT_NEAR(before.mean.x, after.mean.x, 0.05);  // only who looks alike may change
  EXPECT_EQ(before.wide_mean, after.wide_mean);
}

TEST(Unit_NeighbourLevel, KnowsNoiseFromStructure) {
  const Film noisy = test::synthetic_film(size, 16, 4, 3, [](std::mt19937_64& random, int, int) {
    return std::exponential_distribution<double>(1)(random);
  });
  const Film structured = test::synthetic_film(size, 16, 4, 3, [](std::mt19937_64&, int x, int y) {
    return 1 + 0.25 * ((x * 7 + y * 5) % 3);
  });
  double of_noise = 0;
  double own = 0;
  double own_of_structured = 0;
  double of_structure = 0;
  for (const NeighbourLevel& level : neighbour_levels(noisy, noisy.crop())) {
    of_noise += level.structure.x / (size * size);
    own += level.own_variance.x / (size * size);
  }
  for (const NeighbourLevel& level : neighbour_levels(structured, structured.crop())) {
    own_of_structured += level.own_variance.x;
    of_structure += level.structure.x;
  }
  EXPECT_LT(of_noise, own / 4);
  EXPECT_NEAR(own_of_structured, 0, 1e-12);
  EXPECT_GT(of_structure / (size * size), own);
}

// Blocks cut the picture, and change nothing.
TEST(Unit_NeighbourLevel, IsTheSameInEveryBlock) {
  const Film film = halves();
  const auto whole = neighbour_levels(film, film.crop());
  const PixelRect block{5, 3, 11, 9};
  const auto part = neighbour_levels(film, block);
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x)
      EXPECT_EQ(part[static_cast<std::size_t>((y - 3) * 6 + (x - 5))].mean.x,
                whole[film.index(x, y)].mean.x);
}

TEST(Unit_NeighbourLevel, OfASinglePixelIsItsOwn) {
  const Film film =
      test::synthetic_film(1, 8, 4, 1, [](std::mt19937_64&, int, int) { return 3.0; });
  EXPECT_EQ(neighbour_levels(film, film.crop())[0].mean.x, 3);
}

}  // namespace
}  // namespace candela
