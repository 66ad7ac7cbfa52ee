#include "renderer/texture/procedural.h"

#include <bit>
#include <cmath>

#include "renderer/sampling/hash.h"
#include "renderer/texture/texture.h"

namespace candela {
namespace {

float finite_or_zero(float x) {
  return std::isfinite(x) ? x : 0.0f;
}

Vec4f value_of(const TextureValue& input, const TextureStore& textures, Vec2f uv) {
  return input.texture ? textures.lookup(input.texture, uv) : input.constant;
}

Vec4f image_value(const Procedural& p, const Vec4f& texel) {
  const auto value = [&](float x) {
    const float scaled = p.factor * x;
    return p.is_inverted ? std::max(0.0f, 1 - scaled) : scaled;
  };
  return {value(texel.x), value(texel.y), value(texel.z), texel.w};
}

// Whether a whole number is odd; numbers from 2^24 on are even.
bool is_odd(float whole) {
  const float half = 0.5f * whole;
  return half != std::floor(half);
}

bool is_on_odd_square(Vec2f place) {
  return is_odd(std::floor(place.x)) != is_odd(std::floor(place.y));
}

// A dot of radius 0.35 in every other cell by chance, moved so that it stays within its cell.
bool is_in_dot(Vec2f place) {
  constexpr float radius = 0.35f;
  constexpr float room = 0.5f - radius;
  const Vec2f cell{std::floor(place.x + 0.5f), std::floor(place.y + 0.5f)};
  const std::uint64_t bits =
      mix_bits((std::uint64_t{std::bit_cast<std::uint32_t>(cell.x + 0.0f)} << 32) |
               std::bit_cast<std::uint32_t>(cell.y + 0.0f));
  if ((bits & 1) != 0) return false;
  const auto shift = [](std::uint64_t number) {
    return room * (2 * unit_float(static_cast<std::uint32_t>(number)) - 1);
  };
  const std::uint64_t more = mix_bits(bits);
  const Vec2f from_centre = place - cell - Vec2f(shift(more), shift(more >> 32));
  return dot(from_centre, from_centre) < radius * radius;
}

Vec4f bilinear(const std::array<TextureValue, 4>& corners, Vec2f at) {
  return corners[0].constant * ((1 - at.x) * (1 - at.y)) +
         corners[1].constant * ((1 - at.x) * at.y) + corners[2].constant * (at.x * (1 - at.y)) +
         corners[3].constant * (at.x * at.y);
}

}  // namespace

Vec4f evaluate_procedural(const Procedural& procedural, const TextureStore& textures, Vec2f uv) {
  const std::array<TextureValue, 4>& inputs = procedural.inputs;
  const Vec2f moved = uv * procedural.uv_scale + procedural.uv_offset;
  const Vec2f place{finite_or_zero(moved.x), finite_or_zero(moved.y)};
  switch (procedural.kind) {
    case ProceduralKind::Image:
      return image_value(procedural, value_of(inputs[0], textures, place));
    case ProceduralKind::Product:
      return value_of(inputs[0], textures, uv) * value_of(inputs[1], textures, uv);
    case ProceduralKind::Mix: {
      const Vec4f amount = value_of(inputs[2], textures, uv);
      return (Vec4f(1) - amount) * value_of(inputs[0], textures, uv) +
             amount * value_of(inputs[1], textures, uv);
    }
    case ProceduralKind::Checkerboard:
      return value_of(inputs[is_on_odd_square(place) ? 1 : 0], textures, uv);
    case ProceduralKind::Dots:
      return value_of(inputs[is_in_dot(place) ? 0 : 1], textures, uv);
    case ProceduralKind::Bilinear:
      return bilinear(inputs, place);
  }
  return Vec4f(0);
}

}  // namespace candela
