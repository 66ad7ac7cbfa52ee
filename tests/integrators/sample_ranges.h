// Pictures whose samples come in ranges, cut anywhere.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "integrators/path/kernels.h"
#include "tests/scenes/render_scene.h"

namespace candela::test {

// Layers that kernels fill.
inline constexpr AovSet all_aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Normal) |
                                   aov_bit(Aov::Depth) | aov_bit(Aov::Position) |
                                   aov_bit(Aov::MaterialId) | aov_bit(Aov::Samples);

// By the kernel of F; range i goes from cuts[i] to cuts[i + 1].
template <FeatureSet F>
[[nodiscard]] std::vector<float> picture_of_ranges(const Scene& scene,
                                                   const RenderSettings& settings,
                                                   const std::vector<std::uint32_t>& cuts) {
  const RenderOptions& options = settings.options;
  const EmbreeAccel accelerator(scene);
  const Filter filter = make_filter(options);
  const auto context = make_path_context(scene, accelerator, filter, options);
  const PixelRect all{0, 0, options.width, options.height};
  Film film(options.width, options.height, all, options.aovs, 4);
  for (std::size_t i = 1; i < cuts.size(); ++i)
    render_tile<F>(context, {all, {cuts[i - 1], cuts[i]}, nullptr, options.seed}, film);
  return film.to_image(true).values;
}

// The picture of `whole`, however else its samples are cut.
template <FeatureSet F>
void expect_same_over_cuts(const Scene& scene, const RenderSettings& settings,
                           const std::vector<std::uint32_t>& whole,
                           const std::vector<std::vector<std::uint32_t>>& others) {
  const std::vector<float> expected = picture_of_ranges<F>(scene, settings, whole);
  for (const std::vector<std::uint32_t>& cuts : others)
    EXPECT_EQ(picture_of_ranges<F>(scene, settings, cuts), expected) << cuts.size() - 1 << " parts";
}

}  // namespace candela::test
