// Compiled lights in normalised space, and what sampling one of them gives.
// One file a kind beside this one; sample_light.h switches over them, light_sampler.h picks among
// them, make_light.h makes them.
#pragma once

#include <cstdint>

#include "renderer/math/ray.h"
#include "renderer/math/vec.h"
#include "renderer/texture/texture.h"

namespace candela {

enum class LightKind : std::uint8_t {
  Point,
  Spot,
  Directional,
  Triangle,
  Environment,
  TexturedTriangle,  // as Triangle, which stands for both where nothing else is said
  Goniometric,       // a point with an image of intensities by direction
  Projection,        // a point that projects an image
  Sphere,            // evenly or, with a texture, by place
  Quad,              // two triangles that are one parallelogram: picked in their place
  NearTriangle,      // as Triangle, but sampled by solid angle from near
};

// Which kinds a scene has: kernels specialised on a set leave the others out of their switches.
using LightKindSet = std::uint32_t;
constexpr LightKindSet light_kind_bit(LightKind kind) {
  return 1u << static_cast<unsigned>(kind);
}
inline constexpr LightKindSet all_light_kinds = 0x7ff;

struct Light {
  static constexpr std::uint32_t none = 0xffffffffu;

  LightKind kind = LightKind::Point;
  // Triangle, Quad, Sphere; else only the side of edge1 x edge2, or of the sphere's normal
  bool emits_both_sides = false;
  bool faces_inwards = false;  // Sphere: its normal
  // Point, Spot, Goniometric, Projection: position; Directional: unit direction towards the light;
  // Triangle: vertex 0; Quad: a corner; Sphere: its centre
  Vec3f position{0};
  // Triangle: v1 - v0;  Quad: to a neighbour of the corner;  Sphere: (radius, 0, 0);  Spot: unit
  // axis outwards;  Goniometric, Projection: the map's x axis
  Vec3f edge1{0};
  // Triangle: v2 - v0;  Quad: to the other neighbour;  Goniometric, Projection: the map's y axis
  Vec3f edge2{0};
  // Point, Spot, Goniometric, Projection: radiant intensity; Directional: irradiance; Triangle,
  // Quad, Sphere: radiance
  Rgb emission{0};
  // TexturedTriangle, Sphere, Goniometric, Projection: a factor of the emission (Sphere,
  // Goniometric: absent where it is 1), and the mean luminance of both over the surface or over all
  // directions
  TextureHandle texture{};
  float mean_luminance = 0;
  // Spot: 1 - cos of the angles, which narrow cones need: 1 - cos(0.01 degrees) is half an ulp of 1
  float versine_inner = 0;
  float versine_outer = 0;
  // Triangle, Quad: unit, of edge1 x edge2, and a bound of the error along it of points on it;
  // Goniometric, Projection: the map's z axis
  Vec3f normal{0, 0, 1};
  float offset = 0;   // Sphere: the same in any direction
  float area = 0;     // Triangle, Quad, Sphere; > 0
  float length1 = 0;  // Quad: of edge1
  float length2 = 0;  // Quad: of edge2
  // Quad: points whose squared distance from its middle is below this see it sampled by solid
  // angle. Triangles for which near_triangle.cpp decides that, by the next: infinity.
  float near_distance2 = 0;
  float triangle_near_distance2 = 0;
  // Triangle, Quad, Sphere: where it lies, for its shadow ray's end
  std::uint32_t geometry = none;
  std::uint32_t triangle = 0;  // or sphere
  // Triangle: the quad that is picked in its place;  NearTriangle, and TexturedTriangle if sampled
  // so: itself
  std::uint32_t quad = none;

  // Delta lights have no area: only next-event estimation sees them.
  [[nodiscard]] bool is_delta() const {
    return kind == LightKind::Point || kind == LightKind::Spot || kind == LightKind::Directional ||
           kind == LightKind::Goniometric || kind == LightKind::Projection;
  }
};

// A direction towards a light from a surface. pdf 0: there is none, and nothing is lost by that.
struct LightSample {
  Vec3f wi{0};      // unit
  Rgb radiance{0};  // arriving along wi if nothing is in the way; delta lights: irradiance
                    // on a surface that faces them (pdf is 1)
  float pdf = 0;    // solid angle, given the light was chosen; 1 for delta lights; 0: no sample
  bool is_delta = false;
  // What this ray meets shades the light. It starts just off the surface; where the light is finite
  // its direction is not unit but goes to just off the light, at t = 1.
  Ray shadow_ray;

  [[nodiscard]] bool is_valid() const { return pdf > 0; }
};

}  // namespace candela
