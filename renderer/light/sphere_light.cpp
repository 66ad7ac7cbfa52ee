#include "renderer/light/sphere_light.h"

#include "renderer/light/image_radiance.h"
#include "renderer/light/sphere_cone.h"
#include "renderer/sampling/warp.h"

namespace candela {
namespace {

float pdf_by_area(const Light& light, const Vec3f& direction, const Vec3f& wi, double distance2) {
  const double projected_area =
      std::abs(static_cast<double>(dot(direction, wi))) * static_cast<double>(light.area);
  if (!(projected_area > 0)) return 0;
  const double pdf = distance2 / projected_area;
  return pdf <= std::numeric_limits<float>::max() ? static_cast<float>(pdf) : 0.0f;
}

LightSample sample_of(const Light& light, const std::vector<Geometry>& geometries,
                      const TextureStore& textures, const SurfacePoint& from,
                      const Vec3f& direction, const Vec3f& wi, float pdf) {
  if (!(pdf > 0)) return {};
  const Rgb radiance = sphere_light_radiance(light, geometries, textures, direction, -wi);
  if (is_black(radiance)) return {};
  return {.wi = wi,
          .radiance = radiance,
          .pdf = pdf,
          .shadow_ray = shadow_segment_to_sphere(light, from, direction, wi)};
}

LightSample sample_from_within(const Light& light, const std::vector<Geometry>& geometries,
                               const TextureStore& textures, const SurfacePoint& from, Vec2f u) {
  const Vec3f direction = square_to_uniform_sphere(u);
  const Vec3d to_light = Vec3d(light.position + direction * light.edge1.x) - Vec3d(from.position);
  const double distance2 = length_squared(to_light);
  if (!(distance2 > 0)) return {};
  const Vec3f wi(to_light / std::sqrt(distance2));
  return sample_of(light, geometries, textures, from, direction, wi,
                   pdf_by_area(light, direction, wi, distance2));
}

}  // namespace

Rgb sphere_light_radiance(const Light& light, const std::vector<Geometry>& geometries,
                          const TextureStore& textures, Vec3f direction, Vec3f wo) {
  const Rgb radiance = plain_sphere_radiance(light, direction, wo);
  if (!light.texture || is_black(radiance)) return radiance;
  const Sphere& sphere = geometries[light.geometry].spheres[light.triangle];
  return radiance * image_radiance(textures, light.texture, sphere_uv(sphere, direction));
}

float sphere_light_pdf(const Light& light, Vec3f direction, Vec3f wi, float distance) {
  // From the point that looks to the centre, by what is near: no position cancels.
  const Vec3d to_centre =
      Vec3d(wi) * static_cast<double>(distance) - Vec3d(direction) * radius_of(light);
  const double distance2 = length_squared(to_centre);
  if (is_within(light, distance2))
    return pdf_by_area(light, direction, wi, square(static_cast<double>(distance)));
  if (dot(direction, wi) > 0) return 0;
  return SphereCone(radius_of(light), distance2).pdf();
}

LightSample sample_sphere_light(const Light& light, const std::vector<Geometry>& geometries,
                                const TextureStore& textures, const SurfacePoint& from, Vec2f u) {
  const Vec3d to_centre = to_centre_of(light, from);
  const double distance2 = length_squared(to_centre);
  if (is_within(light, distance2)) return sample_from_within(light, geometries, textures, from, u);
  const ConeSample cone = sample_sphere_cone(radius_of(light), to_centre, distance2, u);
  return sample_of(light, geometries, textures, from, cone.direction, cone.wi, cone.pdf);
}

}  // namespace candela
