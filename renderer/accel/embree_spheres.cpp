#include "renderer/accel/embree_spheres.h"

#include "renderer/accel/alpha_test.h"
#include "renderer/accel/sphere_hit.h"
#include "renderer/geometry/geometry_bounds.h"

namespace candela {
namespace {

void set_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& data = *static_cast<const EmbreeUserData*>(arguments->geometryUserPtr);
  const Bounds3f box = bounds_of(data.scene->geometries[data.geometry].spheres[arguments->primID]);
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower.x, out.lower_y = box.lower.y, out.lower_z = box.lower.z;
  out.upper_x = box.upper.x, out.upper_y = box.upper.y, out.upper_z = box.upper.z;
}

// In the space of the instance, where there is one.
SphereHit hit_in_lane(void* user_data, const embree::Context* context, RTCRayN* rays, unsigned n,
                      unsigned lane, unsigned sphere) {
  const auto& data = *static_cast<const EmbreeUserData*>(user_data);
  const Ray ray{
      {RTCRayN_org_x(rays, n, lane), RTCRayN_org_y(rays, n, lane), RTCRayN_org_z(rays, n, lane)},
      {RTCRayN_dir_x(rays, n, lane), RTCRayN_dir_y(rays, n, lane), RTCRayN_dir_z(rays, n, lane)},
      RTCRayN_tfar(rays, n, lane)};
  const auto& query = *reinterpret_cast<const embree::Query*>(context);
  const Ray world_ray = query.world_ray(RTCRayN_id(rays, n, lane));
  const std::uint32_t instance = instance_of_id(*data.scene, context->instID[0]);
  return intersect_sphere(data.scene->geometries[data.geometry].spheres[sphere], ray, ray.t_max,
                          [&](float u, float v) {
                            return !is_transparent_at(*data.scene, data.geometry, sphere, instance,
                                                      u, v, world_ray.origin, world_ray.direction);
                          });
}

void intersect_lanes(const RTCIntersectFunctionNArguments* arguments) {
  const unsigned n = arguments->N;
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, n);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, n);
  for (unsigned lane = 0; lane < n; ++lane) {
    if (arguments->valid[lane] == 0) continue;
    const SphereHit hit = hit_in_lane(arguments->geometryUserPtr, arguments->context, rays, n, lane,
                                      arguments->primID);
    if (!hit.is_hit()) continue;
    RTCRayN_tfar(rays, n, lane) = hit.t;
    RTCHitN_u(hits, n, lane) = hit.u;
    RTCHitN_v(hits, n, lane) = hit.v;
    RTCHitN_primID(hits, n, lane) = arguments->primID;
    RTCHitN_geomID(hits, n, lane) = arguments->geomID;
    RTCHitN_instID(hits, n, lane, 0) = arguments->context->instID[0];
  }
}

void occlude_lanes(const RTCOccludedFunctionNArguments* arguments) {
  for (unsigned lane = 0; lane < arguments->N; ++lane) {
    if (arguments->valid[lane] == 0) continue;
    const SphereHit hit = hit_in_lane(arguments->geometryUserPtr, arguments->context,
                                      arguments->ray, arguments->N, lane, arguments->primID);
    if (hit.is_hit()) RTCRayN_tfar(arguments->ray, arguments->N, lane) = -infinity;
  }
}

}  // namespace

RTCGeometry new_embree_spheres(RTCDevice device, const EmbreeUserData& data) {
  RTCGeometry made = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(
      made, static_cast<unsigned>(data.scene->geometries[data.geometry].spheres.size()));
  // Embree's signature is not const; the callbacks only read.
  rtcSetGeometryUserData(made, const_cast<EmbreeUserData*>(&data));
  rtcSetGeometryBoundsFunction(made, set_bounds, nullptr);
  rtcSetGeometryIntersectFunction(made, intersect_lanes);
  rtcSetGeometryOccludedFunction(made, occlude_lanes);
  rtcSetGeometryMask(made, RTC_INVALID_GEOMETRY_ID);
  rtcCommitGeometry(made);
  return made;
}

}  // namespace candela
