// Where light comes from, as learned from paths: space is split where many of them brought light,
// and each cell has a mixture of places that it came from. Frozen before the picture begins.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "integrators/guiding/target_mixture.h"
#include "renderer/math/vec.h"

namespace candela {

// How a surface point receives light: on one side alone, by the main axis of its normal
// (SurfacePoint::receiving_normal), or on both.
inline constexpr std::uint32_t receiving_sides = 7;
[[nodiscard]] inline std::uint32_t receiving_side(const Vec3f& normal) {
  const Vec3f size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const int axis = max_axis(size);
  if (!(size[axis] > 0)) return 6;
  return static_cast<std::uint32_t>(2 * axis) + (normal[axis] < 0 ? 1 : 0);
}

// What a training path brought to a point of a surface.
struct TrainingRecord {
  Vec3f position{0};
  Vec3f target{0};            // where it came from
  Vec3f receiving_normal{0};  // SurfacePoint's
  float weight = 0;           // f cos L / pdf, summed over channels; > 0
  float pdf = 0;              // solid angle, of the direction that the path took
  float bsdf_pdf = 0;         // the same without a guide
  float throughput = 0;       // of the path when it came there
};

class GuidingField {
 public:
  GuidingField() = default;
  // Records in an order that does not depend on threads.
  explicit GuidingField(std::span<const TrainingRecord> records);

  // Null where too few records lie on such sides.
  [[nodiscard]] const TargetMixture* mixture_at(const Vec3f& position,
                                                const Vec3f& receiving_normal) const {
    std::uint32_t node = roots_[receiving_side(receiving_normal)];
    if (node == none) return nullptr;
    while (nodes_[node].axis < 3) {
      const auto axis = static_cast<int>(nodes_[node].axis);
      node = nodes_[node].next + (position[axis] < nodes_[node].split ? 0 : 1);
    }
    return &mixtures_[nodes_[node].next];
  }
  [[nodiscard]] std::size_t cells() const { return mixtures_.size(); }
  [[nodiscard]] std::size_t guided_cells() const;  // those where it pays
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.size() * sizeof(Node) + mixtures_.size() * sizeof(TargetMixture);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  struct Node {
    float split = 0;
    std::uint32_t axis = 3;  // 3: a leaf
    std::uint32_t next = 0;  // where its halves begin; of a leaf its mixture
  };

  void build(std::span<TrainingRecord> records, std::uint32_t node);

  std::array<std::uint32_t, receiving_sides> roots_{none, none, none, none, none, none, none};
  std::vector<Node> nodes_;
  std::vector<TargetMixture> mixtures_;
};

}  // namespace candela
