// The stated error of films of which the truth is known.
#include "renderer/film/error_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/image/compare.h"
#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

// A picture with edges, dark parts and fine structure, from .02 to 2.
double truth_at(int x, int y) {
  const double shade = x < 20 ? 1.0 : 0.1;
  const double waves = 1 + 0.8 * std::sin(0.7 * x) * std::cos(0.4 * y);
  return (x / 8 + y / 8) % 2 == 0 ? shade * waves : 0.6 * shade;
}

constexpr int size = 64;

struct Noise {
  const char* name;
  double (*draw)(std::mt19937_64&);  // of mean 1
};

// From even to strongly skewed: a light that one sample in ten finds; flashes that one in 500 does.
const Noise noises[] = {
    {"uniform", [](std::mt19937_64& r) { return std::uniform_real_distribution<>(0, 2)(r); }},
    {"exponential", [](std::mt19937_64& r) { return std::exponential_distribution<>(1)(r); }},
    {"rare",
     [](std::mt19937_64& r) { return std::uniform_real_distribution<>()(r) < .1 ? 10. : 0.; }},
    {"flashes", [](std::mt19937_64& r) {
       return std::uniform_real_distribution<>(.6, 1)(r) +
              (std::uniform_real_distribution<>()(r) < .002 ? 100. : 0.);
     }}};

double stated_over_true(const Noise& noise, int samples) {
  double stated = 0;
  double truth = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Film film = test::synthetic_film(
        size, samples, 4, seed,
        [&](std::mt19937_64& random, int x, int y) { return truth_at(x, y) * noise.draw(random); });
    stated += estimate_error(film)->relmse;
    truth += test::relmse_to(truth_at, film);
  }
  return stated / truth;
}

// What is promised from 16 samples on (docs/accuracy.md); the picture is a hard one, and has edges
// in every second pixel.
TEST(Statistical_ErrorEstimate, IsTheTrueErrorInTheMean) {
  for (const Noise& noise : noises)
    for (const int samples : {16, 64}) {
      const double ratio = stated_over_true(noise, samples);
      EXPECT_GT(ratio, 0.8) << noise.name << ", " << samples << " samples";
      EXPECT_LT(ratio, 1.25) << noise.name << ", " << samples << " samples";
    }
}

// As a white balance makes them of saturated light: they are as bright as they are far from 0.
TEST(Statistical_ErrorEstimate, ChannelsBelowZeroAreHeldAgainstTheirSize) {
  const Vec3d shares(-0.4, 1, 0.2);
  Mat3d balance(0.0);
  for (int c = 0; c < 3; ++c) balance[c][c] = shares[c];
  Image truth(size, size, {"R", "G", "B"});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int c = 0; c < 3; ++c)
        truth.pixel(x, y)[c] = static_cast<float>(truth_at(x, y) * shares[c]);
  for (const std::uint32_t replicates : {2u, 3u, 4u, 8u})
    for (const Noise& noise : {noises[0], noises[1]}) {
      double stated = 0;
      double error = 0;
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Film film = test::synthetic_film(
            size, 48, replicates, seed,
            [&](std::mt19937_64& random, int x, int y) {
              return truth_at(x, y) * noise.draw(random);
            },
            balance);
        stated += estimate_error(film)->relmse;
        error += compare_images(film.to_image(false), truth)->relmse;
      }
      EXPECT_NEAR(stated / error, 1, 0.15) << noise.name << ", " << replicates << " replicates";
    }
}

// Three dark columns beside five bright ones, and a flash in one of 1000 samples anywhere: a pixel
// that has met one is no brighter for it than its dark neighbours.
TEST(Statistical_ErrorEstimate, FlashesDoNotMakeDarkPixelsLookBright) {
  constexpr double flash = 50;
  constexpr double probability = 0.001;
  const auto even = [](int x) { return x % 8 < 3 ? 0.1 : 2.0; };
  Image truth(size, size, {"R", "G", "B"});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      std::fill_n(truth.pixel(x, y), 3, static_cast<float>(even(x) + flash * probability));
  for (const int samples : {16, 64}) {
    double stated = 0;
    double error = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Film film =
          test::synthetic_film(size, samples, 4, seed, [&](std::mt19937_64& random, int x, int) {
            std::uniform_real_distribution<> uniform(0, 1);
            return even(x) * (0.8 + 0.4 * uniform(random)) +
                   (uniform(random) < probability ? flash : 0);
          });
      stated += estimate_error(film)->relmse;
      error += compare_images(film.to_image(false), truth)->relmse;
    }
    EXPECT_NEAR(stated / error, 1, 0.1) << samples << " samples";
  }
}

