// From a description (or a file) to pixels in one call, as the command line does it.
#pragma once

#include <string>
#include <vector>

#include "integrators/render.h"
#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"

namespace candela::test {

struct RenderSettings {
  RenderOptions options;
  AcceleratorKind accelerator = AcceleratorKind::Auto;
  int threads = 0;
};

// A small square picture of `size` pixels.
[[nodiscard]] RenderSettings settings_of(int size, int samples_per_pixel, std::uint64_t seed = 1);

// The compiled scene; a failure is a test failure and an empty scene.
[[nodiscard]] Scene compiled(const description::SceneDescription& description,
                             const RenderOptions& options);

[[nodiscard]] RenderResult rendered(const description::SceneDescription& description,
                                    const RenderSettings& settings);
[[nodiscard]] RenderResult rendered(const Scene& scene, const RenderSettings& settings);

// With alpha.
[[nodiscard]] Image picture(const Scene& scene, const RenderSettings& settings);

// `part` is the crop's pixels of the picture `whole`, bit by bit.
void expect_part(const Image& part, const Image& whole, const PixelRect& crop);

// `whole`, which these settings gave, has the same bits with other threads and tiles, and its part
// `crop`, in pixels of the full picture, rendered alone.
void expect_same_bits_however_rendered(const Scene& scene, RenderSettings settings,
                                       const Image& whole, const PixelRect& crop);

// Each pixel's mean of R, G, B, in rows from the top.
[[nodiscard]] std::vector<double> grey(const Image& image);

// Mean over all pixels and the three colour channels.
[[nodiscard]] double mean_of(const Image& image);

}  // namespace candela::test
