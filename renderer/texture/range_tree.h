// The smallest and largest value over parts of an image: blocks of 8x8 texels, then each level
// halves both sides, up to one node.
//
// Places are in texels with texel i's centre at i, so that a bilinear lookup at x touches the
// texels i with |x - i| < 1.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "renderer/math/vec.h"

namespace candela {

struct ValueRange {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  [[nodiscard]] bool contains(const ValueRange& other) const {
    return low <= other.low && other.high <= high;
  }
  void extend(const ValueRange& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

// A convex region: a rectangle, cut by the slabs of a triangle's edges where there are any.
class TexelRegion {
 public:
  // The triangle, widened by `margin` texels on all sides.
  TexelRegion(const std::array<Vec2d, 3>& vertices, double margin);
  // Everything between two corners.
  TexelRegion(Vec2d low, Vec2d high) : low_(low), high_(high) {}

  [[nodiscard]] Vec2d low() const { return low_; }
  [[nodiscard]] Vec2d high() const { return high_; }
  // Whether the rectangle of these corners may meet the region (never a false no).
  [[nodiscard]] bool may_meet(Vec2d low, Vec2d high) const;
  [[nodiscard]] TexelRegion moved_by(Vec2d offset) const;

 private:
  struct Slab {
    Vec2d normal{0.0};
    double low = 0;
    double high = 0;
  };
  Vec2d low_{0.0};
  Vec2d high_{0.0};
  std::array<Slab, 3> slabs_{};
  std::size_t slab_count_ = 0;
};

class RangeTree {
 public:
  using Values = std::function<float(int x, int y)>;

  RangeTree() = default;
  RangeTree(int width, int height, const Values& value);

  [[nodiscard]] ValueRange whole() const { return levels_.back().nodes.front(); }
  // Widens `found` by every texel whose bilinear footprint meets the region; texels outside the
  // image are not there. `value` as it was given when the tree was built.
  void extend_by(const TexelRegion& region, const Values& value, ValueRange& found) const;

 private:
  struct Level {
    int columns = 0;
    int rows = 0;
    std::vector<ValueRange> nodes;
  };
  struct Query {
    const TexelRegion& region;
    const Values& value;
    ValueRange& found;
  };
  void visit(std::size_t level, int column, int row, const Query& query) const;
  void visit_block(int column, int row, const Query& query) const;

  int width_ = 0;
  int height_ = 0;
  std::vector<Level> levels_;  // [0]: blocks
};

}  // namespace candela