// No neighbour says anything of such a pixel's level: a sun in a sky, a glint, a lamp far away.
TEST(Statistical_ErrorEstimate, PixelsLikeNoOthersAreHeldAgainstThemselves) {
  for (const double bright : {1.0, 5.0, 50.0})
    for (const Noise& noise : {noises[0], noises[1]}) {
      const auto level = [&](int x, int y) { return x % 16 == 8 && y % 16 == 8 ? bright : 0.05; };
      double stated = 0;
      double truth = 0;
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Film film =
            test::synthetic_film(size, 16, 4, seed, [&](std::mt19937_64& random, int x, int y) {
              return level(x, y) * noise.draw(random);
            });
        stated += estimate_error(film)->relmse;
        truth += test::relmse_to(level, film);
      }
      EXPECT_GT(stated / truth, 0.8) << noise.name << ", " << bright;
      EXPECT_LT(stated / truth, 1.25) << noise.name << ", " << bright;
    }
}

// Likewise where the neighbours are the bright ones, and have no noise: edges of lamps, in the
// tails of a filter.
TEST(Statistical_ErrorEstimate, DarkPixelsAmongBrightOnesAreHeldAgainstThemselves) {
  for (const double dark : {0.2, 0.05, 0.01})
    for (const Noise& noise : {noises[0], noises[1]}) {
      const auto is_dark = [](int x, int y) { return x % 8 == 4 && y % 8 == 4; };
      const auto level = [&](int x, int y) { return is_dark(x, y) ? dark : 1.0; };
      double stated = 0;
      double truth = 0;
      for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        const Film film =
            test::synthetic_film(size, 16, 4, seed, [&](std::mt19937_64& random, int x, int y) {
              return is_dark(x, y) ? dark * noise.draw(random) : 1.0;
            });
        stated += estimate_error(film)->relmse;
        truth += test::relmse_to(level, film);
      }
      EXPECT_GT(stated / truth, 0.8) << noise.name << ", " << dark;
      EXPECT_LT(stated / truth, 1.25) << noise.name << ", " << dark;
    }
}

// Two colours that are one grey: each channel is dark where the other one is bright.
TEST(Statistical_ErrorEstimate, DarkChannelsOfSaturatedColoursAreHeldAgainstThemselves) {
  for (const double dark : {0.1, 0.02}) {
    const auto level = [&](int x, int y, int c) {
      return c == 2 ? 0.2 : (x / 4 + y / 4) % 2 == c ? 1.0 : dark;
    };
    Image truth(size, size, {"R", "G", "B"});
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        for (int c = 0; c < 3; ++c) truth.pixel(x, y)[c] = static_cast<float>(level(x, y, c));
    double stated = 0;
    double error = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
      const Film film = test::synthetic_film(
          size, 64, 4, seed, [&](std::mt19937_64& random, int x, int y) -> Rgb {
            std::uniform_real_distribution<> unit(0, 1);
            Vec3d radiance;
            for (int c = 0; c < 3; ++c) {
              const double mean = level(x, y, c);
              // In the dark rare light of the other colour, as in the tails of a filter.
              radiance[c] = mean < 1 ? (unit(random) < mean ? 1 : 0) : 1;
            }
            return Rgb(radiance);
          });
      stated += estimate_error(film)->relmse;
      error += compare_images(film.to_image(false), truth)->relmse;
    }
    EXPECT_NEAR(stated / error, 1, 0.3) << dark;
  }
}

