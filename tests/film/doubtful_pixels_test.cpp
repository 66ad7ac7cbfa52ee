// Which pixels of synthetic films do not tell how bright they are.
#include "renderer/film/doubtful_pixels.h"

#include <gtest/gtest.h>

#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

constexpr int size = 16;
constexpr int samples = 32;

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

std::vector<DoubtfulPixel> doubtful(const Film& film) {
  return doubtful_pixels(film, *estimate_pixel_errors(film));
}

TEST(Unit_DoubtfulPixels, AreThoseWithLightThatOneReplicateMet) {
  const Film film = film_with([](int x, int y) {
    if (x == 3 && y == 5) return 800.0;
    return x == 9 && y == 2 ? 80.0 : 0.0;
  });
  const std::vector<DoubtfulPixel> found = doubtful(film);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].index, film.index(3, 5));
  EXPECT_EQ(found[1].index, film.index(9, 2));
}

// Enough samples that one more such flash would bring less than the pixel's level.
TEST(Unit_DoubtfulPixels, WantMoreSamplesWhereTheLightIsRarer) {
  const auto wanted = [](double flash) {
    return doubtful(film_with([=](int x, int y) { return x + y == 0 ? flash : 0.0; })).at(0).wanted;
  };
  EXPECT_GT(wanted(200), 200u);
  EXPECT_NEAR(wanted(2000) / static_cast<double>(wanted(200)), 10, 0.5);
}

// Below the pixel's own level its samples tell; below 1/256 of all pixels' errors it does not
// matter.
TEST(Unit_DoubtfulPixels, AreOnlyThoseThatMatter) {
  const auto count = [](double flash) {
    return doubtful(film_with([=](int x, int y) { return x == 3 && y == 5 ? flash : 0.0; })).size();
  };
  EXPECT_EQ(count(26), 0u);
  EXPECT_EQ(count(40), 1u);
  const auto beside = [](double flash) {
    return doubtful(film_with([=](int x, int y) {
             if (x == 3 && y == 5) return flash;
             return x == 12 && y == 12 ? 3200.0 : 0.0;
           }))
        .size();
  };
  EXPECT_EQ(beside(150), 1u);
  EXPECT_EQ(beside(260), 2u);
}

TEST(Unit_DoubtfulPixels, AreNoneWhereNoiseIsEvenOrThereIsNoLight) {
  EXPECT_TRUE(doubtful(film_with([](int, int) { return 0.0; })).empty());
  const auto black = [](std::mt19937_64&, int, int) { return 0.0; };
  EXPECT_TRUE(doubtful(test::synthetic_film(size, samples, 4, 1, black)).empty());
}

}  // namespace
}  // namespace candela
