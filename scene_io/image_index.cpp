#include "scene_io/image_index.h"

#include <utility>

namespace candela {

description::ImageHandle ImageIndex::add(description::Image image,
                                         description::SceneDescription& scene) {
  auto& images = scene.images;
  const auto key_of = [](const description::Image& of) {
    return Key{of.path, of.encoding, of.wrap};
  };
  for (; count_ < images.size(); ++count_)
    known_.try_emplace(key_of(images[count_]), description::ImageHandle(count_));
  const auto [at, is_new] =
      known_.try_emplace(key_of(image), description::ImageHandle(images.size()));
  if (is_new) {
    images.push_back(std::move(image));
    ++count_;
  }
  return at->second;
}

}  // namespace candela
