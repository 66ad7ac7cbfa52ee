// The reference back end: a binary BVH built by binned SAH, written to be read. For tests,
// `--accel bvh` and `candela bench`; never built when not asked for.
#pragma once

#include <memory>

#include "renderer/accel/accelerator.h"
#include "renderer/scene/scene.h"

namespace candela {

// The scene outlives it and does not move.
class BvhAccel {
 public:
  explicit BvhAccel(const Scene& scene);
  BvhAccel(BvhAccel&&) noexcept;
  BvhAccel& operator=(BvhAccel&&) noexcept;
  ~BvhAccel();

  [[nodiscard]] Hit intersect(const Ray& ray) const;
  [[nodiscard]] bool occluded(const Ray& ray) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace candela
