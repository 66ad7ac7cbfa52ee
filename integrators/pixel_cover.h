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

// Some pixels of a picture: all of a square of 2^n x 2^n pixels or none. The squares are single
// pixels but in pictures of more than four million, so that a crop of a huge picture, which must
// know what the whole picture does, needs neither its time nor its memory.
class CoveredPixels {
 public:
  CoveredPixels() = default;  // none, of any picture
  CoveredPixels(int width, int height);

  [[nodiscard]] bool contains(int x, int y) const {
    return !is_covered_.empty() && is_covered_[index(x >> shift_, y >> shift_)] != 0;
  }
  // With the whole of squares that the picture's edges cut.
  [[nodiscard]] double count() const;

  // How many squares there are each way, and pixels in each: 2^shift() each way.
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int shift() const { return shift_; }
  void add_square(int column, int row) { is_covered_[index(column, row)] = 1; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int shift_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> is_covered_;
};

class PixelCover {
 public:
  // Cameras that map straight lines to straight lines: perspective without a lens, orthographic.
  [[nodiscard]] static bool has_projection(const Camera& camera);

  // Of a whole picture of so many pixels. `bounds`: of all that will be added.
  PixelCover(const Camera& camera, const Bounds3f& bounds, const Filter& filter, int width,
             int height);

  // Each triangle and sphere; not of an object that instances place.
  void add(const Geometry& geometry);
  void add(const Bounds3f& box);

  // Where something was added.
  [[nodiscard]] CoveredPixels covered() const;
  // Over all that was added, how many pixels it covers.
  [[nodiscard]] double sum() const { return sum_; }

 private:
  // Rectangles are noted by their corners: sums over both axes tell how many cover a square.
  [[nodiscard]] std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(none_.columns() + 1) +
           static_cast<std::size_t>(column);
  }
  void add_rectangle(const FilmBounds& bounds);

  Projection projection_;
  int width_;
  int height_;
  double reach_;
  CoveredPixels none_;
  std::vector<std::int32_t> corners_;
  double sum_ = 0;
};

}  // namespace candela
