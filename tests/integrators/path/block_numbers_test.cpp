// The numbers of a block at once against those of single samples.
#include "integrators/path/block_numbers.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

// All that asks for numbers. Of few lights one is picked by the number that also places the point
// on it, of many by one of its own.
Scene scene_with_lights(std::size_t count) {
  Scene scene;
  const std::vector<Light> lights(count, Light{.kind = LightKind::Triangle});
  scene.light_sampler = LightSampler(lights, std::vector<double>(count, 1.0));
  scene.features.mixes = true;
  scene.features.scattering_media = true;
  scene.features.bsdf_models = all_models;
  return scene;
}

SamplerBlock some_samplers() {
  return SamplerBlock(PixelSampler(7, 3, 5, 4), 16);
}

void expect_same(const StepNumbers& a, const StepNumbers& b) {
  EXPECT_EQ(a.light_choice, b.light_choice);
  EXPECT_EQ(a.light_point, b.light_point);
  EXPECT_EQ(a.lobe, b.lobe);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.roulette, b.roulette);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.free_flight, b.free_flight);
}

StepNumbers single_numbers(const Scene& scene, const Sampler& sampler, std::uint32_t bounce) {
  StepNumbers numbers;
  draw_hit<media_features>(scene, sampler, bounce, numbers);
  draw_direction<media_features>(scene, Roulette{}, sampler, bounce, numbers);
  return numbers;
}

TEST(Unit_BlockNumbers, AreThoseOfSingleSamples) {
  const SamplerBlock samplers = some_samplers();
  for (const std::size_t lights : {2u, 5000u}) {
    const Scene scene = scene_with_lights(lights);
    EXPECT_EQ(scene.light_sampler.tells_rest(), lights == 2);
    for (std::uint32_t bounce = 0; bounce < 5; ++bounce) {
      BlockNumbers block;
      block.draw_hit<media_features>(scene, samplers, bounce);
      block.draw_direction<media_features>(scene, Roulette{}, samplers, bounce);
      for (std::size_t i = 0; i < block_size; ++i)
        expect_same(block.lane<media_features>(i), single_numbers(scene, samplers.lane(i), bounce));
    }
  }
}

TEST(Unit_BlockNumbers, DeltaModelsTakeOnlyALobeAndRoulette) {
  const Scene scene = scene_with_lights(2);
  const SamplerBlock samplers = some_samplers();
  for (std::uint32_t bounce = 0; bounce < 5; ++bounce)
    for (std::size_t i = 0; i < block_size; ++i) {
      const StepNumbers all = single_numbers(scene, samplers.lane(i), bounce);
      EXPECT_GT(all.lobe, 0);
      EXPECT_EQ(all.roulette > 0, bounce >= Roulette{}.first_bounce);
      StepNumbers delta;
      draw_delta(scene, Roulette{}, samplers.lane(i), bounce, delta);
      expect_same(delta, {.lobe = all.lobe, .roulette = all.roulette});
    }
}

}  // namespace
}  // namespace candela
