#include "renderer/film/variance.h"

#include <gtest/gtest.h>

#include "tests/film/synthetic_film.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

double exponential(std::mt19937_64& random, int, int) {
  return std::exponential_distribution<double>(1)(random);
}

Film film_of(std::initializer_list<float> greys, std::uint32_t replicates) {
  Film film(1, 1, {0, 0, 1, 1}, 0, replicates);
  for (const float grey : greys) {
    FilmSample sample;
    sample.radiance = Rgb(grey);
    film.add(0, 0, sample);
  }
  return film;
}

TEST(Unit_Variance, IsThatOfTheReplicatesMeans) {
  // Replicates 0 and 1 hold {1, 3} and {5, 9}: means 2 and 7, their mean 4.5.
  const Film film = film_of({1, 5, 3, 9}, 2);
  EXPECT_DOUBLE_EQ(film.mean(0).x, 4.5);
  EXPECT_DOUBLE_EQ(variance_of_mean(film, 0).x, (2.5 * 2.5 + 2.5 * 2.5) / 2);
}

TEST(Unit_Variance, OfOneReplicateIsNotKnown) {
  EXPECT_EQ(variance_of_mean(film_of({1, 5, 3}, 1), 0).x, 0);
  EXPECT_EQ(variance_of_mean(film_of({1}, 4), 0).x, 0);
  EXPECT_EQ(used_replicates(film_of({1, 5, 3}, 4), 0), 3u);
}

// Whatever the count of samples: whole rounds of the replicates, a sample more, fewer than them.
TEST(Statistical_Variance, IsUnbiasedForIndependentSamples) {
  for (const int samples : {2, 3, 4, 6, 7, 16, 17}) {
    const Film film = test::synthetic_film(128, samples, 4, 5, exponential);
    statistics::Moments variances;
    for (std::size_t i = 0; i < film.pixel_count(); ++i) variances.add(variance_of_mean(film, i).x);
    EXPECT_GT(variances.p_value(1.0 / samples), 1e-3) << samples << " " << variances.mean();
  }
}

}  // namespace
}  // namespace candela
