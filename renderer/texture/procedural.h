// Textures that are made of others: image maps moved and scaled, products, mixtures, patterns.
//
// Values may lie above 1, but for images of reflectance; materials clamp what they read. Alpha goes
// along as a fourth number, 1 where nothing else says it. What of uv is not finite counts as 0.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/base/handle.h"
#include "renderer/description/scene_description.h"
#include "renderer/math/vec.h"
#include "renderer/texture/texture_point.h"

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
  Image,    // factor * inputs[0], inverted or not, clamped or not
  Alpha,    // of input 0, as a grey
  Mean,     // of the colours of input 0, as a grey
  Product,  // of inputs 0 and 1
  SquareRoot,
  Mix,           // from input 0 to input 1 by input 2
  DirectionMix,  // from input 1 to input 0 by the cosine of the normal and `direction`
  Checkerboard,
  SolidCheckerboard,
  Dots,      // input 0 inside, 1 outside
  Bilinear,  // inputs' constants: v00, v01, v10, v11
};

// An affine map of normalised space: p' = x*p.x + y*p.y + z*p.z + t.
struct PlaceMap {
  Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, translation{0};

  [[nodiscard]] Vec3f operator()(const Vec3f& p) const {
    return x * p.x + y * p.y + z * p.z + translation;
  }
};

struct Procedural {
  ProceduralKind kind = ProceduralKind::Image;
  description::MappingKind mapping = description::MappingKind::Surface;
  Vec2f uv_scale{1};  // where it looks: uv * scale + offset
  Vec2f uv_offset{0};
  float factor = 1;
  bool is_inverted = false;
  bool is_reflectance = false;  // of an image: in [0, 1]
  PlaceMap place{};             // SolidCheckerboard, and mappings by place
  Vec3f direction{0};           // DirectionMix; unit
  std::array<TextureValue, 4> inputs{};

  // Whether it looks at more than uv, its inputs aside.
  [[nodiscard]] bool is_by_place() const {
    return mapping != description::MappingKind::Surface || kind == ProceduralKind::DirectionMix ||
           kind == ProceduralKind::SolidCheckerboard;
  }
};

[[nodiscard]] Vec4f evaluate_procedural(const Procedural& procedural, const TextureStore& textures,
                                        const TexturePoint& at);

}  // namespace candela
