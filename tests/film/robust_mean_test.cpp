#include "renderer/film/robust_mean.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Unit_RobustMean, OfTwoReplicatesIsTheMean) {
  const Film film = film_of(2, 2, [](std::mt19937_64& random, int, int) { return normal(random); });
  EXPECT_EQ(robust_mean(film, 0).mean, film.mean(0));
  EXPECT_EQ(robust_mean(film, 0).rare, Vec3d(0.0));
  EXPECT_GT(robust_mean(film, 0).variance.x, 0);
}

}  // namespace
}  // namespace candela
