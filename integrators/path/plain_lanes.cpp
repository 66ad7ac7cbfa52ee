#include "integrators/path/plain_lanes.h"

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"
#include "renderer/light/sphere_cone.h"

namespace candela {
namespace {

[[nodiscard]] inline Light lamp_of(const LampLanes& lamps, std::size_t i) {
  Light light;
  light.emits_both_sides = lamps.emits_both_sides[i] != 0;
  light.faces_inwards = lamps.faces_inwards[i] != 0;
  light.position = lamps.position[i];
  light.edge1 = lamps.edge1[i];
  light.edge2 = lamps.edge2[i];
  light.normal = lamps.normal[i];
  light.emission = lamps.emission[i];
  light.area = lamps.area[i];
  light.offset = lamps.offset[i];
  light.near_distance2 = lamps.near_distance2[i];
  return light;
}

CANDELA_LANES void find_planes(MetLanes& met) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    surface_point_detail::PlanePoint<Vec3f> plane = surface_point_detail::plane_point(
        met.corner0[i], met.corner1[i], met.corner2[i], met.u[i], met.v[i]);
    const bool is_front = dot(plane.normal, -met.direction[i]) > 0;
    met.position.set(i, plane.position);
    met.front_normal.set(i, plane.normal);
    met.normal.set(i, is_front ? plane.normal : -plane.normal);
    met.is_front[i] = flag(is_front);
    met.offset[i] = plane.offset;
  }
}

[[nodiscard]] inline Vec3f interpolated_normal(const MetLanes& met, std::uint32_t i) {
  const float u = met.u[i];
  const float v = met.v[i];
  return met.normal0[i] * (1 - u - v) + met.normal1[i] * u + met.normal2[i] * v;
}

CANDELA_LANES void find_front_normals(MetLanes& met) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    SurfacePoint point;
    point.front_normal = met.front_normal[i];
    Vec3f n = interpolated_normal(met, i);
    if (met.has_normals[i] == 0) n = Vec3f(0);
    surface_point_detail::set_front_normal(n, point);
    met.front_normal.set(i, point.front_normal);
    met.is_flat[i] = flag(point.is_flat);
  }
}

// From the object's space to the world.
void place_in_world(MetLanes& met, std::uint32_t i) {
  const Instance& instance = *met.instance[i];
  const Vec3f own = met.is_front[i] != 0 ? met.normal[i] : -met.normal[i];
  const surface_point_detail::PlanePoint<Vec3f> plane =
      surface_point_detail::placed_point(instance, {met.position[i], own, met.offset[i]});
  const Vec3f outside = plane.normal;
  met.position.set(i, plane.position);
  met.offset[i] = plane.offset;
  const bool is_front = dot(outside, -met.direction[i]) > 0;
  met.normal.set(i, is_front ? outside : -outside);
  met.is_front[i] = flag(is_front);
  SurfacePoint point;
  point.front_normal = outside;
  if (met.has_normals[i] != 0)
    surface_point_detail::set_front_normal(instance.normal(interpolated_normal(met, i)), point);
  met.front_normal.set(i, point.front_normal);
  met.is_flat[i] = flag(point.is_flat);
}

CANDELA_LANES void find_bent_frames(MetLanes& met) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    SurfacePoint point;
    point.front_normal = met.front_normal[i];
    point.geometric_normal = met.normal[i];
    point.is_flat = met.is_flat[i] != 0;
    set_shading_frame(point, -met.direction[i]);
    met.shading_normal.set(i, point.shading.z);
  }
}

// By value: stores to the lanes cannot change the light.
CANDELA_LANES void sample_point_light_in_lanes(Light light, PlainLanes& lanes) {
  for (std::size_t i = 0; i < block_size; ++i)
    lanes.light_samples.set(
        i, sample_from_point(light, point_of(lanes.met, i), [](const Vec3f&) { return 1.0f; }));
}
CANDELA_LANES void sample_spot_light_in_lanes(Light light, PlainLanes& lanes) {
  for (std::size_t i = 0; i < block_size; ++i)
    lanes.light_samples.set(
        i, sample_from_point(light, point_of(lanes.met, i),
                             [&](const Vec3f& w) { return spot_falloff(light, w); }));
}
CANDELA_LANES void sample_directional_light_in_lanes(Light light, PlainLanes& lanes) {
  for (std::size_t i = 0; i < block_size; ++i)
    lanes.light_samples.set(i, sample_directional_light(light, point_of(lanes.met, i)));
}

