// An accelerator that remembers the rays it was asked, in order, with their t_max.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/accel/accelerator.h"

namespace candela {

struct RecordedRay {
  Ray ray;
  bool is_shadow = false;
};

// For one thread at a time.
template <class A>
class RecordingAccel {
 public:
  explicit RecordingAccel(const A& inner) : inner_(inner) {}

  [[nodiscard]] Hit intersect(const Ray& ray) const {
    rays_.push_back({ray, false});
    return inner_.intersect(ray);
  }
  [[nodiscard]] bool occluded(const Ray& ray) const {
    rays_.push_back({ray, true});
    return inner_.occluded(ray);
  }
  [[nodiscard]] HitBlock intersect(const RayBlock& rays, LaneMask lanes,
                                   Coherence coherence) const {
    for_each_lane(lanes, [&](std::uint32_t i) { rays_.push_back({rays[i], false}); });
    return inner_.intersect(rays, lanes, coherence);
  }
  [[nodiscard]] LaneMask occluded(const RayBlock& rays, LaneMask lanes) const {
    for_each_lane(lanes, [&](std::uint32_t i) { rays_.push_back({rays[i], true}); });
    return inner_.occluded(rays, lanes);
  }
  [[nodiscard]] std::size_t memory_bytes() const { return inner_.memory_bytes(); }
  [[nodiscard]] std::vector<RecordedRay>& rays() const { return rays_; }

 private:
  const A& inner_;
  mutable std::vector<RecordedRay> rays_;
};

}  // namespace candela
