// A description written as a pbrt scene and read again.
#pragma once

#include <string>

#include "renderer/description/scene_description.h"
#include "scene_io/pbrt/write/write_pbrt.h"

namespace candela::test {

struct RoundTrip {
  pbrt::WrittenScene written;
  Diagnostics diagnostics;  // of writing
  description::SceneDescription scene;
};

// `facts` are those of every image. No image is made: the reader opens none. A fault in reading is
// a test failure.
[[nodiscard]] RoundTrip round_trip(const description::SceneDescription& scene,
                                   const pbrt::ImageFacts& facts = {8, 4, 3, -1, false});

}  // namespace candela::test
