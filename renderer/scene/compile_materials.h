// description::Material -> Material: colours decoded to linear floats, textures registered, models
// reduced to the simplest that gives the same picture.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <tuple>

#include "renderer/bsdf/coated_metal_table.h"
#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/compile_textures.h"
#include "renderer/scene/scene.h"

namespace candela {

// Tables that materials share: made once for each coat, and for each metal under one.
class CoatTables {
 public:
  // As the constructor of CoatTable takes it.
  [[nodiscard]] std::shared_ptr<const CoatTable> table(float eta, float thickness, float alpha);
  // As that of CoatedMetalTable takes it; the coat's table is one of these.
  [[nodiscard]] std::shared_ptr<const CoatedMetalTable> metal(const Bsdf& bsdf,
                                                              const CoatedMetalLayers& layers);

 private:
  // The coat, and eta, k and the widths of the metal.
  using MetalKey = std::tuple<const CoatTable*, int, std::array<float, 9>>;

  std::map<std::array<float, 3>, std::shared_ptr<const CoatTable>> tables_;
  std::map<MetalKey, std::shared_ptr<const CoatedMetalTable>> metals_;
};

// `unit`: a length of 1 in the file (Normalisation::scale).
[[nodiscard]] Material compile_material(const description::Material& material,
                                        const CompileOptions& options, double unit,
                                        TextureCompiler& texture, CoatTables& coats);

// Adds what the material needs of a kernel.
void add_features(const Material& material, SceneFeatures& features);

}  // namespace candela
