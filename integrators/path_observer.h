// Who is told what paths do on their way, lane by lane of a block, by kernels that are observed()
// (path/feature_set.h).
#pragma once

#include <cstdint>

#include "renderer/math/ray.h"

namespace candela {

// How a path leaves a surface, or a place in a medium.
struct LeftSurface {
  const Ray& ray;
  Vec3f receiving_normal{0};
  float pdf = 0;       // of the direction, over solid angle
  float bsdf_pdf = 0;  // that of the BSDF alone, without a guide
  bool is_delta = false;
  Rgb throughput_before{0};       // as it came there
  float roulette_throughput = 0;  // what Russian roulette went by (path/path_step.h)
  float survival = 1;             // and the probability to live that it gave
};

class PathObserver {
 public:
  virtual ~PathObserver() = default;
  virtual void leave(std::uint32_t lane, const LeftSurface& left) = 0;
  // Its radiance so far, light samples of that surface included.
  virtual void radiance_so_far(std::uint32_t lane, const Rgb& radiance) = 0;
  // Where its ray ended; infinite where it left the scene.
  virtual void meet(std::uint32_t lane, float distance) = 0;
  // It has ended with so much radiance in all.
  virtual void end(std::uint32_t lane, const Rgb& radiance) = 0;
};

}  // namespace candela
