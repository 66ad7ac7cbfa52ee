// The images beside a converted scene: copied, or their samples as they are in another format, and
// the sky as an image of equal areas.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"
#include "scene_io/pbrt/write/write_pbrt.h"

namespace candela::cli {

// Nothing where the file cannot be read.
[[nodiscard]] std::optional<pbrt::ImageFacts> image_facts(const std::string& path);

// The bytes of the file to write. Errors name the source.
[[nodiscard]] Result<std::string> make_image(const pbrt::WrittenImage& image);

// The bytes of an EXR file with the mean of the scene's light of that number over each pixel; black
// where it is no environment.
[[nodiscard]] Result<std::string> make_sky(const pbrt::WrittenSky& sky,
                                           const description::SceneDescription& scene);

}  // namespace candela::cli
