#include "renderer/scene/compile_spheres.h"

#include <limits>

#include "renderer/scene/triangle_sort.h"

namespace candela {
namespace {

Sphere normalised_sphere(const description::Sphere& sphere, const Transform& to_normalised) {
  constexpr double lenient = 1e-3;  // it was looked at before it was moved
  const double scale = similarity_scale(to_normalised, lenient);
  Sphere out;
  if (!(scale > 0)) {  // too large, or too small, to be told
    out.radius = std::numeric_limits<float>::infinity();
    return out;
  }
  out.centre = Vec3f(to_normalised.translation);
  out.radius = static_cast<float>(sphere.radius * scale);
  out.x = Vec3f(to_normalised.linear[0] / scale);
  out.y = Vec3f(to_normalised.linear[1] / scale);
  out.z = Vec3f(to_normalised.linear[2] / scale);
  out.faces_inwards = sphere.faces_inwards;
  return out;
}

bool is_in_reach(const Sphere& sphere) {
  const float reach = max_component(glm::abs(sphere.centre)) + sphere.radius;
  return reach < static_cast<float>(out_of_reach_at);  // false for NaN, too
}

// Squares of the radius must be floats.
bool is_large_enough(const Sphere& sphere) {
  return sphere.radius * sphere.radius >= std::numeric_limits<float>::min();
}

// Over all of the sphere: the two triangles of the unit square of its coordinates.
Coverage coverage_of(const Scene& scene, const Material& material) {
  description::Mesh square;
  square.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Coverage lower = coverage_of(scene, material, square, 0);
  return lower == coverage_of(scene, material, square, 1) ? lower : Coverage::Partial;
}

}  // namespace

std::optional<Geometry> compile_sphere(const Scene& scene, const description::Sphere& sphere,
                                       const Transform& to_normalised, std::uint32_t material,
                                       bool decides_cutouts, DropCounts& dropped) {
  const Sphere compiled = normalised_sphere(sphere, to_normalised);
  const Coverage coverage =
      decides_cutouts ? coverage_of(scene, scene.materials[material]) : Coverage::Opaque;
  if (!is_in_reach(compiled)) {
    ++dropped[DropReason::SpheresOutOfReach];
  } else if (!is_large_enough(compiled)) {
    ++dropped[DropReason::SpheresTooSmall];
  } else if (coverage == Coverage::Clear) {
    ++dropped[DropReason::ClearSpheres];
  } else {
    Geometry geometry;
    geometry.spheres = {compiled};
    geometry.material = MaterialHandle(material);
    geometry.has_cutouts = coverage == Coverage::Partial;
    return geometry;
  }
  return std::nullopt;
}

}  // namespace candela
