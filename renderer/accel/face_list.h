// A scene of few triangles as a list of flat faces: every ray is tested against all of them, in
// less time than a tree of so few takes. Where rounding leaves open whether a ray passes an edge on
// this or that side, nothing is claimed: a watertight intersector is to be asked.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/accel/face_lanes.h"

namespace candela {

struct Scene;

// The triangles of a face: one, or two that share a diagonal.
struct FaceTriangles {
  struct Triangle {
    std::uint32_t geometry = 0;
    std::uint32_t triangle = 0;
    // Barycentrics of vertices 1 and 2 at a place relative to the face's corner.
    Vec3f u_gradient{0}, v_gradient{0};
    float u = 0, v = 0;  // at the corner
  };

  Vec3f corner{0};  // the face's
  Vec3f across{0};  // above 0 at places on the first one's side of the diagonal
  Triangle first, second;
};

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
  [[nodiscard]] Hit hit_of(const Vec3f& origin, const Vec3f& direction, std::uint32_t face,
                           float t) const;

  FaceGroups faces_;
  std::vector<FaceTriangles> triangles_;  // by face
};

}  // namespace candela
