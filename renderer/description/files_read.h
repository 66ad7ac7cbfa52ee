// The files that a scene comes from.
#pragma once

#include <string>
#include <vector>

#include "renderer/description/scene_description.h"

namespace candela::description {

// Paths of the scene's texts and meshes, then of its images, whether they are there or not.
[[nodiscard]] inline std::vector<std::string> files_read(const SceneDescription& scene) {
  std::vector<std::string> paths = scene.files;
  for (const Image& image : scene.images) paths.push_back(image.path);
  return paths;
}

}  // namespace candela::description
