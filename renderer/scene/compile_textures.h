// description's textures -> the texture store: images and textures registered as they are first
// used; what is constant becomes a constant, what only names an image that image.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "renderer/texture/texture.h"

namespace candela {

class TextureCompiler {
 public:
  // All must outlive it. The scene was validated.
  TextureCompiler(const description::SceneDescription& scene, TextureStore& store,
                  Diagnostics& diagnostics)
      : scene_(scene), store_(store), diagnostics_(diagnostics), compiled_(scene.textures.size()) {}

  [[nodiscard]] TextureStore& store() const { return store_; }
  // Invalid for an invalid handle.
  [[nodiscard]] TextureHandle image(description::ImageHandle image);
  [[nodiscard]] TextureValue texture(description::TextureHandle texture);
  // A constant, an image or a texture.
  [[nodiscard]] TextureValue input(const description::ColourInput& input);

 private:
  [[nodiscard]] TextureValue added(const Procedural& procedural);

  const description::SceneDescription& scene_;
  TextureStore& store_;
  Diagnostics& diagnostics_;
  std::vector<std::optional<TextureValue>> compiled_;
};

}  // namespace candela
