// Samples go where a pilot is wrong for what they cost there, and all of them go somewhere.
#include "renderer/film/sample_density.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "renderer/sampling/even_counts.h"
#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

constexpr int size = 64;

// 1 with a standard deviation of `noise(x)` a sample; each costs cost(x).
template <class Noise, class Cost>
Film pilot_of(const Noise& noise, const Cost& cost) {
  Film film = test::synthetic_film(size, 16, 4, 5, [&](std::mt19937_64& random, int x, int) {
    return 1 + noise(x) * (std::uniform_real_distribution<double>(-1, 1)(random));
  });
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) film.add_cost(x, y, 16 * cost(x));
  return film;
}

// Over a column, away from others by more than the smoothing reaches.
double column_mean(const SampleDensity& density, int x) {
  double sum = 0;
  for (int y = 0; y < size; ++y) sum += static_cast<double>(density.at(x, y)) / size;
  return sum;
}

TEST(Unit_SampleDensity, FollowsTheErrorOfHalves) {
  const SampleDensity density(
      pilot_of([](int x) { return x < size / 2 ? 0.2 : 0.6; }, [](int) { return 1u; }));
  // A tenth of all is dealt out evenly, the rest by 1 : 3 about a mean of 2.
  EXPECT_NEAR(column_mean(density, 10), 0.1 + 0.9 * 0.5, 0.05);
  EXPECT_NEAR(column_mean(density, 54), 0.1 + 0.9 * 1.5, 0.08);
}

TEST(Unit_SampleDensity, FollowsTheCostOfHalves) {
  const SampleDensity density(
      pilot_of([](int) { return 0.4; }, [](int x) { return x < size / 2 ? 4u : 1u; }));
  EXPECT_NEAR(column_mean(density, 10), 0.1 + 0.9 * 2.0 / 3, 0.06);
  EXPECT_NEAR(column_mean(density, 54), 0.1 + 0.9 * 4.0 / 3, 0.08);
}

// Of the chessboard's colours, in the 16x16 pixels from there on.
std::array<std::set<float>, 2> values_in_square(const SampleDensity& density, int x0, int y0) {
  std::array<std::set<float>, 2> values;
  for (int y = y0; y < y0 + 16; ++y)
    for (int x = x0; x < x0 + 16; ++x)
      values[static_cast<std::size_t>(x + y) % 2].insert(density.at(x, y));
  return values;
}

TEST(Unit_SampleDensity, PixelsOfASquareGetTheSameWhereTheyWantNearlyTheSame) {
  const Film pilot = pilot_of([](int x) { return x < 24 ? 0.2 : 0.6; },
                              [](int) { return 1u; });  // within a square
  const SampleDensity own(pilot);
  const SampleDensity evened(pilot, 16);
  EXPECT_NEAR(column_mean(evened, 10), column_mean(own, 10), 0.03);
  EXPECT_NEAR(column_mean(evened, 54), column_mean(own, 54), 0.03);
  const SampleDensity::Scales scales = evened.scales(100);
  for (int y = 0; y < size; y += 16)
    for (int x = 0; x < size; x += 16)
      for (std::size_t colour = 0; colour < 2; ++colour) {
        const std::size_t values = values_in_square(evened, x, y)[colour].size();
        EXPECT_GT(values_in_square(own, x, y)[colour].size(), 64u);
        if (x == 16) {
          EXPECT_GT(values, 64u);
          continue;
        }
        EXPECT_EQ(values, 1u);
        for (int i = static_cast<int>(colour); i < 16; i += 2)
          EXPECT_EQ(evened.samples(x + i, y, scales),
                    evened.samples(x + static_cast<int>(colour), y, scales));
      }
}

std::uint32_t samples_of(const SampleDensity& density, int x, int y, std::uint32_t mean) {
  return density.samples(x, y, density.scales(mean));
}

double mean_of_samples(const SampleDensity& density, std::uint32_t mean) {
  const SampleDensity::Scales scales = density.scales(mean);
  double sum = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) sum += density.samples(x, y, scales);
  return sum / (size * size);
}

