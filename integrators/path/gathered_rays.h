// Rays of several blocks, until they fill one: where what a ray is told depends on none that are
// asked for with it.
#pragma once

#include <array>

#include "renderer/accel/ray_block.h"

namespace candela {

// Blocks of at least so many rays are traced as they are.
inline constexpr std::uint32_t fewest_alone = 12;

template <class A>
[[nodiscard]] inline bool is_gathered(const A& accelerator, LaneMask lanes) {
  if constexpr (requires { accelerator.allows_any_company(); })
    return lane_count(lanes) < fewest_alone && accelerator.allows_any_company();
  else
    return false;
}

// `Place`: where the ray comes from.
template <class Place>
class GatheredRays {
 public:
  [[nodiscard]] bool is_empty() const { return size_ == 0; }
  [[nodiscard]] bool is_full() const { return size_ == block_size; }
  void add(const Ray& ray, const Place& place) {
    rays_.set(size_, ray);
    places_[size_++] = place;
  }
  void clear() { size_ = 0; }

  [[nodiscard]] const RayBlock& rays() const { return rays_; }
  [[nodiscard]] LaneMask lanes() const { return (1u << size_) - 1; }
  [[nodiscard]] const Place& place(std::uint32_t lane) const { return places_[lane]; }

 private:
  std::array<Place, block_size> places_{};
  std::uint32_t size_ = 0;
  RayBlock rays_;
};

}  // namespace candela
