// Sixteen samplers side by side: the bits of single ones.
#include "renderer/sampling/sampler_block.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Unit_SamplerBlock, HasTheBitsOfSingleSamplers) {
  for (const std::uint32_t replicates : {1u, 2u, 3u, 4u, 5u, 15u, 16u, 17u, 100u})
    for (const std::uint32_t first : {0u, 16u, 21u, 1008u, 4294967280u}) {
      const PixelSampler pixel(5, 17, 301, replicates);
      const SamplerBlock block(pixel, first);
      for (const std::uint32_t bounce : {0u, 1u, 40u}) {
        SobolPointLanes points;
        SamplerLanes<std::uint32_t> numbers;
        block.sample_2d(bounce, Dimension::Direction, points);
        block.sample_1d(bounce, Dimension::Roulette, numbers);
        for (std::uint32_t i = 0; i < sampler_lanes; ++i) {
          const Sampler single = pixel.at(first + i);
          const Vec2f point = single.sample_2d(bounce, Dimension::Direction);
          ASSERT_EQ(unit_float(points.x[i]), point.x) << replicates << " " << first << " " << i;
          ASSERT_EQ(unit_float(points.y[i]), point.y) << replicates << " " << first << " " << i;
          ASSERT_EQ(numbers[i], single.sample_1d_bits(bounce, Dimension::Roulette));
          ASSERT_EQ(block.lane(i).sample_1d_bits(bounce, Dimension::Roulette), numbers[i]);
        }
      }
    }
}

}  // namespace
}  // namespace candela
