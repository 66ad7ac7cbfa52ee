// Sixteen samplers side by side: the bits of single ones.
#include "renderer/sampling/sampler_block.h"

#include <gtest/gtest.h>

#include <vector>

namespace candela {
namespace {

TEST(Unit_SamplerBlock, HasTheBitsOfSingleSamplers) {
  for (const std::uint32_t replicates : {1u, 2u, 3u, 4u, 5u, 15u, 16u, 17u, 100u})
    for (const std::uint32_t first : {0u, 16u, 21u, 1008u, 1u << 20, 4294967280u}) {
      const PairOrder order = replicates == 3 ? PairOrder::Padded : PairOrder::Joint;
      const PixelSampler pixel(5, 17, 301, replicates, order);
      const SamplerBlock block(pixel, first);
      for (const std::uint32_t bounce : {0u, 1u, 40u}) {
        SobolPointLanes points, light_points;
        Lanes<std::uint32_t> numbers, lobes;
        block.sample_1d(bounce, Dimension::LobeChoice, lobes);
        block.sample_2d(bounce, Dimension::Direction, points);
        block.sample_2d(bounce, Dimension::LightPoint, light_points);
        block.sample_1d(bounce, Dimension::Roulette, numbers);
        for (std::uint32_t i = 0; i < block_size; ++i) {
          const Sampler single = pixel.at(first + i);
          const Vec2f point = single.sample_2d(bounce, Dimension::Direction);
          ASSERT_EQ(unit_float(points.x[i]), point.x) << replicates << " " << first << " " << i;
          ASSERT_EQ(unit_float(points.y[i]), point.y) << replicates << " " << first << " " << i;
          const SobolPoint light_point = single.sample_2d_bits(bounce, Dimension::LightPoint);
          ASSERT_EQ(light_points.x[i], light_point.x);
          ASSERT_EQ(light_points.y[i], light_point.y);
          ASSERT_EQ(lobes[i], single.sample_1d_bits(bounce, Dimension::LobeChoice));
          ASSERT_EQ(numbers[i], single.sample_1d_bits(bounce, Dimension::Roulette));
          ASSERT_EQ(block.lane(i).sample_1d_bits(bounce, Dimension::Roulette), numbers[i]);
        }
      }
    }
}

TEST(Unit_SamplerBlock, MayBeOfSeveralPixels) {
  for (const PairOrder order : {PairOrder::Joint, PairOrder::Padded}) {
    SequenceLanes sequences;
    sequences.order = order;
    std::vector<Sampler> singles;
    for (std::uint32_t i = 0; i < block_size; ++i) {
      const PixelSampler pixel(5, i / 3, 7 - i / 5, 4, order);
      const std::uint32_t sample = 1000 * i + 5;
      sequences.set(i, pixel, sample);
      singles.push_back(pixel.at(sample));
    }
    const SamplerBlock block(sequences);
    for (const std::uint32_t bounce : {0u, 1u, 40u}) {
      SobolPointLanes points;
      Lanes<std::uint32_t> numbers;
      block.sample_2d(bounce, Dimension::Direction, points);
      block.sample_1d(bounce, Dimension::Roulette, numbers);
      for (std::uint32_t i = 0; i < block_size; ++i) {
        const SobolPoint point = singles[i].sample_2d_bits(bounce, Dimension::Direction);
        ASSERT_EQ(points.x[i], point.x) << bounce << " " << i;
        ASSERT_EQ(points.y[i], point.y) << bounce << " " << i;
        ASSERT_EQ(numbers[i], singles[i].sample_1d_bits(bounce, Dimension::Roulette));
        ASSERT_EQ(block.lane(i).sample_1d_bits(bounce, Dimension::Roulette), numbers[i]);
      }
    }
  }
}

// Branches take a sample's place in the sequence among themselves.
TEST(Unit_SamplerBlock, BranchesHavePointsOfTheirOwn) {
  constexpr std::uint32_t branches = 4, first = 32;
  for (const std::uint32_t replicates : {1u, 4u, 5u}) {
    const PixelSampler pixel(5, 17, 301, replicates);
    for (std::uint32_t branch = 0; branch < branches; ++branch) {
      const SamplerBlock block(pixel, first, branches, branch);
      Lanes<std::uint32_t> numbers;
      SobolPointLanes points;
      block.sample_1d(2, Dimension::Roulette, numbers);
      block.sample_2d(0, Dimension::Direction, points);
      for (std::uint32_t i = 0; i < block_size; ++i) {
        const std::uint32_t sample = first + i;
        const Sampler single(pixel.sequence_key(sample % replicates),
                             sample / replicates * branches + branch);
        ASSERT_EQ(numbers[i], single.sample_1d_bits(2, Dimension::Roulette));
        ASSERT_EQ(points.x[i], single.sample_2d_bits(0, Dimension::Direction).x);
      }
    }
  }
}

}  // namespace
}  // namespace candela
