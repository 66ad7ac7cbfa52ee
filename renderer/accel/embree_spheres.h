// Spheres as a geometry of Embree's that answers by our own function (sphere_hit.h).
#pragma once

#include "renderer/accel/embree_api.h"
#include "renderer/scene/scene.h"

namespace candela {

// What a callback of Embree's is told of the geometry that it is called for.
struct EmbreeUserData {
  const Scene* scene = nullptr;
  std::uint32_t geometry = RTC_INVALID_GEOMETRY_ID;
};

// Index into Scene::instances of Embree's ID of an instance, which is the count of geometries plus
// that.
[[nodiscard]] inline std::uint32_t instance_of_id(const Scene& scene, std::uint32_t id) {
  return id == RTC_INVALID_GEOMETRY_ID ? id
                                       : id - static_cast<std::uint32_t>(scene.geometries.size());
}

// A committed geometry of the spheres. `data` outlives it.
[[nodiscard]] RTCGeometry new_embree_spheres(RTCDevice device, const EmbreeUserData& data);

}  // namespace candela
