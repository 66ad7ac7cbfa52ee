// Which pixels of synthetic films do not tell how bright they are.
#include "renderer/film/doubtful_pixels.h"

#include <gtest/gtest.h>

#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

constexpr int size = 16;
constexpr int samples = 32;
constexpr std::uint64_t plenty = 1u << 30;

double uniform(std::mt19937_64& random) {
  return std::uniform_real_distribution<>(.5, 1.5)(random);
}

// `flashes(x, y)`: the light of the first sample of a pixel beside that of all.
template <class Flashes>
Film film_with(Flashes flashes) {
  int count = 0;
  return test::synthetic_film(size, samples, 4, 1, [&](std::mt19937_64& random, int x, int y) {
    return uniform(random) + (count++ % samples == 0 ? flashes(x, y) : 0.0);
  });
}

std::vector<DoubtfulPixel> doubtful(const Film& film, std::uint64_t budget) {
  return doubtful_pixels(film, *estimate_pixel_errors(film), budget);
}

TEST(Unit_DoubtfulPixels, AreThoseWithLightThatOneReplicateMet) {
  const Film film = film_with([](int x, int y) {
    if (x == 3 && y == 5) return 800.0;
    return x == 9 && y == 2 ? 80.0 : 0.0;
  });
  const std::vector<DoubtfulPixel> found = doubtful(film, plenty);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].index, film.index(3, 5));
  EXPECT_EQ(found[1].index, film.index(9, 2));
}

// Enough samples that one more such flash would bring less than the pixel's level.
TEST(Unit_DoubtfulPixels, WantMoreSamplesWhereTheLightIsRarer) {
  const auto wanted = [](double flash) {
    return doubtful(film_with([=](int x, int y) { return x + y == 0 ? flash : 0.0; }), plenty)
        .at(0)
        .samples;
  };
  EXPECT_GT(wanted(200), 200u);
  EXPECT_NEAR(wanted(2000) / static_cast<double>(wanted(200)), 10, 0.5);
}

TEST(Unit_DoubtfulPixels, KeepToTheBudget) {
  const Film film = film_with([](int x, int) { return x == 7 ? 200.0 : 0.0; });
  const std::vector<DoubtfulPixel> all = doubtful(film, plenty);
  ASSERT_EQ(all.size(), static_cast<std::size_t>(size));
  const std::uint64_t budget = all[0].samples + all[1].samples / 2;
  const std::vector<DoubtfulPixel> few = doubtful(film, budget);
  ASSERT_EQ(few.size(), 2u);
  EXPECT_EQ(few[0].index, all[0].index);
  EXPECT_EQ(few[0].samples + few[1].samples, budget);
  EXPECT_TRUE(doubtful(film, 0).empty());
}

TEST(Unit_DoubtfulPixels, AreNoneWhereNoiseIsEvenOrThereIsNoLight) {
  EXPECT_TRUE(doubtful(film_with([](int, int) { return 0.0; }), plenty).empty());
  const auto black = [](std::mt19937_64&, int, int) { return 0.0; };
  EXPECT_TRUE(doubtful(test::synthetic_film(size, samples, 4, 1, black), plenty).empty());
}

}  // namespace
}  // namespace candela