// Of so few pixels that chance has most of it, and of many.
TEST(Statistical_ErrorEstimate, ItsIntervalHoldsTheTrueError) {
  for (const int side : {8, size}) {
    int held = 0;
    constexpr int runs = 200;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      const Film film =
          test::synthetic_film(side, 32, 4, seed, [](std::mt19937_64& random, int x, int y) {
            return truth_at(x, y) * noises[0].draw(random);
          });
      const ErrorEstimate estimate = *estimate_error(film);
      const double truth = test::relmse_to(truth_at, film);
      if (estimate.interval95.low <= truth && truth <= estimate.interval95.high) ++held;
    }
    EXPECT_GE(held, 178) << side;  // 95 % of 200 less four standard deviations
    if (side == 8) {
      EXPECT_LT(held, runs) << "no interval of 95 % holds always";
    }
  }
}

// Sixteen pixels of error 1, four replicates: Student's t of 48 degrees of freedom is 2.01063, the
// deviation of the sum sqrt(16 * 2 * 4 / 5), and levels may be off by a tenth together.
TEST(Unit_ErrorEstimate, ItsIntervalIsByStudentsT) {
  const Film film =
      test::synthetic_film(4, 8, 4, 1, [](std::mt19937_64&, int, int) { return 1.0; });
  const ErrorEstimate estimate = estimate_error(film, {std::vector<double>(16, 1.0), 1e-2});
  EXPECT_EQ(estimate.relmse, 1);
  const double reach = std::hypot(2.01063 * std::sqrt(25.6), 1.6) / 16;
  EXPECT_NEAR(estimate.interval95.low, 1 - reach, 1e-5);
  EXPECT_NEAR(estimate.interval95.high, 1 + reach, 1e-5);
}

// The same where four pixels each are wrong together: of 12 degrees it is 2.17881.
TEST(Unit_ErrorEstimate, ItsIntervalIsWiderWherePixelsAreWrongTogether) {
  const Film film =
      test::synthetic_film(4, 8, 4, 1, [](std::mt19937_64&, int, int) { return 1.0; });
  const ErrorEstimate estimate = estimate_error(film, {std::vector<double>(16, 1.0), 1e-2}, 4);
  EXPECT_EQ(estimate.relmse, 1);
  const double reach = std::hypot(2.17881 * std::sqrt(4 * 25.6), 1.6) / 16;
  EXPECT_NEAR(estimate.interval95.high, 1 + reach, 1e-4);
}

TEST(Unit_ErrorEstimate, NeedsTwoReplicatesInEveryPixel) {
  const auto one = [](std::mt19937_64&, int, int) { return 1.0; };
  EXPECT_FALSE(estimate_error(test::synthetic_film(4, 1, 4, 1, one)));
  EXPECT_FALSE(estimate_error(test::synthetic_film(4, 8, 1, 1, one)));
  EXPECT_TRUE(estimate_error(test::synthetic_film(4, 2, 4, 1, one)));
}

TEST(Unit_ErrorEstimate, OfAPictureWithoutNoiseIsZero) {
  const auto picture = [](std::mt19937_64&, int x, int y) { return truth_at(x, y); };
  const ErrorEstimate estimate = *estimate_error(test::synthetic_film(16, 8, 4, 1, picture));
  EXPECT_NEAR(estimate.relmse, 0, 1e-20);
  const auto black = [](std::mt19937_64&, int, int) { return 0.0; };
  EXPECT_EQ(estimate_error(test::synthetic_film(16, 8, 4, 1, black))->relmse, 0);
}

// As relMSE itself: invariant when the picture is scaled.
TEST(Unit_ErrorEstimate, DoesNotDependOnTheUnitOfLight) {
  const auto estimate = [](double unit) {
    return *estimate_error(
        test::synthetic_film(16, 8, 4, 1, [unit](std::mt19937_64& random, int x, int y) {
          return unit * truth_at(x, y) * noises[1].draw(random);
        }));
  };
  EXPECT_DOUBLE_EQ(estimate(1).relmse, estimate(0x1p-40).relmse);
  EXPECT_DOUBLE_EQ(estimate(1).interval95.high, estimate(0x1p30).interval95.high);
}

}  // namespace
}  // namespace candela
