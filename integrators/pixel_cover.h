// Which pixels of a picture things may be seen in, at most: what they cover on the film, as
// rectangles, widened by what rounding does to vertices and rays and by the pixel filter's radius.
#pragma once

#include <cstdint>
#include <vector>

#include "integrators/projected_bounds.h"
#include "renderer/camera/camera.h"
#include "renderer/film/filter.h"
#include "renderer/geometry/geometry.h"
#include "renderer/math/bounds.h"

namespace candela {

// A value a pixel, in rows from the top.
using PixelMask = std::vector<std::uint8_t>;

class PixelCover {
 public:
  // Cameras that map straight lines to straight lines: perspective without a lens, orthographic.
  [[nodiscard]] static bool has_projection(const Camera& camera);

  // What a cover and its mask hold for each pixel.
  static constexpr std::size_t bytes_a_pixel = sizeof(std::int32_t) + sizeof(PixelMask::value_type);

  // Of a whole picture of so many pixels. `bounds`: of all that will be added.
  PixelCover(const Camera& camera, const Bounds3f& bounds, const Filter& filter, int width,
             int height);

  // Each triangle and sphere; not of an object that instances place.
  void add(const Geometry& geometry);
  void add(const Bounds3f& box);

  // 1 where something was added.
  [[nodiscard]] PixelMask covered() const;
  // Over all that was added, how many pixels it covers.
  [[nodiscard]] double sum() const { return sum_; }

 private:
  // Rectangles are noted by their corners: sums over both axes tell how many cover a pixel.
  [[nodiscard]] std::size_t corner(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
           static_cast<std::size_t>(x);
  }
  void add_rectangle(const FilmBounds& bounds);

  Projection projection_;
  int width_;
  int height_;
  double reach_;
  std::vector<std::int32_t> corners_;
  double sum_ = 0;
};

}  // namespace candela
