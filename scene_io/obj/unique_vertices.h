// Corners -> vertices: equal (shape, position, uv, normal) give one vertex, in the order of first
// use.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "scene_io/obj/obj_data.h"

namespace candela::obj {

// A hash table with open addressing of indices into the list of vertices.
class UniqueVertices {
 public:
  explicit UniqueVertices(std::size_t expected_vertices)
      : slots_(std::bit_ceil(expected_vertices * 2 + 16), empty) {
    vertices_.reserve(expected_vertices);
  }

  // Vertices of earlier shapes are not found any more.
  void begin_shape(std::uint32_t shape) {
    shape_ = shape;
    shape_begin_ = vertices_.size();
  }

  std::uint32_t index_of(const Corner& corner) {
    if (vertices_.size() * 2 >= slots_.size()) grow();
    std::size_t slot = hash(corner, shape_) & (slots_.size() - 1);
    for (; slots_[slot] != empty; slot = (slot + 1) & (slots_.size() - 1)) {
      const std::uint32_t vertex = slots_[slot];
      if (vertex >= shape_begin_ && vertices_[vertex] == corner) return vertex;
    }
    slots_[slot] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(corner);
    return slots_[slot];
  }

  [[nodiscard]] const std::vector<Corner>& vertices() const { return vertices_; }

 private:
  static constexpr std::uint32_t empty = UINT32_MAX;

  // Sixteen positions that are neighbours in the file share a cache line of the table; blocks of
  // them are scattered, as runs of equal length laid side by side would make probing long.
  static std::size_t hash(const Corner& corner, std::uint32_t shape) {
    const auto part = [](std::int32_t index) { return static_cast<std::size_t>(index + 1); };
    const std::size_t mixed =
        (part(corner.position) >> 4) * 0x9E3779B97F4A7C15u ^ part(corner.uv) * 0xC2B2AE3D27D4EB4Fu ^
        part(corner.normal) * 0x165667B19E3779F9u ^ shape * std::size_t{0xD6E8FEB86659FD93u};
    return (mixed >> 28 << 4) + (part(corner.position) & 15);
  }

  // Only the current shape's vertices are looked for again.
  void grow() {
    slots_.assign(slots_.size() * 2, empty);
    for (std::size_t i = shape_begin_; i < vertices_.size(); ++i) {
      std::size_t slot = hash(vertices_[i], shape_) & (slots_.size() - 1);
      while (slots_[slot] != empty) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<std::uint32_t> slots_;
  std::vector<Corner> vertices_;
  std::uint32_t shape_ = 0;
  std::size_t shape_begin_ = 0;
};

}  // namespace candela::obj
