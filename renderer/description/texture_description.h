// Images and textures of a scene: functions of the surface's uv, place and normal, made of image
// files, constants and each other.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "renderer/base/diagnostic.h"
#include "renderer/base/handle.h"
#include "renderer/math/transform.h"
#include "renderer/math/vec.h"

namespace candela::description {

struct Image;
struct Texture;
using ImageHandle = Handle<Image>;
using TextureHandle = Handle<Texture>;

// How stored numbers become linear ones.
enum class Encoding : std::uint8_t {
  Linear,    // as stored (masks, heights, HDR)
  Srgb,      // IEC 61966-2-1 a texel, before filtering
  Gamma22,   // pow(v, 2.2) a texel, before filtering
  LabGamma,  // the same after filtering, as lab3's framework does
};

enum class Wrap : std::uint8_t { Repeat, Clamp, Mirror, Black };

// An image file, not opened yet. Equal files with equal settings are one entry.
struct Image {
  std::string path;
  Encoding encoding = Encoding::Linear;
  Wrap wrap = Wrap::Repeat;
  SourceSpan span;  // where the scene names it
};

// A factor, or a map or texture (one of the two) that replaces it. A map as input of a texture is
// an ImageTexture of a colour.
struct ColourInput {
  Vec3d factor{1.0};
  ImageHandle map;
  TextureHandle texture{};

  [[nodiscard]] bool is_constant() const { return !map && !texture; }
};
inline constexpr int alpha_or_first = -1;
// As pbrt: alpha where the file has one that is below 1 anywhere, else the mean of its colours.
inline constexpr int alpha_or_mean = -2;
struct ScalarInput {
  double factor = 1.0;
  ImageHandle map;
  // Of the map; alpha_or_first: alpha where the file has one, else channel 0; or alpha_or_mean.
  int channel = 0;
  TextureHandle texture{};

  [[nodiscard]] bool is_constant() const { return !map && !texture; }
  bool operator==(const ScalarInput&) const = default;
};

// What a texture takes for u and v: the surface's own, or those of a place in a space of its own.
enum class MappingKind : std::uint8_t {
  Surface,
  Planar,       // x and y
  Spherical,    // the angle from z over pi, that about z from x over 2 pi
  Cylindrical,  // that about z from -x over 2 pi, and z
};

// Where a texture looks: (u, v) * scale + offset.
struct UvMapping {
  Vec2d scale{1.0};
  Vec2d offset{0.0};
  MappingKind kind = MappingKind::Surface;
  Transform place_from_world = {};  // but for Surface
};

// factor * texel, or 1 minus that (at least 0) where it is inverted. Colours are those of what
// reflects: in [0, 1], before other textures have them; numbers may be any.
struct ImageTexture {
  ImageHandle image;
  UvMapping mapping{};
  double factor = 1.0;
  bool is_inverted = false;
  bool is_scalar = false;  // the texel is one number, as alpha_or_mean says
};
struct ProductTexture {
  ColourInput first;
  ColourInput second;
};
// Of each channel; what is below 0 counts as 0.
struct SquareRootTexture {
  ColourInput input;
};
// (1 - amount) first + amount second, a channel.
struct MixTexture {
  ColourInput first;
  ColourInput second;
  ColourInput amount{Vec3d{0.5}, {}, {}};
};
// |n . direction| first + (1 - |n . direction|) second, n being the unit normal of the triangle.
struct DirectionMixTexture {
  ColourInput first;
  ColourInput second;
  Vec3d direction{0.0, 1.0, 0.0};  // unit
};
// Unit cubes, `even` in the one at the origin.
struct SolidCheckerboardTexture {
  Transform place_from_world;
  ColourInput even{};
  ColourInput odd{Vec3d{0.0}, {}, {}};
};
// Unit squares, `even` on the one at the origin.
struct CheckerboardTexture {
  UvMapping mapping{};
  ColourInput even{};
  ColourInput odd{Vec3d{0.0}, {}, {}};
};
// Dots at random places: one in about half of the unit squares, wholly inside.
struct DotsTexture {
  UvMapping mapping{};
  ColourInput inside{};
  ColourInput outside{Vec3d{0.0}, {}, {}};
};
// Between the unit square's corners: v01 is at u = 0, v = 1. Beyond the square it goes on.
struct BilinearTexture {
  UvMapping mapping{};
  Vec3d v00{0.0}, v01{1.0}, v10{0.0}, v11{1.0};
};

// Inputs are textures that stand before this one in the list.
struct Texture {
  std::string name;
  SourceSpan span;
  std::variant<ImageTexture, ProductTexture, SquareRootTexture, MixTexture, DirectionMixTexture,
               CheckerboardTexture, SolidCheckerboardTexture, DotsTexture, BilinearTexture>
      kind;
};

}  // namespace candela::description
