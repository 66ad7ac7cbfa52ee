#include "renderer/texture/procedural.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/sampling/hash.h"
#include "renderer/texture/texture.h"

namespace candela {
namespace {

float finite_or_zero(float x) {
  return std::isfinite(x) ? x : 0.0f;
}

Vec4f value_of(const TextureValue& input, const TextureStore& textures, const TexturePoint& at) {
  return input.texture ? textures.lookup_at(input.texture, at) : input.constant;
}

// u and v of a place, by its direction from the origin where they are angles.
Vec2f uv_of_place(description::MappingKind mapping, const Vec3f& p) {
  constexpr float inverse_two_pi = 0.5f * inverse_pi;
  switch (mapping) {
    case description::MappingKind::Surface:
    case description::MappingKind::Planar:
      break;
    case description::MappingKind::Spherical: {
      const float about = arc_tangent(p.y, p.x) * inverse_two_pi;
      return {arc_tangent(std::sqrt(p.x * p.x + p.y * p.y), p.z) * inverse_pi,
              about < 0 ? about + 1 : about};
    }
    case description::MappingKind::Cylindrical:
      return {0.5f + arc_tangent(p.y, p.x) * inverse_two_pi, p.z};
  }
  return {p.x, p.y};
}

// Where a texture looks of its own.
Vec2f place_in(const Procedural& p, const TexturePoint& at) {
  const Vec2f uv = p.mapping == description::MappingKind::Surface
                       ? at.uv
                       : uv_of_place(p.mapping, p.place(at.position));
  const Vec2f moved = uv * p.uv_scale + p.uv_offset;
  return {finite_or_zero(moved.x), finite_or_zero(moved.y)};
}

Vec4f image_value(const Procedural& p, const Vec4f& texel) {
  const auto value = [&](float x) {
    const float scaled = p.factor * x;
    const float shown = p.is_inverted ? std::max(0.0f, 1 - scaled) : scaled;
    return p.is_reflectance ? std::min(std::max(0.0f, shown), 1.0f) : shown;
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

bool is_in_odd_cube(const Vec3f& place) {
  return is_odd(std::floor(finite_or_zero(place.x))) !=
         (is_odd(std::floor(finite_or_zero(place.y))) !=
          is_odd(std::floor(finite_or_zero(place.z))));
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

Vec4f evaluate_procedural(const Procedural& procedural, const TextureStore& textures,
                          const TexturePoint& at) {
  const std::array<TextureValue, 4>& inputs = procedural.inputs;
  const auto mixed = [&](const Vec4f& amount, std::size_t from, std::size_t to) {
    return (Vec4f(1) - amount) * value_of(inputs[from], textures, at) +
           amount * value_of(inputs[to], textures, at);
  };
  switch (procedural.kind) {
    case ProceduralKind::Image: {
      TexturePoint there = at;
      there.uv = place_in(procedural, at);
      return image_value(procedural, value_of(inputs[0], textures, there));
    }
    case ProceduralKind::Alpha:
      return {Vec3f(value_of(inputs[0], textures, at).w), 1};
    case ProceduralKind::Mean: {
      const Vec4f value = value_of(inputs[0], textures, at);
      return {Vec3f((value.x + value.y + value.z) * (1.0f / 3.0f)), 1};
    }
    case ProceduralKind::Product:
      return value_of(inputs[0], textures, at) * value_of(inputs[1], textures, at);
    case ProceduralKind::SquareRoot: {
      const Vec4f value = glm::max(value_of(inputs[0], textures, at), Vec4f(0));
      return {std::sqrt(value.x), std::sqrt(value.y), std::sqrt(value.z), value.w};
    }
    case ProceduralKind::Mix:
      return mixed(value_of(inputs[2], textures, at), 0, 1);
    case ProceduralKind::DirectionMix: {
      const float cosine = std::abs(dot(at.normal, procedural.direction));
      return mixed(Vec4f(std::min(cosine, 1.0f)), 1, 0);
    }
    case ProceduralKind::Checkerboard:
      return value_of(inputs[is_on_odd_square(place_in(procedural, at)) ? 1 : 0], textures, at);
    case ProceduralKind::SolidCheckerboard:
      return value_of(inputs[is_in_odd_cube(procedural.place(at.position)) ? 1 : 0], textures, at);
    case ProceduralKind::Dots:
      return value_of(inputs[is_in_dot(place_in(procedural, at)) ? 0 : 1], textures, at);
    case ProceduralKind::Bilinear:
      return bilinear(inputs, place_in(procedural, at));
  }
  return Vec4f(0);
}

}  // namespace candela
