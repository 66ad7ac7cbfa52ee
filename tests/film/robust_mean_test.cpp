#include "renderer/film/robust_mean.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/film/synthetic_film.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

// One sample a replicate, so that the replicates are what is drawn.
template <class Value>
Film film_of(int size, int replicates, const Value& value) {
  return test::synthetic_film(size, replicates, static_cast<std::uint32_t>(replicates), 7, value);
}

double normal(std::mt19937_64& random) {
  return std::normal_distribution<double>(20, 1)(random);
}

TEST(Statistical_RobustMean, IsTheMeanOfNormalReplicates) {
  constexpr int size = 256;
  for (const int replicates : {3, 4, 8}) {
    const Film film =
        film_of(size, replicates, [](std::mt19937_64& random, int, int) { return normal(random); });
    statistics::Moments mean;
    statistics::Moments variance;
    statistics::Moments rare;
    for (std::size_t i = 0; i < film.pixel_count(); ++i) {
      const RobustMean robust = robust_mean(film, i);
      mean.add(robust.mean.x);
      variance.add(robust.variance.x);
      rare.add(robust.rare.x);
    }
    EXPECT_LT(std::abs(mean.mean() - 20), 4 * mean.standard_error()) << replicates;
    EXPECT_LT(std::abs(rare.mean()), 4 * rare.standard_error()) << replicates;
    EXPECT_NEAR(variance.mean() / mean.variance(), 1, 0.03) << replicates;
  }
}

TEST(Unit_RobustMean, LeavesOutWhatOneReplicateAloneHasMet) {
  const auto flash = [next = 0](std::mt19937_64&, int x, int) mutable {
    return next++ % 4 == 2 ? 1000.0 * x : 1.0;
  };
  const Film film = film_of(2, 4, flash);
  const std::size_t i = film.index(1, 0);
  EXPECT_EQ(robust_mean(film, i).mean, Vec3d(1.0));
  EXPECT_EQ(robust_mean(film, i).variance, Vec3d(0.0));
  EXPECT_EQ(robust_mean(film, i).rare, film.mean(i) - Vec3d(1.0));
}

RobustMean of_replicates(const std::vector<double>& values) {
  const auto count = static_cast<int>(values.size());
  return robust_mean(film_of(1, count,
                             [&, next = std::size_t{0}](std::mt19937_64&, int, int) mutable {
                               return values[next++];
                             }),
                     0);
}

// Whichever replicate is the brightest, of three and of four.
TEST(Unit_RobustMean, LeavesOutTheBrightest) {
  for (const int replicates : {3, 4})
    for (int brightest = 0; brightest < replicates; ++brightest) {
      std::vector<double> values(static_cast<std::size_t>(replicates), 2.0);
      values[static_cast<std::size_t>(brightest)] = 9;
      EXPECT_EQ(of_replicates(values).mean, Vec3d(2.0)) << brightest << " of " << replicates;
    }
}

TEST(Unit_RobustMean, LeavesOutOnlyOneOfThoseThatAreAlike) {
  EXPECT_EQ(of_replicates({3, 3, 3, 3}).mean, Vec3d(3.0));
  EXPECT_EQ(of_replicates({3, 3, 3, 3}).variance, Vec3d(0.0));
  constexpr double less = 9 - 0x1p-20;  // as a float, too
  for (const std::vector<double>& values :
       {std::vector{9.0, 9.0, 2.0, 1.0}, {2.0, 9.0, 9.0, 1.0}, {1.0, 2.0, 9.0, 9.0}}) {
    const RobustMean robust = of_replicates(values);
    const RobustMean almost = of_replicates({9.0, less, 2.0, 1.0});
    EXPECT_NEAR(robust.mean.x, almost.mean.x, 1e-5);
    EXPECT_NEAR(robust.variance.x, almost.variance.x, 1e-5);
  }
}

// Also where they have one to nine samples, which are of one to four groups.
TEST(Unit_RobustMean, OfManyAtOnceIsThatOfEach) {
  Film film(4, 4, {0, 0, 4, 4}, 0, 8);
  std::mt19937_64 random(11);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      for (int s = 0; s < (3 * x + 4 * y) % 9 + 1; ++s) {
        FilmSample sample;
        sample.radiance = Rgb(static_cast<float>(normal(random)), 1, static_cast<float>(s));
        film.add(x, y, sample);
      }
  const std::array<std::size_t, 11> pixels{15, 3, 0, 7, 8, 1, 2, 12, 10, 5, 6};
  RobustMeanLanes many;
  robust_means(film, pixels, many);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const RobustMean one = robust_mean(film, pixels[i]);
    EXPECT_EQ(many[i].mean, one.mean) << pixels[i];
    EXPECT_EQ(many[i].variance, one.variance) << pixels[i];
    EXPECT_EQ(many[i].rare, one.rare) << pixels[i];
    EXPECT_NEAR(one.mean.x + one.rare.x, film.mean(pixels[i]).x, 1e-12) << pixels[i];
  }
}

TEST(Unit_RobustMean, OfTwoReplicatesIsTheMean) {
  const Film film = film_of(2, 2, [](std::mt19937_64& random, int, int) { return normal(random); });
  EXPECT_EQ(robust_mean(film, 0).mean, film.mean(0));
  EXPECT_EQ(robust_mean(film, 0).rare, Vec3d(0.0));
  EXPECT_GT(robust_mean(film, 0).variance.x, 0);
}

}  // namespace
}  // namespace candela
