#include "renderer/light/sphere_light.h"

#include "renderer/light/image_radiance.h"
#include "renderer/math/frame.h"
#include "renderer/sampling/warp.h"

namespace candela {
namespace {

double radius_of(const Light& light) {
  return static_cast<double>(light.edge1.x);
}

// Whether the sphere is sampled by area from a point so far from its centre. What lies on it, to
// the rounding of positions, sees nothing of its outside.
bool is_within(const Light& light, double distance2) {
  return distance2 <= square(radius_of(light) + 4 * static_cast<double>(light.offset));
}

// The cone in which a sphere is seen from `distance2` (squared) from its centre. In double: near
// the sphere the cosine cancels, far from it 1 - cosine would.
struct Cone {
  double sine2;    // of the half angle
  double versine;  // 1 - cosine

  Cone(const Light& light, double distance2) {
    const double radius2 = square(radius_of(light));
    sine2 = radius2 / distance2;
    versine = sine2 / (1 + std::sqrt((distance2 - radius2) / distance2));
  }
  [[nodiscard]] float pdf() const { return static_cast<float>(1 / (2 * pi_double * versine)); }
};

float pdf_by_area(const Light& light, const Vec3f& direction, const Vec3f& wi, double distance2) {
  const double projected_area =
      std::abs(static_cast<double>(dot(direction, wi))) * static_cast<double>(light.area);
  if (!(projected_area > 0)) return 0;
  const double pdf = distance2 / projected_area;
  return pdf <= std::numeric_limits<float>::max() ? static_cast<float>(pdf) : 0.0f;
}

Vec3f point_of(const Light& light, const Vec3f& direction) {
  return light.position + direction * light.edge1.x;
}

LightSample sample_of(const Light& light, const std::vector<Geometry>& geometries,
                      const TextureStore& textures, const SurfacePoint& from,
                      const Vec3f& direction, const Vec3f& wi, float pdf) {
  if (!(pdf > 0)) return {};
  const Rgb radiance = sphere_light_radiance(light, geometries, textures, direction, -wi);
  if (is_black(radiance)) return {};
  const Vec3f end = offset_origin(point_of(light, direction), direction, light.offset, -wi);
  return {.wi = wi, .radiance = radiance, .pdf = pdf, .shadow_ray = shadow_segment(from, wi, end)};
}

LightSample sample_from_within(const Light& light, const std::vector<Geometry>& geometries,
                               const TextureStore& textures, const SurfacePoint& from, Vec2f u) {
  const Vec3f direction = square_to_uniform_sphere(u);
  const Vec3d to_light = Vec3d(point_of(light, direction)) - Vec3d(from.position);
  const double distance2 = length_squared(to_light);
  if (!(distance2 > 0)) return {};
  const Vec3f wi(to_light / std::sqrt(distance2));
  return sample_of(light, geometries, textures, from, direction, wi,
                   pdf_by_area(light, direction, wi, distance2));
}

// A direction at the angle theta from the axis meets the sphere at the angle alpha from the axis as
// its centre sees it [Pharr23, eq. 6.20], where sine2 of theta is `share` of the cone's.
LightSample sample_cone(const Light& light, const std::vector<Geometry>& geometries,
                        const TextureStore& textures, const SurfacePoint& from,
                        const Vec3d& to_centre, double distance2, Vec2f u) {
  const Cone cone(light, distance2);
  const double versine = static_cast<double>(u.x) * cone.versine;
  const double sine2 = versine * (2 - versine);
  const double share = std::min(1.0, sine2 / cone.sine2);
  const double cosine_to_surface = std::sqrt(1 - share);  // of the angle at the point met
  const double sine_alpha =
      std::sqrt(share) * (1 - versine - std::sqrt(cone.sine2) * cosine_to_surface);
  const double cosine_alpha = std::sqrt(cone.sine2) * share + (1 - versine) * cosine_to_surface;
  const Frame frame = frame_from_normal(Vec3f(to_centre / std::sqrt(distance2)));
  const SinCos azimuth = sin_cos_of_turns(u.y);
  const Vec3f across = frame.x * azimuth.cos + frame.y * azimuth.sin;
  const Vec3f wi = normalize(frame.z * static_cast<float>(1 - versine) +
                             across * static_cast<float>(std::sqrt(sine2)));
  const Vec3f direction = normalize(across * static_cast<float>(sine_alpha) -
                                    frame.z * static_cast<float>(cosine_alpha));
  return sample_of(light, geometries, textures, from, direction, wi, cone.pdf());
}

}  // namespace

Rgb sphere_light_radiance(const Light& light, const std::vector<Geometry>& geometries,
                          const TextureStore& textures, Vec3f direction, Vec3f wo) {
  const bool is_outside = dot(direction, wo) > 0;
  if (!light.emits_both_sides && is_outside == light.faces_inwards) return Rgb(0);
  if (!light.texture) return light.emission;
  const Sphere& sphere = geometries[light.geometry].spheres[light.triangle];
  return light.emission * image_radiance(textures, light.texture, sphere_uv(sphere, direction));
}

float sphere_light_pdf(const Light& light, Vec3f direction, Vec3f wi, float distance) {
  // From the point that looks to the centre, by what is near: no position cancels.
  const Vec3d to_centre =
      Vec3d(wi) * static_cast<double>(distance) - Vec3d(direction) * radius_of(light);
  const double distance2 = length_squared(to_centre);
  if (is_within(light, distance2))
    return pdf_by_area(light, direction, wi, square(static_cast<double>(distance)));
  if (dot(direction, wi) > 0) return 0;
  return Cone(light, distance2).pdf();
}

LightSample sample_sphere_light(const Light& light, const std::vector<Geometry>& geometries,
                                const TextureStore& textures, const SurfacePoint& from, Vec2f u) {
  const Vec3d to_centre = Vec3d(light.position) - Vec3d(from.position);
  const double distance2 = length_squared(to_centre);
  if (is_within(light, distance2)) return sample_from_within(light, geometries, textures, from, u);
  return sample_cone(light, geometries, textures, from, to_centre, distance2, u);
}

}  // namespace candela
