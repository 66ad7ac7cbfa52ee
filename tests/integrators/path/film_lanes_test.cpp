// Samples of a block that enter the film at once: the bits of one after the other.
#include "integrators/path/film_lanes.h"

#include <gtest/gtest.h>

#include "tests/light/directions.h"

namespace candela {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct BlockSamples {
  Vec3Lanes radiance;
  Lanes<float> weight, alpha;
};

BlockSamples samples_of(std::uint64_t block) {
  BlockSamples samples;
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const auto number = [&](std::uint64_t stream) {
      return light_test::random_unit(block * block_size + i, stream);
    };
    samples.radiance.set(i, {number(0), 3 * number(1), 1e-6f * number(2)});
    samples.weight[i] = number(3) < 0.5f ? 1.0f : -1.2f;
    samples.alpha[i] = number(4) < 0.3f ? number(5) : 1.0f;
  }
  return samples;
}

// A film that has all blocks, at once or sample by sample.
struct FilledFilm {
  Film film;
  TileCounts counts;

  void add(const BlockPlace& place, const BlockSamples& samples, float clamp, bool at_once) {
    if (at_once)
      return add_or_count(place, samples.radiance, samples.weight, samples.alpha, clamp, film,
                          counts);
    for_each_lane(place.lanes, [&](std::uint32_t i) {
      FilmSample sample;
      sample.radiance = samples.radiance[i];
      sample.weight = samples.weight[i];
      sample.alpha = samples.alpha[i];
      add_or_count(sample, place.pixels.x[i], place.pixels.y[i], place.samples[i], clamp, film,
                   counts);
    });
  }
};

void expect_equal(const FilledFilm& a, const FilledFilm& b) {
  EXPECT_EQ(a.film.to_image(true).values, b.film.to_image(true).values);
  for (std::size_t i = 0; i < a.film.pixel_count(); ++i) {
    EXPECT_EQ(a.film.samples(i), b.film.samples(i));
    for (std::uint32_t r = 0; r < a.film.replicates(); ++r)
      EXPECT_EQ(a.film.replicate_sum(i, r), b.film.replicate_sum(i, r)) << "replicate " << r;
  }
  EXPECT_EQ(a.counts.invalid_samples, b.counts.invalid_samples);
  ASSERT_EQ(a.counts.first_invalid.has_value(), b.counts.first_invalid.has_value());
  if (a.counts.first_invalid) {
    EXPECT_EQ(a.counts.first_invalid->sample, b.counts.first_invalid->sample);
  }
}

void expect_same_bits(const Film& empty, float clamp, const auto& spoil) {
  RenderOptions options;
  options.width = 3;
  options.height = 2;
  FilledFilm at_once{empty, {}}, one_by_one{empty, {}};
  for (std::uint32_t block = 0; block < 12; ++block) {
    const LaneMask lanes =
        block % 3 == 0 ? all_lanes
                       : static_cast<LaneMask>(light_test::random_unit(block, 9) * 0xffff) + 1;
    const BlockPlace place =
        place_in_pixel(options, 1 + static_cast<int>(block % 2), 1, block / 2 * block_size, lanes);
    BlockSamples samples = samples_of(block);
    spoil(block, samples.radiance);
    at_once.add(place, samples, clamp, true);
    one_by_one.add(place, samples, clamp, false);
  }
  expect_equal(at_once, one_by_one);
}

constexpr auto leave = [](std::uint32_t /*block*/, Vec3Lanes& /*radiance*/) {};
const PixelRect rect{1, 0, 3, 2};

TEST(Agreement_FilmLanes, AreAddedInTheSameOrder) {
  for (const std::uint32_t replicates : {1u, 2u, 3u, 4u, 5u, 16u, 40u})
    expect_same_bits(Film(3, 2, rect, 0, replicates), infinity, leave);
  for (const std::uint32_t samples : {1u, 4u, 12u, 16u, 100u}) {
    Film film(3, 2, rect, 0, 4);
    film.sum_pieces_of(samples);
    expect_same_bits(film, infinity, leave);
  }
  expect_same_bits(Film(3, 2, rect, 0, 4, Mat3d(1, .2, 0, -.1, 1, 0, 0, .3, .9)), infinity, leave);
}

TEST(Agreement_FilmLanes, WhatIsInvalidIsCountedAndWhatIsBrightIsClamped) {
  expect_same_bits(Film(3, 2, rect, 0, 4), 1.5f, leave);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float value : {-1.0f, -infinity, infinity, nan})
    for (const float clamp : {1.5f, infinity})
      expect_same_bits(Film(3, 2, rect, 0, 4), clamp,
                       [&](std::uint32_t block, Vec3Lanes& radiance) {
                         if (block == 4) radiance.y[7] = value;
                         if (block == 5) radiance.x[15] = value;
                         if (block == 9) radiance.z[0] = value;
                       });
}

}  // namespace
}  // namespace candela
