#include "renderer/texture/uv_range.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

// Of the lookup's own arithmetic and of the interpolation of uvs before it, in units of the largest
// coordinate: some roundings of 2^-24 each.
constexpr double relative_margin = 0x1p-20;

struct TriangleInTexels {
  std::array<Vec2d, 3> vertices;
  Vec2d low{0.0}, high{0.0};
  Vec2d size{0.0};
  double margin = 0;

  [[nodiscard]] TexelRegion region() const { return {vertices, margin}; }
  [[nodiscard]] bool is_within_image() const {
    return low.x >= -0.5 && low.y >= -0.5 && high.x <= size.x - 0.5 && high.y <= size.y - 0.5;
  }
};

bool are_finite(const std::array<Vec2f, 3>& uvs) {
  return std::ranges::all_of(
      uvs, [](const Vec2f& uv) { return std::isfinite(uv.x) && std::isfinite(uv.y); });
}

// Texel i's centre at i, rows downwards.
TriangleInTexels in_texels(const std::array<Vec2f, 3>& uvs, Vec2d size) {
  TriangleInTexels triangle;
  triangle.size = size;
  double largest = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d uv(uvs[i]);
    triangle.vertices[i] = {uv.x * size.x - 0.5, (1 - uv.y) * size.y - 0.5};
    largest = std::max({largest, std::abs(uv.x), std::abs(uv.y)});
  }
  const auto& v = triangle.vertices;
  triangle.margin = relative_margin * largest * std::max(size.x, size.y);
  triangle.low = glm::min(v[0], glm::min(v[1], v[2])) - triangle.margin;
  triangle.high = glm::max(v[0], glm::max(v[1], v[2])) + triangle.margin;
  return triangle;
}

class Search {
 public:
  Search(TextureFile& file, int channel)
      : texels_(file.texels()),
        tree_(file.range_tree(channel)),
        value_([this, channel](int x, int y) { return stored_value(texels_, x, y, channel); }) {}

  void add(const TexelRegion& region) { tree_.extend_by(region, value_, found_); }
  void add_black() { found_.extend({0, 0}); }

  [[nodiscard]] ValueRange found() const { return found_; }
  [[nodiscard]] ValueRange whole() const { return tree_.whole(); }

 private:
  const TexelArray& texels_;
  const RangeTree& tree_;
  RangeTree::Values value_;
  ValueRange found_;
};

// Each repeat of the image that the triangle's footprint reaches, the triangle moved into it.
void add_repeats(const TriangleInTexels& triangle, Search& search) {
  const TexelRegion region = triangle.region();
  const Vec2d first = glm::floor((triangle.low - 1.0) / triangle.size);
  const Vec2d last = glm::floor((triangle.high + 1.0) / triangle.size);
  for (double row = first.y; row <= last.y; ++row)
    for (double column = first.x; column <= last.x; ++column)
      search.add(region.moved_by(-Vec2d{column, row} * triangle.size));
}

// Beyond the edges lies the edge: the box of the triangle, moved onto the image, holds all of it.
void add_clamped(const TriangleInTexels& triangle, Search& search) {
  if (triangle.is_within_image()) return search.add(triangle.region());
  const Vec2d edge = triangle.size - 0.5;
  search.add(
      {glm::clamp(triangle.low, Vec2d(-0.5), edge), glm::clamp(triangle.high, Vec2d(-0.5), edge)});
}

void add_bordered(const TriangleInTexels& triangle, Search& search) {
  search.add(triangle.region());
  const bool is_inside = triangle.low.x >= 0 && triangle.low.y >= 0 &&
                         triangle.high.x <= triangle.size.x - 1 &&
                         triangle.high.y <= triangle.size.y - 1;
  if (!is_inside) search.add_black();
}

}  // namespace

ValueRange range_over_triangle(TextureFile& file, const std::array<Vec2f, 3>& uvs, int channel,
                               Wrap wrap) {
  const TexelArray& texels = file.texels();
  Search search(file, channel);
  const auto whole = [&] {
    if (wrap == Wrap::Black) search.add_black();
    ValueRange range = search.found();
    range.extend(search.whole());
    return range;
  };
  if (!are_finite(uvs)) return whole();
  const TriangleInTexels triangle =
      in_texels(uvs, {static_cast<double>(texels.width), static_cast<double>(texels.height)});
  const Vec2d extent = triangle.high - triangle.low;
  switch (wrap) {
    case Wrap::Repeat:
      if (extent.x > triangle.size.x || extent.y > triangle.size.y) return whole();
      add_repeats(triangle, search);
      return search.found();
    case Wrap::Clamp:
      add_clamped(triangle, search);
      return search.found();
    case Wrap::Mirror:
      if (!triangle.is_within_image()) return whole();
      search.add(triangle.region());
      return search.found();
    case Wrap::Black:
      add_bordered(triangle, search);
      return search.found();
  }
  return whole();
}

}  // namespace candela
