// Finds the images of a scene again, so that readers add each of them once.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "renderer/description/scene_description.h"

namespace candela {

// Of one scene, to which others may append images as well.
class ImageIndex {
 public:
  // Adds an image, or finds the equal one that is there.
  [[nodiscard]] description::ImageHandle add(description::Image image,
                                             description::SceneDescription& scene);

 private:
  using Key = std::tuple<std::string, description::Encoding, description::Wrap>;

  std::map<Key, description::ImageHandle> known_;
  std::size_t count_ = 0;  // of the scene's images in it
};

}  // namespace candela