TEST(Unit_SampleDensity, WithoutNoiseAllGetTheSame) {
  const SampleDensity density(pilot_of([](int) { return 0.0; }, [](int) { return 1u; }));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      EXPECT_EQ(density.at(x, y), 1);
      EXPECT_EQ(samples_of(density, x, y, 128), 128u);
    }
}

// Where that many are not well spread: more or less, evenly over the picture.
TEST(Unit_SampleDensity, WithoutNoiseTheMeanIsKept) {
  const SampleDensity density(pilot_of([](int) { return 0.0; }, [](int) { return 1u; }));
  for (const std::uint32_t mean : {20u, 100u, 112u, 124u})
    EXPECT_NEAR(mean_of_samples(density, mean), mean, 0.02 * mean);
  const SampleDensity::Scales scales = density.scales(112);
  for (int y = 0; y < size; y += 8)
    for (int x = 0; x < size; x += 8) {
      double sum = 0;
      for (int i = 0; i < 64; ++i) sum += density.samples(x + i % 8, y + i / 8, scales);
      EXPECT_NEAR(sum / 64, 112, 5);
    }
}

TEST(Unit_SampleDensity, OneFireflyDoesNotTakeAll) {
  Film film = pilot_of([](int) { return 0.1; }, [](int) { return 1u; });
  FilmSample firefly;
  firefly.radiance = Rgb(1e6f);
  film.add(30, 30, firefly);
  const SampleDensity density(film);
  EXPECT_LE(density.at(30, 30), 11);
  EXPECT_GT(density.at(5, 5), 0.09f);
}

// How many times the error would be what it is with the same samples everywhere, were all pixels
// alike.
double loss(const SampleDensity& density) {
  double sum = 0;
  double inverse_sum = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      sum += static_cast<double>(density.at(x, y));
      inverse_sum += 1 / static_cast<double>(density.at(x, y));
    }
  return sum * inverse_sum / (size * size * size * size);
}

// Flashes of a hundredfold brightness in some samples on a ground of this brightness, alike
// everywhere.
Film flashing_pilot(double share_of_samples, double ground) {
  std::uniform_real_distribution<double> between(0, 1);
  return test::synthetic_film(size, 16, 4, 5, [&](std::mt19937_64& random, int, int) {
    return between(random) < share_of_samples ? 100 : ground * (0.5 + between(random));
  });
}

// Where a pixel has met a flash others near by are as likely to.
TEST(Unit_SampleDensity, FlashesDoNotDrawSamples) {
  EXPECT_LT(loss(SampleDensity(flashing_pilot(0.002, 1))), 1.2);
}

// Where a quarter of the pixels has met one, the pilot knows by three quarters only.
TEST(Unit_SampleDensity, TheMoreHaveMetFlashesTheLessIsSaidByThem) {
  EXPECT_LT(loss(SampleDensity(flashing_pilot(0.02, 1))), 1.055);
}

TEST(Unit_SampleDensity, WhereFlashesAreAllTheLightAllGetNearlyTheSame) {
  EXPECT_LT(loss(SampleDensity(flashing_pilot(0.002, 0))), 1.02);
}

// Counts join from pass to pass: of each replicate evenly spread points, and never fewer.
TEST(Unit_SampleDensity, CountsRiseWithTheMeanAndFillTheReplicates) {
  const SampleDensity density(
      pilot_of([](int x) { return 0.01 + 0.02 * x; }, [](int) { return 1u; }));
  for (int x = 0; x < size; ++x) {
    std::uint32_t last = 16;
    EXPECT_EQ(samples_of(density, x, 7, 16), last);
    for (std::uint32_t mean = 17; mean < 400; ++mean) {
      const std::uint32_t count = samples_of(density, x, 7, mean);
      ASSERT_GE(count, last);
      ASSERT_EQ(count % 4, 0u);
      ASSERT_EQ(count / 4, even_count(nearest_level(count / 4)));
      last = count;
    }
  }
}

// Of a mean that is the most there can be a pixel may want more than fits.
TEST(Unit_SampleDensity, CountsDoNotWrapAround) {
  const SampleDensity density(
      pilot_of([](int x) { return x == 30 ? 1 : 0.01; }, [](int) { return 1u; }));
  std::uint32_t last = 0;
  for (std::uint32_t mean = 1u << 27; mean <= 1u << 30; mean += 1u << 27) {
    const std::uint32_t count = samples_of(density, 30, 7, mean);
    EXPECT_GE(count, last);
    last = count;
  }
  EXPECT_GT(last, 1u << 30);
}

