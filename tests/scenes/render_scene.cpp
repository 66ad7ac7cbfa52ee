#include "tests/scenes/render_scene.h"

#include <gtest/gtest.h>

#include "renderer/base/parallel.h"

namespace candela::test {

RenderSettings settings_of(int size, int samples_per_pixel, std::uint64_t seed) {
  RenderSettings settings;
  settings.options.width = size;
  settings.options.height = size;
  settings.options.samples_per_pixel = samples_per_pixel;
  settings.options.seed = seed;
  return settings;
}

Scene compiled(const description::SceneDescription& description, const RenderOptions& options) {
  Result<Scene> scene = compile(description, compile_options(options));
  for (const Diagnostic& diagnostic : scene.diagnostics.list())
    EXPECT_NE(diagnostic.severity, Severity::Error) << to_string(diagnostic);
  return scene ? std::move(*scene) : Scene{};
}

RenderResult rendered(const Scene& scene, const RenderSettings& settings) {
  RenderResult result;
  with_threads(settings.threads, [&] {
    const AnyAccelerator accelerator = build_accelerator(scene, settings.accelerator);
    result = render(scene, accelerator, settings.options, nullptr, nullptr);
  });
  EXPECT_EQ(result.statistics.invalid_samples, 0u);
  return result;
}

RenderResult rendered(const description::SceneDescription& description,
                      const RenderSettings& settings) {
  const Scene scene = compiled(description, settings.options);
  return rendered(scene, settings);
}

Image picture(const Scene& scene, const RenderSettings& settings) {
  return rendered(scene, settings).film.to_image(true);
}

void expect_part(const Image& part, const Image& whole, const PixelRect& crop) {
  ASSERT_EQ(part.width, crop.width());
  ASSERT_EQ(part.height, crop.height());
  ASSERT_EQ(part.channels, whole.channels);
  for (int y = crop.y0; y < crop.y1; ++y)
    for (int x = crop.x0; x < crop.x1; ++x)
      for (std::size_t c = 0; c < whole.channel_count(); ++c)
        ASSERT_EQ(part.pixel(x - crop.x0, y - crop.y0)[c], whole.pixel(x, y)[c]);
}

void expect_same_bits_however_rendered(const Scene& scene, RenderSettings settings,
                                       const Image& whole, const PixelRect& crop) {
  const PixelRect rendered_before = settings.options.crop.value_or(PixelRect{});
  settings.threads = 1;
  EXPECT_EQ(picture(scene, settings).values, whole.values) << "one thread";
  settings.threads = 3;
  settings.options.tile_size = 7;
  EXPECT_EQ(picture(scene, settings).values, whole.values) << "three threads, tiles of 7";
  settings.options.crop = crop;
  expect_part(picture(scene, settings), whole,
              {crop.x0 - rendered_before.x0, crop.y0 - rendered_before.y0,
               crop.x1 - rendered_before.x0, crop.y1 - rendered_before.y0});
}

std::vector<double> grey(const Image& image) {
  std::vector<double> values;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      values.push_back(
          (image.pixel(x, y)[0] + double{image.pixel(x, y)[1]} + image.pixel(x, y)[2]) / 3);
  return values;
}

double mean_of(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      sum += static_cast<double>(image.values[i * image.channel_count() + c]);
  return sum / static_cast<double>(3 * image.pixel_count());
}

}  // namespace candela::test
