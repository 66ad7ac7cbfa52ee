// The reference back end: a BVH built by binned SAH, written to be read. For tests, `--accel bvh`
// and `candela bench`; never built when not asked for. Tree and traversal are in bvh_tree.h, the
// ray-triangle test in triangle_block.h.
#pragma once

#include <memory>

#include "renderer/accel/accelerator.h"
#include "renderer/scene/scene.h"

namespace candela {

// Two levels: trees over the world's triangles and spheres, over those of each object, and one over
// the instances. The scene outlives it and does not move.
class BvhAccel {
 public:
  // Built by the current arena's threads; the same tree for any number of them.
  explicit BvhAccel(const Scene& scene);
  BvhAccel(BvhAccel&&) noexcept;
  BvhAccel& operator=(BvhAccel&&) noexcept;
  ~BvhAccel();

  [[nodiscard]] Hit intersect(const Ray& ray) const;
  [[nodiscard]] bool occluded(const Ray& ray) const;
  [[nodiscard]] HitBlock intersect(const RayBlock& rays, LaneMask lanes, Coherence) const {
    return intersect_one_by_one(*this, rays, lanes);
  }
  [[nodiscard]] LaneMask occluded(const RayBlock& rays, LaneMask lanes) const {
    return occluded_one_by_one(*this, rays, lanes);
  }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace candela
