#include "integrators/projected_bounds.h"

#include <limits>

namespace candela {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Some sixteen times a float's rounding: of vertices, of rays and of what intersectors make of
// them.
constexpr double rounding = 0x1p-20;

Vec3d sums_of_rows(const Mat3d& m) {
  const auto row = [&](int i) { return std::abs(m[0][i]) + std::abs(m[1][i]) + std::abs(m[2][i]); };
  return {row(0), row(1), row(2)};
}

}  // namespace

Projection::Projection(const Camera& camera, double extent)
    : is_perspective_(camera.kind == CameraKind::Perspective),
      eye_(camera.eye),
      inverse_(glm::inverse(Mat3d(Vec3d(camera.right), Vec3d(camera.up), Vec3d(camera.look)))) {
  const Vec3d rows = sums_of_rows(inverse_);
  error_ = rows * (rounding * (extent + max_component(glm::abs(eye_))));
  const double longest =
      length(Vec3d(camera.right)) + length(Vec3d(camera.up)) + length(Vec3d(camera.look));
  ray_error_ = std::max(rows.x, rows.y) * longest * rounding;
}

FilmBounds Projection::everywhere() {
  return {Vec2d(-infinite), Vec2d(infinite)};
}

// Points before the camera are seen at place / depth, which on the hull is greatest and least at
// its corners: at those points, and, where the hull passes the camera's plane, infinitely far to
// the side where it does.
FilmBounds Projection::perspective_bounds(std::span<const Point> points) const {
  FilmBounds bounds;
  for (const Point& before : points) {
    const double depth = before.z;
    if (std::abs(depth) <= 2 * error_.z) return everywhere();
    if (depth < 0) continue;
    const Vec2d seen = Vec2d(before) / depth;
    const Vec2d wrong = perspective_error(seen, depth);
    bounds.include(seen - wrong);
    bounds.include(seen + wrong);
    for (const Point& behind : points) {
      if (behind.z > 0) continue;
      const double share = depth / (depth - behind.z);
      const Vec2d crossing = Vec2d(before) + (Vec2d(behind) - Vec2d(before)) * share;
      const Vec2d slack = Vec2d(error_) + (glm::abs(Vec2d(behind)) + glm::abs(Vec2d(before))) *
                                              (error_.z / (depth - behind.z));
      for (int axis = 0; axis < 2; ++axis) {
        if (crossing[axis] >= -slack[axis]) bounds.upper[axis] = infinite;
        if (crossing[axis] <= slack[axis]) bounds.lower[axis] = -infinite;
      }
    }
  }
  return bounds;
}

FilmBounds Projection::bounds(std::span<const Point> points) const {
  if (is_perspective_) return perspective_bounds(points);
  FilmBounds bounds;
  for (const Point& point : points) {
    const Vec2d wrong = Vec2d(error_) + ray_error_;
    bounds.include(Vec2d(point) - wrong);
    bounds.include(Vec2d(point) + wrong);
  }
  return bounds;
}

std::optional<Vec2d> Projection::places(std::span<const Point> points,
                                        std::vector<Vec2d>& seen) const {
  seen.clear();
  Vec2d wrong(Vec2d(error_) + ray_error_);
  for (const Point& point : points) {
    Vec2d place(point);
    if (is_perspective_) {
      if (!(point.z > 2 * error_.z)) return {};
      place /= point.z;
      wrong = glm::max(wrong, perspective_error(place, point.z));
    }
    seen.push_back(place);
  }
  return wrong;
}

}  // namespace candela
