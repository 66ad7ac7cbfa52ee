#include "integrators/whitted/lab_lights.h"

#include "renderer/light/make_light.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

// Sums over the triangles of a lamp, in double.
struct LampSums {
  double area = 0;
  double weighted_luminance = 0;  // sum of A times the mean of what it emits
  Vec3d vector_area{0.0};         // sum of A n
  Vec3d largest{0.0};             // A n of the largest
  Vec3d weighted_place{0.0};      // sum of A times the triangle's centre
};

LampSums sums_of(const Scene& scene, const Geometry& geometry) {
  LampSums sums;
  for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
    const Light& triangle = scene.lights[geometry.first_light + i];
    const Vec3d edge1(triangle.edge1), edge2(triangle.edge2);
    const Vec3d vector_area = 0.5 * cross(edge1, edge2);
    const double area = length(vector_area);
    sums.area += area;
    sums.weighted_luminance += area * static_cast<double>(triangle.mean_luminance);
    sums.vector_area += vector_area;
    if (area > length(sums.largest)) sums.largest = vector_area;
    sums.weighted_place += area * (Vec3d(triangle.position) + (edge1 + edge2) / 3.0);
  }
  return sums;
}

// The area that an observer far away along the unit direction `axis` sees shine, were nothing of
// the lamp in front of it.
double projected_area(const Scene& scene, const Geometry& geometry, const Vec3d& axis) {
  double sum = 0;
  for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
    const Light& triangle = scene.lights[geometry.first_light + i];
    const double seen = 0.5 * dot(cross(Vec3d(triangle.edge1), Vec3d(triangle.edge2)), axis);
    sum += triangle.emits_both_sides ? std::abs(seen) : std::max(seen, 0.0);
  }
  return sum;
}

// The area that shines far away along the lamp's axis: the direction of the vector area, or of the
// normal of a flat lamp whose triangles face opposite ways, towards the brighter side. A closed
// surface has none, so the mean over all directions counts, which is a quarter of the area
// whichever sides shine: the inner one is not seen from outside [Cauchy1850].
double seen_area_of(const Scene& scene, const Geometry& geometry, const LampSums& sums) {
  constexpr double negligible = 1e-3;  // of the area; rounding leaves some 1e-7
  const double axis_length = length(sums.vector_area);
  if (axis_length > negligible * sums.area)
    return projected_area(scene, geometry, sums.vector_area / axis_length);
  const Vec3d normal = normalize(sums.largest);
  const double front = projected_area(scene, geometry, normal);
  const double back = projected_area(scene, geometry, -normal);
  const bool emits_both_sides = scene.lights[geometry.first_light].emits_both_sides;
  const double whole = emits_both_sides ? front : front + back;
  return whole > (1 - negligible) * sums.area ? std::max(front, back) : 0.25 * sums.area;
}

// Of the light of a lamp's surface, what its constant opacity leaves; a map's holes are left out.
float opacity_of(const Scene& scene, std::uint32_t geometry) {
  const Material& material = scene.materials[scene.geometries[geometry].material.index];
  return material.opacity.texture ? 1.0f : material.opacity.constant;
}

// A surface of radiance L sends the radiant intensity L times its projected area.
Light lamp_light(const Scene& scene, std::uint32_t index) {
  const Geometry& geometry = scene.geometries[index];
  const Light& first = scene.lights[geometry.first_light];
  const LampSums sums = sums_of(scene, geometry);
  const double seen_area = seen_area_of(scene, geometry, sums);
  Vec3d radiance(first.emission);
  if (first.texture)  // of its factor's colour, as bright as the mean
    radiance *= sums.weighted_luminance / sums.area / luminance(radiance);
  const Rgb intensity(radiance * (seen_area / pi_double * double{opacity_of(scene, index)}));
  Light light = make_point_light(Vec3f(sums.weighted_place / sums.area), intensity);
  light.geometry = index;
  return light;
}

// A sphere from afar: its radiance times the disc that it shows.
Light sphere_lamp_light(const Scene& scene, const Light& sphere) {
  Rgb radiance = sphere.emission;
  if (sphere.texture) radiance *= sphere.mean_luminance / luminance(radiance);
  const float seen_area = 0.25f * sphere.area * opacity_of(scene, sphere.geometry);
  Light light = make_point_light(sphere.position, radiance * (seen_area / pi));
  light.geometry = sphere.geometry;
  light.triangle = sphere.triangle;
  return light;
}

}  // namespace

std::vector<Light> lab_lights(const Scene& scene) {
  std::vector<Light> lights;
  for (const Light& light : scene.lights) {
    if (light.kind == LightKind::Sphere) lights.push_back(sphere_lamp_light(scene, light));
    if (!light.is_delta()) continue;
    lights.push_back(light);
    lights.back().emission /= pi;
  }
  for (std::size_t i = 0; i < scene.geometries.size(); ++i)
    if (scene.geometries[i].is_emissive() && scene.geometries[i].spheres.empty())
      lights.push_back(lamp_light(scene, static_cast<std::uint32_t>(i)));
  return lights;
}

}  // namespace candela
