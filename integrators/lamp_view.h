// Of each pixel the part that lamps can be seen in, at most: the lamps' outlines on the film,
// clipped to where the pixel's samples lie, widened by what rounding does to vertices and rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "integrators/projected_bounds.h"
#include "renderer/camera/camera.h"
#include "renderer/film/film.h"
#include "renderer/film/filter.h"
#include "renderer/geometry/geometry.h"
#include "renderer/math/bounds.h"

namespace candela {

// In rows from the top.
[[nodiscard]] inline std::uint32_t pixel_index(int x, int y, int width) {
  return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) +
         static_cast<std::uint32_t>(x);
}

// A pixel that some lamp may be seen in.
struct LampView {
  std::uint32_t index = 0;  // of the pixel, in rows from the top
  FilterPart part;          // outside of it there is none
};

class LampViews {
 public:
  // Of a whole picture of so many pixels, by a camera that PixelCover knows the projection of.
  // `bounds`: of all that will be added.
  LampViews(const Camera& camera, const Bounds3f& bounds, const Filter& filter, int width,
            int height);

  // Each triangle and sphere; not of an object that instances place.
  void add(const Geometry& geometry);

  // Of the pixels of a part of the picture, by index.
  [[nodiscard]] std::vector<LampView> views(const PixelRect& rect) const;

 private:
  using Rectangle = Bounds<Vec2d>;  // in pixels from the picture's upper left corner, y downwards
  // Convex.
  struct Outline {
    std::size_t first = 0;  // corner
    std::size_t end = 0;
    Vec2d wrong{0.0};  // by how much it may be off
    Rectangle pixels;  // by index, that it may be seen in
  };

  void add(const Sphere& sphere);
  void add_convex(std::span<const Projection::Point> corners);
  void add_rectangle(const Rectangle& rectangle);
  void add_outline(std::span<const Vec2d> outline, const Vec2d& wrong);
  void see(const Outline& outline, const PixelRect& rect, std::span<Rectangle> seen) const;

  const Camera& camera_;
  const Filter& filter_;
  Projection projection_;
  int width_;
  int height_;
  double slack_;  // of where a sample lies, in pixels
  std::vector<Vec2d> corners_;
  std::vector<Outline> outlines_;
};

}  // namespace candela
