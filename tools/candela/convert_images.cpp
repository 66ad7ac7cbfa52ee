#include "tools/candela/convert_images.h"

#include <array>
#include <cstring>

#include <fmt/format.h>

#include "renderer/base/parallel.h"
#include "renderer/image/decode.h"
#include "renderer/image/encode.h"
#include "renderer/image/file_input.h"
#include "renderer/sampling/equal_area.h"
#include "renderer/scene/compile_environment.h"

namespace candela::cli {
namespace {

// In place of the time of day, so that the same scene gives the same bytes.
const std::string undated = "2000:01:01 00:00:00";

// The mean over a pixel by a grid of directions of equal solid angles.
Rgb pixel_mean(const pbrt::WrittenSky& sky, const Environment& environment,
               const TextureStore& textures, int x, int y) {
  constexpr int grid = 4;
  Vec3d sum(0.0);
  for (int j = 0; j < grid; ++j)
    for (int i = 0; i < grid; ++i) {
      const Vec2d place((x + (i + 0.5) / grid) / sky.side, (y + (j + 0.5) / grid) / sky.side);
      const Vec3d along(square_to_equal_area_sphere(Vec2f(place)));
      const Vec3f direction(normalize(sky.world_from_sky * along));
      sum += Vec3d(environment_radiance(environment, textures, direction));
    }
  return Rgb(sum / static_cast<double>(grid * grid));
}

// What stands in for an image that cannot be decoded, as in pictures (texture.h).
DecodedImage magenta_texel(bool is_float) {
  constexpr std::array<unsigned char, 4> bytes{255, 0, 255, 255};
  constexpr std::array<float, 4> floats{1, 0, 1, 1};
  DecodedImage image;
  image.header = {.width = 1,
                  .height = 1,
                  .sample_type = is_float ? SampleType::Float : SampleType::U8,
                  .channels = {"R", "G", "B", "A"},
                  .alpha_channel = 3,
                  .alpha_is_straight = true};
  image.samples = allocate_samples(image.header);
  if (is_float)
    std::memcpy(image.samples.get(), floats.data(), sizeof(floats));
  else
    std::memcpy(image.samples.get(), bytes.data(), sizeof(bytes));
  return image;
}

}  // namespace

std::optional<pbrt::ImageFacts> image_facts(const std::string& path) {
  const Result<ImageHeader> header = read_image_header(path, DecodeLimits{});
  if (!header) return std::nullopt;
  pbrt::ImageFacts facts;
  facts.width = header->width;
  facts.height = header->height;
  facts.channels = static_cast<int>(header->channels.size());
  facts.alpha_channel = header->alpha_channel;
  facts.is_float =
      header->sample_type == SampleType::Half || header->sample_type == SampleType::Float;
  return facts;
}

Result<std::string> make_image(const pbrt::WrittenImage& image) {
  if (image.is_copied) {
    const Result<Bytes> bytes = read_regular_file(image.source, DecodeLimits{}.max_bytes);
    if (!bytes) return bytes.diagnostics;
    return std::string(bytes->begin(), bytes->end());
  }
  const Result<DecodedImage> decoded = read_decoded_image(image.source, DecodeLimits{});
  Diagnostics found;
  for (const Diagnostic& problem : decoded.diagnostics.list())
    found.warning(image.span,
                  fmt::format("texture {}{}", problem.message, decoded ? "" : "; it is magenta"));
  Result<std::string> encoded = encode_samples(
      decoded ? *decoded : magenta_texel(image.name.ends_with(".exr")), image.channel);
  if (encoded) return {std::move(*encoded), std::move(found)};
  return failure(fmt::format("'{}' cannot be converted: {}", image.source,
                             encoded.diagnostics.list()[0].message));
}

Result<std::string> make_sky(const pbrt::WrittenSky& sky,
                             const description::SceneDescription& scene) {
  Image image(sky.side, sky.side, {"R", "G", "B"});
  TextureStore textures;
  Diagnostics known;  // compile() has said them
  const auto environment =
      compile_environment(scene.lights[sky.light], scene.images, textures, known);
  Diagnostics broken = textures.broken_lights();
  if (broken.has_errors()) return broken;
  if (environment)
    parallel_for(static_cast<std::size_t>(sky.side), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < sky.side; ++x) {
        const Rgb mean = pixel_mean(sky, *environment, textures, x, y);
        for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = mean[c];
      }
    });
  WriteOptions options;
  options.metadata = {{"DateTime", undated}};
  return encode_image(ImageFormat::Exr, image, options);
}

}  // namespace candela::cli
