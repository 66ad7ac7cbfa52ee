// description's textures -> the texture store: images and textures registered as they are first
// used; what is constant becomes a constant, what only names an image that image.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "renderer/texture/texture.h"

namespace candela {

class TextureCompiler {
 public:
  // `world_from_normalised`: of the scene that is compiled. All must outlive it. The scene was
  // validated.
  TextureCompiler(const description::SceneDescription& scene, TextureStore& store,
                  Diagnostics& diagnostics, const Transform& world_from_normalised = {})
      : scene_(scene),
        store_(store),
        diagnostics_(diagnostics),
        world_from_normalised_(world_from_normalised),
        compiled_(scene.textures.size()) {}

  [[nodiscard]] TextureStore& store() const { return store_; }
  // Invalid for an invalid handle.
  [[nodiscard]] TextureHandle image(description::ImageHandle image);
  [[nodiscard]] TextureHandle light_image(description::ImageHandle image);
  // An image as one number (description::alpha_or_mean): this channel of that texture.
  struct Scalar {
    TextureHandle texture;
    int channel = 0;
  };
  [[nodiscard]] Scalar scalar(description::ImageHandle image);
  [[nodiscard]] TextureValue texture(description::TextureHandle texture);
  [[nodiscard]] const Transform& world_from_normalised() const { return world_from_normalised_; }
  // A constant, an image or a texture.
  [[nodiscard]] TextureValue input(const description::ColourInput& input);
  // The same as an input of another texture: colours of images end at 1.
  [[nodiscard]] TextureValue inner_input(const description::ColourInput& input);

 private:
  [[nodiscard]] bool is_colour_image(const description::ColourInput& input) const;
  [[nodiscard]] TextureValue added(const Procedural& procedural);

  const description::SceneDescription& scene_;
  TextureStore& store_;
  Diagnostics& diagnostics_;
  Transform world_from_normalised_;
  std::vector<std::optional<TextureValue>> compiled_;
  std::map<std::size_t, TextureHandle> means_;    // by the image's texture
  std::map<std::size_t, TextureHandle> clamped_;  // likewise
};

}  // namespace candela
