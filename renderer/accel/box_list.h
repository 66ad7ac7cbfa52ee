// A few boxes around what is dense in a scene: a ray that passes all of them by meets nothing
// there.
#pragma once

#include <span>

#include "renderer/accel/ray_block.h"
#include "renderer/math/bounds.h"
#include "renderer/scene/scene.h"

namespace candela {

class BoxList {
 public:
  static constexpr std::size_t most_boxes = 8;

  BoxList() = default;
  // Around all triangles and spheres of these geometries, which are placed in the world.
  BoxList(const Scene& scene, std::span<const GeometryHandle> geometries);

  [[nodiscard]] bool is_empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

  // The lanes whose rays enter a box before t_max, which may be more than do by an ulp or two.
  [[nodiscard]] LaneMask entered(const RayBlock& rays, LaneMask lanes) const;
  [[nodiscard]] bool is_entered(const Ray& ray) const;

 private:
  [[nodiscard]] LaneMask entered_lanes(const RayBlock& rays) const;

  std::size_t size_ = 0;
  Vec3Lanes lower_, upper_;  // of lanes without a box: a point that few rays meet
};

}  // namespace candela
