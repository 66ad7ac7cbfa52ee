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

TEST(Unit_Film, ACropKeepsAllThatIsKnown) {
  Film film(4, 4, {0, 0, 4, 4}, aov_bit(Aov::Depth), 2);
  FilmSample hit = sample_of(Rgb(3), 0.5f);
  hit.has_hit = true;
  hit.depth = 7;
  film.add(2, 1, hit);
  film.add(2, 1, sample_of(Rgb(5), 0.5f));
  film.add(2, 1, sample_of(Rgb(7), 0.5f));
  film.add_cost(2, 1, 11);
  Film part(4, 4, {1, 1, 3, 4}, film.aovs(), 2);
  part.take_part_of(film);
  ASSERT_EQ(part.crop(), (PixelRect{1, 1, 3, 4}));
  EXPECT_EQ(part.full_width(), 4);
  const std::size_t i = part.index(2, 1);
  EXPECT_EQ(part.samples(i), 3u);
  EXPECT_EQ(part.cost(i), 11u);
  EXPECT_EQ(part.replicate_sum(i, 0).x, 10);
  EXPECT_EQ(part.replicate_sum(i, 1).x, 5);
  const Image image = part.to_image(true);
  EXPECT_EQ(image.pixel(1, 0)[3], 0.5f);
  EXPECT_EQ(image.pixel(1, 0)[image.channel_index("depth.Z")], 7);
  EXPECT_EQ(part.samples(part.index(1, 1)), 0u);
}

TEST(Unit_Film, SamplesComeInAnyOrder) {
  Film film(1, 1, {0, 0, 1, 1}, aov_bit(Aov::MaterialId), 2);
  FilmSample hit = sample_of(Rgb(1));
  hit.has_hit = true;
  for (const std::uint32_t index : {3u, 1u, 2u, 0u}) {
    hit.radiance = Rgb(static_cast<float>(1u << index));
    hit.material = index;
    film.add(0, 0, index, hit);
  }
  EXPECT_EQ(film.samples(0), 4u);
  EXPECT_EQ(film.replicate_sum(0, 0).x, 1 + 4);
  EXPECT_EQ(film.replicate_sum(0, 1).x, 2 + 8);
  const Image image = film.to_image(false);
  EXPECT_EQ(image.pixel(0, 0)[image.channel_index("material_id.V")], 1);  // the first's
}

// By the sample's replicate, in the film's colours, and without counting a sample.
TEST(Unit_Film, WeightedLightIsAddedToASample) {
  Mat3d twice(2.0);
  Film film(2, 1, {0, 0, 2, 1}, 0, 2, twice);
  for (std::uint32_t s = 0; s < 4; ++s) film.add(1, 0, s, {.radiance = Rgb(1)});
  film.add_weighted(1, 0, 3, Rgb(-3, 0, 5));
  EXPECT_EQ(film.replicate_sum(1, 0), Vec3d(4));
  EXPECT_EQ(film.replicate_sum(1, 1), Vec3d(-2, 4, 14));
  EXPECT_EQ(film.samples(1), 4u);
}

TEST(Unit_Film, PiecesOfASequenceAreTakenTogether) {
  Film film(2, 1, {0, 0, 2, 1}, 0, 2);
  EXPECT_EQ(film.sequences(), 2u);
  film.sum_pieces_of(3);
  EXPECT_EQ(film.sequences(), 1u);
  for (const float radiance : {1.0f, 2.0f, 4.0f, 8.0f, 16.0f, 32.0f})
    film.add(1, 0, sample_of(Rgb(radiance)));
  EXPECT_EQ(film.replicate_sum(1, 0).x, 7);
  EXPECT_EQ(film.replicate_sum(1, 1).x, 56);
  Film whole(2, 1, film.crop(), 0, 1);
  whole.add(1, 0, sample_of(Rgb(100)));
  whole.take_part_of(film);
  EXPECT_EQ(whole.samples(1), 6u);
  EXPECT_EQ(whole.replicate_sum(1, 0).x, 63);
  whole.add(1, 0, sample_of(Rgb(1)));
  EXPECT_EQ(whole.replicate_sum(1, 0).x, 64);
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
