// SceneDescription -> a pbrt-v4 scene: the text, the meshes' PLY files, and which images belong
// beside it. No image is opened here: who can open them tells what they hold and makes the files.
//
// What pbrt has no word for is written as the nearest that it has, with a warning that names it,
// and for candela beside it exactly (scene_io/pbrt/token.h): the scene that candela reads from the
// file is the one that was written. docs/pbrt.md lists what is lost for pbrt.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"

namespace candela::pbrt {

// What an image file holds.
struct ImageFacts {
  int width = 0;
  int height = 0;
  int channels = 0;
  int alpha_channel = -1;  // none
  bool is_float = false;   // else integers
};

struct WriteOptions {
  std::string folder;      // of meshes and images, relative to the scene file; no '/' at its end
  std::string picture;     // the file that pbrt is to write
  std::size_t camera = 0;  // of several cameras; pbrt has one
  // Nothing where a file cannot be read, as where this is not given.
  std::function<std::optional<ImageFacts>(const std::string& path)> image_facts;
};

struct WrittenFile {
  std::string name;  // relative to the scene file
  std::string bytes;
};
// An image to be made of one that the scene names.
struct WrittenImage {
  static constexpr int all_channels = -1;
  std::string name;  // ends with .png or .exr, or what the source's name ends with
  std::string source;
  int channel = all_channels;  // else a grey image of this one
  bool is_copied = false;  // the source's bytes; else its samples as they are in a PNG or EXR file
  SourceSpan span = {};    // where the scene names it
};
// An image of equal areas to be made of one of the scene's skies: pbrt takes no other.
struct WrittenSky {
  std::string name;
  int side = 0;               // in pixels
  Mat3d world_from_sky{1.0};  // the image's own axes (description/: EqualAreaEnvironment)
  std::size_t light = 0;      // of the scene
};

struct WrittenScene {
  std::string text;
  std::vector<WrittenFile> meshes;
  std::vector<WrittenImage> images;
  std::vector<WrittenSky> skies;
};

// The same bytes for the same scene. Errors are those of description/validate.h. What the scene's
// defaults do not say is what readers take it for: `filter` and `filter_radius` belong there.
// Warnings are of what is lost for pbrt.
[[nodiscard]] Result<WrittenScene> write_pbrt(const description::SceneDescription& scene,
                                              const WriteOptions& options);

}  // namespace candela::pbrt
