#include "renderer/accel/alpha_test.h"

#include <bit>

#include "renderer/sampling/hash.h"
#include "renderer/scene/met_point.h"

namespace candela {
namespace {

constexpr int alpha_channel = 3;

// Both zeros alike.
std::uint32_t bits_of(float x) {
  return std::bit_cast<std::uint32_t>(x + 0.0f);
}
std::uint64_t bits_of(float high, float low) {
  return (std::uint64_t{bits_of(high)} << 32) | bits_of(low);
}

// Uniform in [0, 1), a function of every bit of the ray and of the triangle. The samplers' hashes
// see pixel, sample and dimension, never a ray, so what is decided here is independent of them.
float uniform_of(const Vec3f& origin, const Vec3f& direction, std::uint32_t geometry,
                 std::uint32_t triangle, std::uint32_t instance) {
  std::uint64_t h = mix_bits(bits_of(origin.x, origin.y) ^ 0x6a09e667f3bcc908ull);
  h = hash_combine(h, bits_of(origin.z, direction.x));
  h = hash_combine(h, bits_of(direction.y, direction.z));
  h = hash_combine(h, (std::uint64_t{geometry} << 32) | triangle);
  h = hash_combine(h, instance);
  return unit_float(static_cast<std::uint32_t>(h >> 32));
}

float value_at(const TextureStore& textures, const ScalarParameter& opacity,
               const TexturePoint& at) {
  if (!opacity.texture) return opacity.constant;
  return opacity.channel == alpha_channel
             ? textures.lookup_alpha_at(opacity.texture, at)
             : textures.lookup_at(opacity.texture, at)[opacity.channel];
}

// What the grid knows without a look at the map.
Coverage grid_coverage(const Scene& scene, const Material& material, Vec2f uv) {
  if (!material.coverage_grid) return Coverage::Partial;
  return scene.coverage_grids[material.coverage_grid.index].at(uv);
}

// Where the triangle is met, as the opacity looks at it.
TexturePoint point_at(const Scene& scene, const Hit& hit, Vec2f uv,
                      const ScalarParameter& opacity) {
  if (!opacity.texture || !scene.textures.is_by_place(opacity.texture)) return {.uv = uv};
  const SurfacePoint met = met_point(scene, hit, Vec3f(0, 0, 1));
  return {uv, met.position, met.geometric_normal};
}

// Whether a ray that meets a sphere there goes out of it.
bool leaves_sphere(const Scene& scene, const Hit& hit, const Vec3f& direction) {
  const Vec3f normal = from_octahedron({hit.u, hit.v});
  return dot(hit.is_instanced() ? scene.instances[hit.instance].normal(normal) : normal,
             direction) > 0;
}

// Where the grid says nothing; lab3's thresholds applied where the material asks.
float mapped_opacity_at(const Scene& scene, const Material& material, const TexturePoint& at) {
  const float alpha = value_at(scene.textures, material.opacity, at);
  const Coverage coverage = coverage_of_range(alpha, alpha, material.lab_opacity);
  if (coverage != Coverage::Partial) return coverage == Coverage::Opaque ? 1 : 0;
  return alpha;
}

}  // namespace

bool is_transparent_at(const Scene& scene, std::uint32_t geometry, std::uint32_t triangle,
                       std::uint32_t instance, float u, float v, const Vec3f& ray_origin,
                       const Vec3f& ray_direction) {
  const Geometry& surface = scene.geometries[geometry];
  if (!surface.has_cutouts) return false;
  const Material& material = scene.materials[surface.material.index];
  const Vec2f uv = uv_at(surface, triangle, u, v);
  const Coverage coverage = grid_coverage(scene, material, uv);
  if (coverage != Coverage::Partial) return coverage == Coverage::Clear;
  const Hit hit{.u = u, .v = v, .geometry = geometry, .triangle = triangle, .instance = instance};
  const float opacity =
      mapped_opacity_at(scene, material, point_at(scene, hit, uv, material.opacity));
  if (opacity <= 0) return true;
  if (opacity >= 1) return false;
  // A ray meets a sphere twice, and each time something else is decided.
  const bool is_far_side = !surface.spheres.empty() && leaves_sphere(scene, hit, ray_direction);
  const std::uint32_t primitive = is_far_side ? ~triangle : triangle;
  return uniform_of(ray_origin, ray_direction, geometry, primitive, instance) >= opacity;
}

}  // namespace candela
