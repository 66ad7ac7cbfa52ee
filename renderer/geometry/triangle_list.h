// Which vertices the triangles of a geometry have.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace candela {

using TriangleCorners = std::array<std::uint32_t, 3>;

// Written once; copies share it, and so does what begins like it.
class TriangleList {
 public:
  using value_type = TriangleCorners;
  using const_iterator = const TriangleCorners*;

  TriangleList() = default;
  TriangleList(std::vector<TriangleCorners> triangles) : size_(triangles.size()) {
    const auto owner = std::make_shared<const std::vector<TriangleCorners>>(std::move(triangles));
    first_ = std::shared_ptr<const TriangleCorners>(owner, owner->data());
  }
  TriangleList(std::initializer_list<TriangleCorners> triangles)
      : TriangleList(std::vector<TriangleCorners>(triangles)) {}

  TriangleList(const TriangleList&) = default;
  TriangleList& operator=(const TriangleList&) = default;
  TriangleList(TriangleList&& other) noexcept
      : first_(std::move(other.first_)), size_(std::exchange(other.size_, 0)) {}
  TriangleList& operator=(TriangleList&& other) noexcept {
    first_ = std::move(other.first_);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const TriangleCorners* data() const { return first_.get(); }
  [[nodiscard]] const TriangleCorners* begin() const { return data(); }
  [[nodiscard]] const TriangleCorners* end() const { return data() + size_; }
  [[nodiscard]] const TriangleCorners& operator[](std::size_t i) const { return data()[i]; }

  [[nodiscard]] bool begins_with(const TriangleList& other) const {
    return other.size_ <= size_ && std::equal(other.begin(), other.end(), begin());
  }
  // The first `size` triangles, in the same memory.
  [[nodiscard]] TriangleList prefix(std::size_t size) const {
    TriangleList shared = *this;
    shared.size_ = size;
    return shared;
  }

  friend bool operator==(const TriangleList& a, const TriangleList& b) {
    return a.size_ == b.size_ && a.begins_with(b);
  }

 private:
  std::shared_ptr<const TriangleCorners> first_;
  std::size_t size_ = 0;
};

}  // namespace candela
