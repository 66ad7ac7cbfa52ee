// The spheres of a scene of few: every ray is tested against all of them, in less time than a tree
// of so few takes. Floats tell which rays may meet which sphere, and sphere_hit.h, for those,
// where: what other accelerators say, to the bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/accel/ray_block.h"

namespace candela {

struct Scene;

// By lane.
struct SphereLanes {
  Vec3Lanes centre;
  Lanes<float> reach{};  // the radius, and more than floats may be wrong by about the centre
};

class SphereList {
 public:
  static constexpr std::size_t most_spheres = block_size;

  SphereList() = default;
  // Of these geometries, placed in the world. Empty where there are more.
  SphereList(const Scene& scene, std::span<const GeometryHandle> geometries);

  [[nodiscard]] bool is_empty() const { return spheres_.empty(); }
  [[nodiscard]] std::size_t size() const { return spheres_.size(); }

  // Rays end at t_max. Of the lanes' rays those that meet a sphere get it as their hit.
  void intersect(const RayBlock& rays, LaneMask lanes, HitBlock& hits) const;
  [[nodiscard]] LaneMask occluded(const RayBlock& rays, LaneMask lanes) const;
  [[nodiscard]] Hit intersect(const Ray& ray) const;
  [[nodiscard]] bool occluded(const Ray& ray) const;

 private:
  struct Listed {
    Sphere sphere;
    std::uint32_t geometry, index;  // in the geometry's spheres
  };

  [[nodiscard]] Hit hit_of(const Listed& listed, const Ray& ray) const;
  // Calls visit(lane, sphere, t) for the first places where rays meet spheres.
  template <class Visit>
  void for_each_meeting(const RayBlock& rays, LaneMask lanes, const Visit& visit) const;

  std::vector<Listed> spheres_;
  SphereLanes lanes_;
};

}  // namespace candela
