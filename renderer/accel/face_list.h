// A scene of few triangles as a list of flat faces: every ray is tested against all of them, in
// less time than a tree of so few takes. Where rounding leaves open whether a ray passes an edge on
// this or that side, nothing is claimed: a watertight intersector is to be asked.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/accel/face_hits.h"

namespace candela {

struct Scene;

class FaceList {
 public:
  static constexpr std::size_t most_faces = 32;  // that pay (docs/decisions.md)
  // Of a corner from the scene's centre, in its unit (scene/normalise.h): what rounding leaves open
  // grows with it, until nothing is known of what is met in the middle.
  static constexpr float most_reach = 64;

  FaceList() = default;
  // Of these geometries, placed in the world. Empty where there are more, where one reaches
  // farther, and where anything is no opaque triangle.
  FaceList(const Scene& scene, std::span<const GeometryHandle> geometries);

  [[nodiscard]] bool is_empty() const { return faces_.size == 0; }
  [[nodiscard]] std::size_t size() const { return faces_.size; }

  // What an Accelerator tells, of rays of which it is known for certain; `open` are the others. A
  // ray alone is told the same as in a block.
  struct BlockAnswer {
    HitBlock hits;
    LaneMask open;
  };
  [[nodiscard]] BlockAnswer intersect(const RayBlock& rays, LaneMask lanes) const;
  struct BlockOcclusion {
    LaneMask occluded;
    LaneMask open;
  };
  [[nodiscard]] BlockOcclusion occluded(const RayBlock& rays, LaneMask lanes) const;
  [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const;
  [[nodiscard]] std::optional<bool> occluded(const Ray& ray) const;

 private:
  void clear();

  FaceGroups faces_;
  std::vector<FaceTriangles> triangles_;  // by face
};

}  // namespace candela
