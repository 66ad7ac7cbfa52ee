// Embree behind the Accelerator concept.
#pragma once

#include <memory>

#include "renderer/accel/accelerator.h"
#include "renderer/scene/scene.h"

namespace candela {

struct EmbreeOptions {
  bool robust = false;  // RTC_SCENE_FLAG_ROBUST
};

// Refers to the scene's arrays (shared buffers): the scene outlives it and does not move.
class EmbreeAccel {
 public:
  explicit EmbreeAccel(const Scene& scene, EmbreeOptions options = {});
  EmbreeAccel(EmbreeAccel&&) noexcept;
  EmbreeAccel& operator=(EmbreeAccel&&) noexcept;
  ~EmbreeAccel();

  [[nodiscard]] Hit intersect(const Ray& ray) const;
  [[nodiscard]] bool occluded(const Ray& ray) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace candela
