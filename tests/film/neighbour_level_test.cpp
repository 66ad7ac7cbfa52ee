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

// Of nine times nine, without the one in the middle, and of those that there are at the edge.
TEST(Unit_NeighbourLevel, TheWideMeanIsThatOfAllNearBy) {
  const Film film = test::synthetic_film(size, 8, 2, 5, [](std::mt19937_64& random, int, int) {
    return std::exponential_distribution<double>(1)(random);
  });
  const auto levels = neighbour_levels(film, film.crop());
  for (const auto& [x, y] : {std::pair{7, 8}, {0, 0}, {15, 3}, {2, 15}}) {
    Vec3d sum(0.0);
    int count = 0;
    for (int at_y = std::max(y - 4, 0); at_y <= std::min(y + 4, size - 1); ++at_y)
      for (int at_x = std::max(x - 4, 0); at_x <= std::min(x + 4, size - 1); ++at_x) {
        if (at_x == x && at_y == y) continue;
        sum += film.mean(film.index(at_x, at_y));
        ++count;
      }
    const Vec3d expected = sum / static_cast<double>(count);
    EXPECT_NEAR(levels[film.index(x, y)].wide_mean.x, expected.x, 1e-12) << x << "," << y;
  }
}

NeighbourLevel mean_level(const Film& film) {
  NeighbourLevel mean;
  for (const NeighbourLevel& level : neighbour_levels(film, film.crop())) {
    mean.structure += level.structure / static_cast<double>(size * size);
    mean.own_variance += level.own_variance / static_cast<double>(size * size);
  }
  return mean;
}

TEST(Unit_NeighbourLevel, KnowsNoiseFromStructure) {
  const auto exponential = [](std::mt19937_64& random) {
    return std::exponential_distribution<double>(1)(random);
  };
  const auto pattern = [](int x, int y) { return 0.25 * ((x * 7 + y * 5) % 3); };
  const auto film_of = [](const auto& value) {
    return test::synthetic_film(size, 16, 4, 3, value);
  };
  const NeighbourLevel noise =
      mean_level(film_of([&](std::mt19937_64& random, int, int) { return exponential(random); }));
  const NeighbourLevel structure =
      mean_level(film_of([&](std::mt19937_64&, int x, int y) { return 1 + pattern(x, y); }));
  const NeighbourLevel both = mean_level(film_of(
      [&](std::mt19937_64& random, int x, int y) { return exponential(random) + pattern(x, y); }));
  constexpr double of_pattern = 0.25 * 0.25 * 2 / 3;
  EXPECT_LT(noise.structure.x, noise.own_variance.x / 4);
  EXPECT_NEAR(structure.own_variance.x, 0, 1e-12);
  EXPECT_GT(both.structure.x, noise.structure.x + of_pattern / 4);
  EXPECT_LT(both.structure.x, of_pattern * 1.25);
}

// Blocks cut the picture, and change nothing.
TEST(Unit_NeighbourLevel, IsTheSameInEveryBlock) {
  Film film = halves();
  FilmSample rare;  // light of one replicate alone, in and around the block
  rare.radiance = Rgb(1e3f, 5e2f, 2e2f);
  for (const auto& [x, y] : {std::pair{4, 5}, {8, 6}, {12, 10}}) film.add(x, y, rare);
  const auto whole = neighbour_levels(film, film.crop());
  const PixelRect block{5, 3, 11, 9};
  const auto part = neighbour_levels(film, block);
  const auto members = [](const NeighbourLevel& l) {
    return std::vector{l.mean,         l.noise, l.structure, l.wide_mean,
                       l.own_variance, l.rare,  l.rare_noise};
  };
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x) {
      const NeighbourLevel& level = part[static_cast<std::size_t>((y - 3) * 6 + (x - 5))];
      EXPECT_EQ(members(level), members(whole[film.index(x, y)])) << x << "," << y;
      EXPECT_GT(level.rare.y, 0);
    }
}

TEST(Unit_NeighbourLevel, OfASinglePixelIsItsOwn) {
  const Film film =
      test::synthetic_film(1, 8, 4, 1, [](std::mt19937_64&, int, int) { return 3.0; });
  EXPECT_EQ(neighbour_levels(film, film.crop())[0].mean.x, 3);
}

}  // namespace
}  // namespace candela