CANDELA_LANES LaneMask sample_triangles_and_quads(PlainLanes& lanes) {
  const LampLanes& lamps = lanes.lamps;
  LaneFlags left;
  for (std::size_t i = 0; i < block_size; ++i) {
    SurfacePoint point = point_of(lanes.met, i);
    Light light = lamp_of(lamps, i);
    const Vec2f u{lamps.u_x[i], lamps.u_y[i]};
    Vec2f weights = square_to_triangle(u);
    if (lamps.is_triangle[i] == 0) weights = u;
    left[i] = lamps.is_other[i] |
              (flag(lamps.is_triangle[i] == 0) & flag(is_near(light, point.position)));
    lanes.light_samples.set(i, light_from_place(light, point, weights));
  }
  return filled_mask(left, lanes);
}

// Of the lamps in these lanes; elsewhere samples stay as they are.
CANDELA_LANES LaneMask sample_spheres(LaneMask spheres, PlainLanes& lanes) {
  const LampLanes& lamps = lanes.lamps;
  LaneFlags left;
  for (std::size_t i = 0; i < block_size; ++i) {
    SurfacePoint point = point_of(lanes.met, i);
    Light light = lamp_of(lamps, i);
    const bool is_sphere = (spheres >> i & 1) != 0;
    const Vec3d to_centre = to_centre_of(light, point);
    const double distance2 = length_squared(to_centre);
    left[i] = flag(is_sphere) & flag(is_within(light, distance2));
    ConeSample cone =
        sample_sphere_cone(radius_of(light), to_centre, distance2, {lamps.u_x[i], lamps.u_y[i]});
    Rgb radiance = plain_sphere_radiance(light, cone.direction, -cone.wi);
    LightSample sample{
        .wi = cone.wi,
        .radiance = radiance,
        .pdf = is_black(radiance) ? 0.0f : cone.pdf,
        .shadow_ray = shadow_segment_to_sphere(light, point, cone.direction, cone.wi)};
    LightSample before = lanes.light_samples[i];
    lanes.light_samples.set(i, is_sphere ? sample : before);
  }
  return filled_mask(left, lanes);
}

}  // namespace

void find_points(PlainLanes& lanes) {
  MetLanes& met = lanes.met;
  find_planes(met);
  met.is_flat.fill(1);
  met.all_are_flat = !met.any_has_normals;
  if (met.any_has_normals) find_front_normals(met);
  for_each_lane(met.instanced, [&](std::uint32_t i) { place_in_world(met, i); });
}

void find_frames(PlainLanes& lanes) {
  MetLanes& met = lanes.met;
  if (met.all_are_flat)
    met.shading_normal = met.normal;
  else
    find_bent_frames(met);
}

LaneMask sample_lamps(PlainLanes& lanes) {
  lanes.light_samples.choice = lanes.lamps.probability;
  lanes.light_samples.pdf.fill(0);  // lanes without a path may have a sample of another light
  const LaneMask others = filled_mask(lanes.lamps.is_other, lanes);
  const LaneMask spheres = filled_mask(lanes.lamps.is_sphere, lanes) & ~others;
  LaneMask left = others;
  if ((others | spheres) != lanes.filled) left |= sample_triangles_and_quads(lanes) & ~spheres;
  if (spheres == 0) return left;
  const FloatingPointTraps traps(Traps::Off);  // of lamps that are no spheres
  return left | sample_spheres(spheres, lanes);
}

bool sample_delta_light(const Light& light, PlainLanes& lanes) {
  switch (light.kind) {
    case LightKind::Point:
      sample_point_light_in_lanes(light, lanes);
      return true;
    case LightKind::Spot:
      sample_spot_light_in_lanes(light, lanes);
      return true;
    case LightKind::Directional:
      sample_directional_light_in_lanes(light, lanes);
      return true;
    case LightKind::Triangle:
    case LightKind::Environment:
    case LightKind::TexturedTriangle:
    case LightKind::Goniometric:
    case LightKind::Projection:
    case LightKind::Sphere:
    case LightKind::Quad:
    case LightKind::NearTriangle:
      return false;
  }
  return false;
}

}  // namespace candela