TEST(Unit_SampleDensity, HandsOutWhatThereIs) {
  const SampleDensity density(
      pilot_of([](int x) { return 0.01 + 0.02 * x; }, [](int) { return 1u; }));
  for (const std::uint32_t mean : {48u, 112u, 1000u, 1u << 28})
    EXPECT_NEAR(mean_of_samples(density, mean), mean, 0.02 * mean);
}

// What pixels keep of the pilot though they need less is taken from the others.
TEST(Unit_SampleDensity, HandsOutNoMoreWhereThePilotIsMuch) {
  const SampleDensity density(
      pilot_of([](int x) { return x < size / 2 ? 0.05 : 1.0; }, [](int) { return 1u; }));
  for (const std::uint32_t mean : {24u, 40u}) {
    EXPECT_EQ(samples_of(density, 5, 5, mean), 16u);
    EXPECT_NEAR(mean_of_samples(density, mean), mean, 0.02 * mean);
  }
}

// The part of a pilot from (0, 0) on, moved to `rect` of a larger picture.
Film moved(const Film& pilot, const PixelRect& rect) {
  Film part(200, 100, rect, 0, pilot.replicates());
  for (int y = 0; y < rect.height(); ++y)
    for (int x = 0; x < rect.width(); ++x)
      part.take_pixel(part.index(rect.x0 + x, rect.y0 + y), pilot, pilot.index(x, y));
  return part;
}

// Bit by bit, whatever colour the first pixel has.
TEST(Unit_SampleDensity, OfACropIsThatOfSuchAPicture) {
  const Film pilot =
      pilot_of([](int x) { return 0.01 * x; }, [](int x) { return x < 9 ? 2u : 1u; });
  for (const int width : {2, 31, 32}) {
    const SampleDensity density(moved(pilot, {0, 0, width, 17}));
    for (const auto& [x0, y0] : {std::pair{6, 8}, std::pair{7, 8}, std::pair{7, 9}}) {
      const SampleDensity other(moved(pilot, {x0, y0, x0 + width, y0 + 17}));
      for (int y = 0; y < 17; ++y)
        for (int x = 0; x < width; ++x) {
          ASSERT_EQ(other.at(x0 + x, y0 + y), density.at(x, y));
          ASSERT_EQ(samples_of(other, x0 + x, y0 + y, 100), samples_of(density, x, y, 100));
        }
    }
  }
}

// Or the picture would be biased: pixels that a pilot finds dark by chance would stay dark.
TEST(Unit_SampleDensity, NoPixelHasASayInItsOwnCount) {
  for (const int width : {size, 63, 2, 3}) {
    const auto pilot_with = [&](float firefly, int x, int y) {
      const Film film =
          pilot_of([](int at) { return 0.01 * at; }, [](int at) { return at < 9 ? 2u : 1u; });
      Film part(width, size, {0, 0, width, size}, 0, 4);
      for (int row = 0; row < size; ++row)
        for (int column = 0; column < width; ++column)
          part.take_pixel(part.index(column, row), film, film.index(column, row));
      FilmSample sample;
      sample.radiance = Rgb(firefly);
      part.add(x, y, sample);
      return part;
    };
    const SampleDensity quiet(pilot_with(0, width - 1, 30));
    const SampleDensity loud(pilot_with(50, width - 1, 30));
    const SampleDensity::Scales quiet_scales = quiet.scales(100);
    const SampleDensity::Scales loud_scales = loud.scales(100);
    std::size_t others = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < width; ++x) {
        const bool has_its_colour = (x + y) % 2 == (width - 1 + 30) % 2;
        const bool is_same = quiet.at(x, y) == loud.at(x, y) &&
                             quiet.samples(x, y, quiet_scales) == loud.samples(x, y, loud_scales);
        if (has_its_colour) {
          ASSERT_TRUE(is_same) << width << ": " << x << ' ' << y;
        } else if (!is_same) {
          ++others;
        }
      }
    EXPECT_GT(others, 0u) << width;
  }
}

}  // namespace
}  // namespace candela
