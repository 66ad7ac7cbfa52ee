#include "renderer/film/film.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

FilmSample sample_of(Rgb radiance, float alpha = 1) {
  FilmSample sample;
  sample.radiance = radiance;
  sample.alpha = alpha;
  return sample;
}

TEST(Unit_Film, MeansAreOverEachPixelsOwnSamples) {
  Film film(4, 3, {1, 1, 3, 3}, aov_bit(Aov::Samples));
  film.add(1, 1, sample_of({1, 2, 3}));
  film.add(1, 1, sample_of({3, 2, 1}, 0));
  film.add(2, 2, sample_of({5, 5, 5}));
  film.add_invalid(2, 2);
  const Image image = film.to_image(true);
  ASSERT_EQ(image.width, 2);
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B", "A", "samples.V"}));
  EXPECT_EQ(std::vector<float>(image.pixel(0, 0), image.pixel(0, 0) + 5),
            (std::vector<float>{2, 2, 2, 0.5f, 2}));
  EXPECT_EQ(std::vector<float>(image.pixel(1, 1), image.pixel(1, 1) + 5),
            (std::vector<float>{2.5f, 2.5f, 2.5f, 0.5f, 2}));
  EXPECT_EQ(std::vector<float>(image.pixel(1, 0), image.pixel(1, 0) + 5),
            (std::vector<float>{0, 0, 0, 0, 0}));
  EXPECT_EQ(film.min_samples(), 0u);
  EXPECT_EQ(film.max_samples(), 2u);
}

// Means are mixed by the weight, whatever the counts; replicates keep to themselves.
TEST(Unit_Film, APilotIsMixedInByItsWeight) {
  Film pilot(4, 4, {0, 0, 4, 4}, 0, 2);
  Film film(4, 4, {1, 1, 3, 3}, 0, 2);
  for (const float v : {1, 2, 3, 4}) pilot.add(1, 1, sample_of(Rgb(v)));
  for (const float v : {10, 20}) film.add(1, 1, sample_of(Rgb(v), 0));
  for (const float v : {5, 7}) pilot.add(2, 1, sample_of(Rgb(v)));
  film.add(2, 1, sample_of(Rgb(100)));  // not one in each replicate: only the pilot counts
  const Film mixed = film.with_pilot(pilot, 0.25);
  ASSERT_EQ(mixed.crop(), film.crop());
  EXPECT_EQ(mixed.samples(0), 6u);
  EXPECT_DOUBLE_EQ(mixed.replicate_sum(0, 0).x, (0.75 * 10 + 0.25 * 2) * 3);
  EXPECT_DOUBLE_EQ(mixed.replicate_sum(0, 1).x, (0.75 * 20 + 0.25 * 3) * 3);
  EXPECT_DOUBLE_EQ(mixed.mean(0).x, 0.75 * 15 + 0.25 * 2.5);
  EXPECT_EQ(mixed.to_image(true).pixel(0, 0)[3], 0.25f);
  EXPECT_EQ(mixed.samples(1), 2u);
  EXPECT_DOUBLE_EQ(mixed.mean(1).x, 6);
}

TEST(Unit_Film, LayersAverageOverSamplesThatHit) {
  Film film(1, 1, {0, 0, 1, 1},
            aov_bit(Aov::Depth) | aov_bit(Aov::MaterialId) | aov_bit(Aov::Normal));
  FilmSample hit = sample_of(Rgb(1));
  hit.has_hit = true;
  hit.depth = 4;
  hit.normal = {0, 1, 0};
  hit.material = 6;
  film.add(0, 0, hit);
  hit.depth = 6;
  hit.material = 9;
  film.add(0, 0, hit);
  film.add(0, 0, sample_of(Rgb(0), 0));
  const Image image = film.to_image(false);
  EXPECT_EQ(image.pixel(0, 0)[image.channel_index("depth.Z")], 5);
  EXPECT_EQ(image.pixel(0, 0)[image.channel_index("normal.Y")], 1);
  EXPECT_EQ(image.pixel(0, 0)[image.channel_index("material_id.V")], 7);
}

TEST(Stress_Film, AHundredMillionHalvesStayAHalf) {
  Film film(1, 1, {0, 0, 1, 1}, 0);
  const FilmSample half = sample_of(Rgb(0.5f));
  for (int i = 0; i < 100'000'000; ++i) film.add(0, 0, half);
  EXPECT_NEAR(film.to_image(false).pixel(0, 0)[0], 0.5, 1e-6);
}

}  // namespace
}  // namespace candela
