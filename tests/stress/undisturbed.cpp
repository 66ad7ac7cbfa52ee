#include "tests/stress/undisturbed.h"

#include <gtest/gtest.h>

#include "renderer/base/parallel.h"
#include "renderer/image/compare.h"
#include "tests/statistics/replicates.h"
#include "tests/stress/row.h"

namespace candela::test {
namespace {

// Every other render, from the `first` on: the even ones of one scene and the odd ones of the other
// share no seed.
statistics::Replicates every_other(const Renders& renders, std::size_t first) {
  statistics::Replicates replicates{
      renders.name, renders.images[0].width, renders.images[0].height, {}};
  for (std::size_t i = first; i < renders.images.size(); i += 2)
    replicates.images.push_back(grey(renders.images[i]));
  return replicates;
}

Image mean_of(const std::vector<Image>& images) {
  Image mean = images[0];
  for (std::size_t i = 0; i < mean.values.size(); ++i) {
    double sum = 0;
    for (const Image& image : images) sum += image.values[i];
    mean.values[i] = static_cast<float>(sum / static_cast<double>(images.size()));
  }
  return mean;
}

double relmse(const Image& image, const Image& reference) {
  const Result<ImageComparison> comparison = compare_images(image, reference);
  EXPECT_TRUE(comparison);
  return comparison ? comparison->relmse : 0;
}

}  // namespace

Renders renders_of(const std::string& name, const description::SceneDescription& description,
                   const RenderSettings& settings, int count) {
  RenderOptions options = settings.options;
  const Scene scene = compiled(description, options);
  Renders renders{name, {}, 0};
  with_threads(settings.threads, [&] {
    const AnyAccelerator accelerator = build_accelerator(scene, settings.accelerator);
    for (int i = 0; i < count; ++i) {
      options.seed = static_cast<std::uint64_t>(i + 1);
      const RenderResult result = render(scene, accelerator, options, nullptr, nullptr);
      renders.images.push_back(result.film.to_image(false));
      renders.invalid_samples += result.statistics.invalid_samples;
    }
  });
  EXPECT_EQ(renders.invalid_samples, 0u) << name;
  return renders;
}

void expect_same_bits(const Renders& disturbed, const Renders& undisturbed) {
  std::size_t different = 0;
  ASSERT_FALSE(disturbed.images.empty()) << disturbed.name;
  ASSERT_EQ(disturbed.images.size(), undisturbed.images.size()) << disturbed.name;
  for (std::size_t i = 0; i < disturbed.images.size(); ++i)
    ASSERT_EQ(disturbed.images[i].values.size(), undisturbed.images[i].values.size());
  for (std::size_t i = 0; i < disturbed.images.size(); ++i)
    for (std::size_t k = 0; k < disturbed.images[i].values.size(); ++k)
      different += disturbed.images[i].values[k] != undisturbed.images[i].values[k];
  EXPECT_EQ(different, 0u) << disturbed.name;
  add_row(disturbed.name, {{"different values", static_cast<double>(different)},
                           {"invalid samples", static_cast<double>(disturbed.invalid_samples)}});
}

Distance distance_of(const Renders& disturbed, const Renders& undisturbed) {
  const Image mean = mean_of(undisturbed.images);
  const auto count = static_cast<double>(undisturbed.images.size());
  Distance distance;
  for (std::size_t i = 0; i < undisturbed.images.size(); ++i) {
    distance.difference_relmse += relmse(disturbed.images[i], undisturbed.images[i]) / count;
    distance.noise_relmse += relmse(undisturbed.images[i], mean) / (count - 1);
  }
  return distance;
}

namespace {

statistics::Agreement compared(const Renders& disturbed, const Renders& undisturbed, double level) {
  const statistics::Agreement agreement =
      compare_replicates(every_other(disturbed, 0), every_other(undisturbed, 1), {.level = level});
  const Distance distance = distance_of(disturbed, undisturbed);
  add_row(disturbed.name, {{"p pixels", agreement.pixels_p_value},
                           {"p blocks", agreement.blocks_p_value},
                           {"p whole", agreement.whole_p_value},
                           {"ratio of means", agreement.whole_ratio},
                           {"relMSE of difference", distance.difference_relmse},
                           {"relMSE of noise", distance.noise_relmse},
                           {"invalid samples", static_cast<double>(disturbed.invalid_samples)}});
  return agreement;
}

}  // namespace

void add_comparison(const Renders& disturbed, const Renders& undisturbed) {
  (void)compared(disturbed, undisturbed, 1e-3);
}

void expect_within_noise(const Renders& disturbed, const Renders& undisturbed, double level) {
  const statistics::Agreement agreement = compared(disturbed, undisturbed, level);
  EXPECT_TRUE(agreement.passed) << agreement.message;
}

}  // namespace candela::test
