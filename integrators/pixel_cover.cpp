#include "integrators/pixel_cover.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/geometry/geometry_bounds.h"

namespace candela {
namespace {

int clamped_pixel(double place, int count) {
  return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count)));
}

}  // namespace

CoveredPixels::CoveredPixels(int width, int height) {
  constexpr double most = 1 << 22;
  const auto squares = [&](int size) { return ((size - 1) >> shift_) + 1; };
  while (static_cast<double>(squares(width)) * squares(height) > most) ++shift_;
  columns_ = squares(width);
  rows_ = squares(height);
  is_covered_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

double CoveredPixels::count() const {
  const auto squares = std::count(is_covered_.begin(), is_covered_.end(), 1);
  return std::ldexp(static_cast<double>(squares), 2 * shift_);
}

bool PixelCover::has_projection(const Camera& camera) {
  const bool is_flat =
      camera.kind == CameraKind::Perspective || camera.kind == CameraKind::Orthographic;
  return is_flat && camera.lens_radius == 0;
}

PixelCover::PixelCover(const Camera& camera, const Bounds3f& bounds, const Filter& filter,
                       int width, int height)
    : projection_(camera, extent_of(bounds)),
      width_(width),
      height_(height),
      reach_(static_cast<double>(filter.radius()) + 0.5 + std::max(width, height) * 0x1p-20),
      none_(width, height),
      corners_(corner(0, none_.rows() + 1)) {}

// All pixels whose samples may lie within the bounds. A pixel's middle is half a pixel beside its
// index.
void PixelCover::add_rectangle(const FilmBounds& bounds) {
  if (bounds.is_empty()) return;
  const auto column = [&](double x) { return (x + 1) / 2 * width_; };
  const auto row = [&](double y) { return (1 - y) / 2 * height_; };
  const int x0 = clamped_pixel(std::ceil(column(bounds.lower.x) - reach_), width_);
  const int x1 = clamped_pixel(std::floor(column(bounds.upper.x) + reach_), width_);
  const int y0 = clamped_pixel(std::ceil(row(bounds.upper.y) - reach_), height_);
  const int y1 = clamped_pixel(std::floor(row(bounds.lower.y) + reach_), height_);
  if (x0 >= x1 || y0 >= y1) return;
  sum_ += static_cast<double>(x1 - x0) * (y1 - y0);
  const int shift = none_.shift();
  const int left = x0 >> shift;
  const int right = ((x1 - 1) >> shift) + 1;
  const int top = y0 >> shift;
  const int bottom = ((y1 - 1) >> shift) + 1;
  ++corners_[corner(left, top)];
  --corners_[corner(right, top)];
  --corners_[corner(left, bottom)];
  ++corners_[corner(right, bottom)];
}

void PixelCover::add(const Bounds3f& box) {
  std::array<Projection::Point, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i)
    corners[i] = projection_.point(box.corner(static_cast<int>(i)));
  add_rectangle(projection_.bounds(corners));
}

void PixelCover::add(const Geometry& geometry) {
  for (const Sphere& sphere : geometry.spheres) add(bounds_of(sphere));
  std::vector<Projection::Point> points;
  points.reserve(geometry.positions.size());
  for (const Vec3f& position : geometry.positions) points.push_back(projection_.point(position));
  for (const auto& [a, b, c] : geometry.triangles)
    add_rectangle(projection_.bounds(std::array{points[a], points[b], points[c]}));
}

CoveredPixels PixelCover::covered() const {
  CoveredPixels covered = none_;
  std::vector<std::int32_t> above(static_cast<std::size_t>(covered.columns()));
  for (int row = 0; row < covered.rows(); ++row) {
    std::int32_t in_row = 0;
    for (int column = 0; column < covered.columns(); ++column) {
      in_row += corners_[corner(column, row)];
      std::int32_t& covering = above[static_cast<std::size_t>(column)];
      covering += in_row;
      if (covering != 0) covered.add_square(column, row);
    }
  }
  return covered;
}

}  // namespace candela
