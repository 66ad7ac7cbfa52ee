#include "renderer/texture/range_tree.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

constexpr int block_side = 8;

int halved_upwards(int count) {
  return (count + 1) / 2;
}

}  // namespace

TexelRegion::TexelRegion(const std::array<Vec2d, 3>& vertices, double margin)
    : low_(glm::min(vertices[0], glm::min(vertices[1], vertices[2])) - margin),
      high_(glm::max(vertices[0], glm::max(vertices[1], vertices[2])) + margin),
      slab_count_(3) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d edge = vertices[(i + 1) % 3] - vertices[i];
    const Vec2d normal{-edge.y, edge.x};
    const double widened = margin * (std::abs(normal.x) + std::abs(normal.y));
    const double on_edge = dot(normal, vertices[i]);
    const double opposite = dot(normal, vertices[(i + 2) % 3]);
    slabs_[i] = {normal, std::min(on_edge, opposite) - widened,
                 std::max(on_edge, opposite) + widened};
  }
}

bool TexelRegion::may_meet(Vec2d low, Vec2d high) const {
  if (low.x > high_.x || low.y > high_.y || high.x < low_.x || high.y < low_.y) return false;
  const Vec2d centre = (low + high) * 0.5;
  const Vec2d half = (high - low) * 0.5;
  for (std::size_t i = 0; i < slab_count_; ++i) {
    const Slab& slab = slabs_[i];
    const double middle = dot(slab.normal, centre);
    const double reach = std::abs(slab.normal.x) * half.x + std::abs(slab.normal.y) * half.y;
    if (middle + reach < slab.low || middle - reach > slab.high) return false;
  }
  return true;
}

TexelRegion TexelRegion::moved_by(Vec2d offset) const {
  TexelRegion moved = *this;
  moved.low_ += offset;
  moved.high_ += offset;
  for (Slab& slab : moved.slabs_) {
    slab.low += dot(slab.normal, offset);
    slab.high += dot(slab.normal, offset);
  }
  return moved;
}

RangeTree::RangeTree(int width, int height, const Values& value) : width_(width), height_(height) {
  Level blocks;
  blocks.columns = (width + block_side - 1) / block_side;
  blocks.rows = (height + block_side - 1) / block_side;
  const auto node_of = [](Level& level, int column, int row) -> ValueRange& {
    return level.nodes[static_cast<std::size_t>(row) * static_cast<std::size_t>(level.columns) +
                       static_cast<std::size_t>(column)];
  };
  blocks.nodes.resize(static_cast<std::size_t>(blocks.columns) *
                      static_cast<std::size_t>(blocks.rows));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float v = value(x, y);
      node_of(blocks, x / block_side, y / block_side).extend({v, v});
    }
  levels_.push_back(std::move(blocks));
  while (levels_.back().nodes.size() > 1) {
    Level& finer = levels_.back();
    Level coarser;
    coarser.columns = halved_upwards(finer.columns);
    coarser.rows = halved_upwards(finer.rows);
    coarser.nodes.resize(static_cast<std::size_t>(coarser.columns) *
                         static_cast<std::size_t>(coarser.rows));
    for (int row = 0; row < finer.rows; ++row)
      for (int column = 0; column < finer.columns; ++column)
        node_of(coarser, column / 2, row / 2).extend(node_of(finer, column, row));
    levels_.push_back(std::move(coarser));
  }
}

void RangeTree::extend_by(const TexelRegion& region, const Values& value, ValueRange& found) const {
  visit(levels_.size() - 1, 0, 0, {region, value, found});
}

// A node of which nothing new can come is passed over, so that mixed regions end soon.
void RangeTree::visit(std::size_t level, int column, int row, const Query& query) const {
  const Level& nodes = levels_[level];
  if (column >= nodes.columns || row >= nodes.rows) return;
  const ValueRange& range =
      nodes.nodes[static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes.columns) +
                  static_cast<std::size_t>(column)];
  if (query.found.contains(range)) return;
  const double side = std::ldexp(static_cast<double>(block_side), static_cast<int>(level));
  const Vec2d low{column * side - 1, row * side - 1};
  if (!query.region.may_meet(low, low + side + 1.0)) return;
  if (level == 0) return visit_block(column, row, query);
  for (int i = 0; i < 4; ++i) visit(level - 1, 2 * column + i % 2, 2 * row + i / 2, query);
}

void RangeTree::visit_block(int column, int row, const Query& query) const {
  const int x_end = std::min((column + 1) * block_side, width_);
  const int y_end = std::min((row + 1) * block_side, height_);
  for (int y = row * block_side; y < y_end; ++y)
    for (int x = column * block_side; x < x_end; ++x) {
      const Vec2d centre{x, y};
      if (!query.region.may_meet(centre - 1.0, centre + 1.0)) continue;
      const float v = query.value(x, y);
      query.found.extend({v, v});
    }
}

}  // namespace candela
