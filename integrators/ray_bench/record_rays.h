// Rays as a path tracer shoots them in a scene, recorded so that accelerators can be measured and
// compared on them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "renderer/accel/embree_accel.h"
#include "renderer/math/ray.h"
#include "renderer/scene/scene.h"

namespace candela {

enum class RayClass : std::uint8_t { Camera, Bounce, Shadow };
inline constexpr std::array<std::string_view, 3> ray_class_names{"camera", "bounce", "shadow"};

struct RecordOptions {
  int width = 512;  // one path a pixel
  int height = 512;
  int bounces = 3;
  std::size_t camera = 0;
  std::uint64_t seed = 0;
};

// By class; the order is that of a path tracer's work on one tile row after another: neighbours in
// the list start from neighbouring pixels.
using RecordedRays = std::array<std::vector<Ray>, 3>;

// Camera rays on the pixel grid, bounces by the cosine about the geometric normal, at each hit a
// shadow ray to a light: of those that the sampler always takes and one that it picks by power,
// each equally often. No material is asked, so that every surface bounces. None where the scene
// lacks the camera. Traced by one thread.
[[nodiscard]] RecordedRays record_rays(const Scene& scene, const EmbreeAccel& accelerator,
                                       const RecordOptions& options);

}  // namespace candela
