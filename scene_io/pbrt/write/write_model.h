// The model of a material as pbrt's nearest type, with candela's own beside it where that is not
// the same.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene_io/pbrt/write/write_textures.h"

namespace candela::pbrt {

// A "MakeNamedMaterial" with its type and the model's parameters.
struct WrittenModel {
  Directive directive;
  std::vector<Directive> parts;  // named by it, where it is a mixture

  // Not explicit: most models are one directive.
  WrittenModel(Directive whole) : directive(std::move(whole)) {}
};

// Says by a warning what is lost for pbrt.
[[nodiscard]] WrittenModel write_model(const std::string& name,
                                       const description::Material& material, WriteContext& context,
                                       TextureWriter& textures);

}  // namespace candela::pbrt
