// Textures that are made of others: image maps moved and scaled, products, mixtures, patterns.
//
// Values may lie above 1; materials clamp what they read. Alpha goes along as a fourth number, 1
// where nothing else says it. What of uv is not finite counts as 0.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/base/handle.h"
#include "renderer/math/vec.h"

namespace candela {

class Texture;
class TextureStore;
using TextureHandle = Handle<Texture>;

// A texture, or a constant where there is none.
struct TextureValue {
  Vec4f constant{1};
  TextureHandle texture{};
};

enum class ProceduralKind : std::uint8_t {
  Image,    // factor * inputs[0], inverted or not
  Product,  // of inputs 0 and 1
  Mix,      // from input 0 to input 1 by input 2
  Checkerboard,
  Dots,      // input 0 inside, 1 outside
  Bilinear,  // inputs' constants: v00, v01, v10, v11
};

struct Procedural {
  ProceduralKind kind = ProceduralKind::Image;
  Vec2f uv_scale{1};  // where it looks: uv * scale + offset
  Vec2f uv_offset{0};
  float factor = 1;
  bool is_inverted = false;
  std::array<TextureValue, 4> inputs{};
};

[[nodiscard]] Vec4f evaluate_procedural(const Procedural& procedural, const TextureStore& textures,
                                        Vec2f uv);

}  // namespace candela
