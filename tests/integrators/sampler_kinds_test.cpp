// --sampler: the three kinds of random numbers give one picture, with noise of three strengths.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"
#include "tests/statistics/replicates.h"

namespace candela {
namespace {

using namespace test;

constexpr int size = 16;

statistics::Replicates replicates_of(const description::SceneDescription& scene, SamplerKind kind,
                                     std::uint64_t first_seed) {
  statistics::Replicates result{
      "by kind " + std::to_string(static_cast<int>(kind)), size, size, {}};
  for (std::uint64_t seed = first_seed; seed < first_seed + 16; ++seed) {
    RenderSettings settings = settings_of(size, 64, seed);
    settings.options.sampler = kind;
    settings.options.replicates = 1;
    settings.options.max_depth = 1;
    settings.options.filter = FilterKind::Box;
    const RenderResult render = rendered(scene, settings);
    EXPECT_EQ(render.statistics.invalid_samples, 0u);
    result.images.push_back(grey(render.film.to_image(false)));
  }
  return result;
}

// The geometric mean over pixels that have noise, of which few would rule the arithmetic one. That
// of 256 pixels with 15 degrees of freedom each scatters by some 2 %.
double typical_variance(const statistics::Replicates& replicates) {
  double sum = 0;
  int count = 0;
  for (std::size_t pixel = 0; pixel < std::size_t{size} * size; ++pixel) {
    statistics::Moments moments;
    for (const auto& image : replicates.images) moments.add(image[pixel]);
    if (moments.variance() == 0) continue;
    sum += std::log(moments.variance());
    ++count;
  }
  EXPECT_GT(count, size * size / 2);
  return std::exp(sum / count);
}

TEST(Agreement_SamplerKinds, GiveOnePictureWithNoiseOfThreeStrengths) {
  const description::SceneDescription scene = small_room();
  const auto joint = replicates_of(scene, SamplerKind::Sobol, 100);
  const auto padded = replicates_of(scene, SamplerKind::Padded, 200);
  const auto independent = replicates_of(scene, SamplerKind::Independent, 300);
  for (const auto* other : {&padded, &independent}) {
    const auto result = statistics::compare_replicates(*other, joint);
    EXPECT_TRUE(result.passed) << result.message;
  }
  EXPECT_LT(1.1 * typical_variance(joint), typical_variance(padded));
  EXPECT_LT(1.1 * typical_variance(padded), typical_variance(independent));
}

}  // namespace
}  // namespace candela
