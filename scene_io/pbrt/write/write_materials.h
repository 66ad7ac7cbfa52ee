// MakeNamedMaterial directives, each made when a shape first asks for it.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "scene_io/pbrt/write/write_textures.h"

namespace candela::pbrt {

class MaterialWriter {
 public:
  MaterialWriter(WriteContext& context, TextureWriter& textures)
      : context_(context), textures_(textures) {}

  // The name of a material on surfaces where heights of 1 are `height_unit` long in the world.
  [[nodiscard]] std::string name_of(description::MaterialHandle material, double height_unit);
  // What pbrt keeps with the shape: where the surface has holes.
  void add_alpha(const description::Material& material, Directive& shape);

  // All directives so far.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string make(const description::Material& material, double height_unit);
  Directive mixture(const std::string& name, const description::MixMaterial& mix,
                    double height_unit);
  bool has_heights(const description::Material& material);
  void add_surface(const description::Material& material, double height_unit, Directive& out);

  WriteContext& context_;
  TextureWriter& textures_;
  std::string text_;
  std::map<std::pair<std::uint32_t, double>, std::string> names_;
};

// Has heights in edges of the uv square, which are lengths on each shape, or a part of it has.
[[nodiscard]] bool has_heights_by_uv(const description::SceneDescription& scene,
                                     const description::Material& material);
// Looks anything up by texture coordinates, or a part of it does.
[[nodiscard]] bool is_textured(const description::SceneDescription& scene,
                               const description::Material& material);

}  // namespace candela::pbrt
