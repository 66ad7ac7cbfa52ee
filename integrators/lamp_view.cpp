#include "integrators/lamp_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/math/constants.h"

namespace candela {
namespace {

using Places = std::vector<Vec2d>;

// A sphere's outline has the most.
constexpr int most_corners = 16;

// Kept on the stack, since pixels are many. Rounding may leave an outline with small dents, of
// which each of four sides can make half as many corners again.
struct Polygon {
  std::array<Vec2d, 81> corners;
  std::size_t size = 0;

  void add(const Vec2d& corner) { corners[size++] = corner; }
};

// What lies on the side of `limit` that `sign` tells [Sutherland74b].
void clip(const Polygon& polygon, int axis, double limit, double sign, Polygon& clipped) {
  clipped.size = 0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2d& a = polygon.corners[i];
    const Vec2d& b = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
    const double inside_a = sign * (a[axis] - limit);
    const double inside_b = sign * (b[axis] - limit);
    if (inside_a >= 0) clipped.add(a);
    if ((inside_a < 0) == (inside_b < 0)) continue;
    clipped.add(a + (b - a) * (inside_a / (inside_a - inside_b)));
  }
}

// Of what of a convex polygon lies in a rectangle; empty where nothing does.
Bounds<Vec2d> bounds_within(std::span<const Vec2d> outline, const Bounds<Vec2d>& rectangle) {
  Polygon polygon;
  Polygon clipped;
  for (const Vec2d& corner : outline) polygon.add(corner);
  for (int axis = 0; axis < 2; ++axis) {
    clip(polygon, axis, rectangle.lower[axis], 1, clipped);
    clip(clipped, axis, rectangle.upper[axis], -1, polygon);
  }
  Bounds<Vec2d> bounds;
  for (std::size_t i = 0; i < polygon.size; ++i) bounds.include(polygon.corners[i]);
  return bounds;
}

Bounds<Vec2d> widened(const Bounds<Vec2d>& bounds, const Vec2d& by) {
  return {bounds.lower - by, bounds.upper + by};
}

// A polygon around the circle that is a sphere's outline for the camera, in its plane: what it is
// seen as lies around what the sphere is seen as. None from within the sphere.
std::vector<Vec3d> polygon_around(const Sphere& sphere, const Camera& camera) {
  const Vec3d centre(sphere.centre);
  constexpr double wider = 0x1p-20;
  const double reach = max_component(glm::abs(centre)) + static_cast<double>(sphere.radius);
  const double radius = static_cast<double>(sphere.radius) + reach * wider;
  Vec3d axis = -Vec3d(camera.look);
  double share = 0;  // of the way to the eye, at which the circle lies
  if (camera.kind == CameraKind::Perspective) {
    axis = Vec3d(camera.eye) - centre;
    share = radius * radius / dot(axis, axis);
    if (!(share < 1)) return {};
  }
  const Vec3d normal = normalize(axis);
  const Vec3d aside = std::abs(normal.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d u = normalize(cross(normal, aside));
  const Vec3d v = cross(normal, u);
  const double distance = radius * std::sqrt(1 - share) / std::cos(pi_double / most_corners);
  std::vector<Vec3d> polygon;
  for (int i = 0; i < most_corners; ++i) {
    const double angle = 2 * pi_double * i / most_corners;
    polygon.push_back(centre + axis * share +
                      (u * std::cos(angle) + v * std::sin(angle)) * distance);
  }
  return polygon;
}

// Whether all of a pixel's samples lie in a rectangle: nothing can be added to it.
bool holds(const Bounds<Vec2d>& rectangle, const Vec2d& centre, double radius) {
  const Vec2d low = rectangle.lower - centre;
  const Vec2d high = rectangle.upper - centre;
  return std::max(low.x, low.y) <= -radius && std::min(high.x, high.y) >= radius;
}

enum class Side : std::uint8_t { Within, Across, Beside };

// Where a rectangle lies to a convex outline: for sure, by `slack`; Across where that is not known.
Side side_of(const Vec2d& centre, const Vec2d& reach, const Vec2d& slack,
             std::span<const Vec2d> outline, double orientation) {
  Side side = Side::Within;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2d& a = outline[i];
    const Vec2d edge = outline[i + 1 == outline.size() ? 0 : i + 1] - a;
    const Vec2d inwards = orientation * Vec2d(-edge.y, edge.x);
    const double distance = dot(inwards, centre - a);
    const double wide = dot(glm::abs(inwards), reach + slack);
    if (distance < -wide) return Side::Beside;
    if (!(distance > wide)) side = Side::Across;
  }
  return side;
}

// 1 or -1: to which side of its edges a convex outline lies; 0 where it is a line or a point.
double orientation_of(std::span<const Vec2d> outline) {
  double area = 0;
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const Vec2d u = outline[i - 1] - outline[0];
    const Vec2d v = outline[i] - outline[0];
    area += u.x * v.y - u.y * v.x;
  }
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

}  // namespace

LampViews::LampViews(const Camera& camera, const Bounds3f& bounds, const Filter& filter, int width,
                     int height)
    : camera_(camera),
      filter_(filter),
      projection_(camera, extent_of(bounds)),
      width_(width),
      height_(height),
      slack_(std::max(width, height) * 0x1p-20) {}

void LampViews::add_outline(std::span<const Vec2d> outline, const Vec2d& wrong) {
  const Vec2d reach = wrong + slack_ + static_cast<double>(filter_.radius());
  Rectangle all;
  for (const Vec2d& corner : outline) all.include(corner);
  all = widened(all, reach + 0.5);  // of the pixels' middles
  const Vec2d size(width_, height_);
  if (all.is_empty() || glm::any(glm::lessThan(all.upper, Vec2d(0.0))) ||
      glm::any(glm::greaterThanEqual(all.lower, size)))
    return;
  const std::size_t first = corners_.size();
  corners_.insert(corners_.end(), outline.begin(), outline.end());
  outlines_.push_back(
      {first,
       corners_.size(),
       wrong,
       {glm::floor(glm::max(all.lower, Vec2d(0.0))), glm::floor(glm::min(all.upper, size - 1.0))}});
}

// In rows of a part of the picture. If an outline is off by no more than `wrong`, so is what lies
// within a rectangle of what it should be within one that is larger by that.
void LampViews::see(const Outline& outline, const PixelRect& rect,
                    std::span<Rectangle> seen) const {
  const int first_x = std::max(rect.x0, static_cast<int>(outline.pixels.lower.x));
  const int end_x = std::min(rect.x1, static_cast<int>(outline.pixels.upper.x) + 1);
  const int first_y = std::max(rect.y0, static_cast<int>(outline.pixels.lower.y));
  const int end_y = std::min(rect.y1, static_cast<int>(outline.pixels.upper.y) + 1);
  if (first_x >= end_x || first_y >= end_y) return;
  const std::span<const Vec2d> corners =
      std::span(corners_).subspan(outline.first, outline.end - outline.first);
  const double orientation = orientation_of(corners);
  const auto radius = static_cast<double>(filter_.radius());
  const Vec2d slack = outline.wrong + slack_;
  const Vec2d reach = slack + radius;
  for (int y = first_y; y < end_y; ++y)
    for (int x = first_x; x < end_x; ++x) {
      Rectangle& pixel = seen[rect.index(x, y)];
      const Vec2d centre(x + 0.5, y + 0.5);
      if (holds(pixel, centre, radius)) continue;
      const Side side = side_of(centre, reach, slack, corners, orientation);
      if (side == Side::Beside) continue;
      const Rectangle around{centre - reach, centre + reach};
      const Rectangle part = side == Side::Within ? around : bounds_within(corners, around);
      if (!part.is_empty()) pixel.include(widened(part, slack));
    }
}

void LampViews::add_convex(std::span<const Projection::Point> corners) {
  const Vec2d half_size(0.5 * width_, 0.5 * height_);
  const auto in_pixels = [&](const Vec2d& film) {
    return Vec2d((film.x + 1) * half_size.x, (1 - film.y) * half_size.y);
  };
  Places outline;
  if (const std::optional<Vec2d> wrong = projection_.places(corners, outline)) {
    for (Vec2d& corner : outline) corner = in_pixels(corner);
    return add_outline(outline, *wrong * half_size);
  }
  const FilmBounds bounds = projection_.bounds(corners);
  if (bounds.is_empty()) return;
  const Vec2d upper_left = in_pixels({bounds.lower.x, bounds.upper.y});
  const Vec2d lower_right = in_pixels({bounds.upper.x, bounds.lower.y});
  add_rectangle({upper_left, lower_right});
}

// May be infinite.
void LampViews::add_rectangle(const Rectangle& rectangle) {
  const Vec2d beyond(static_cast<double>(filter_.radius()) + 2);  // where no sample lies
  const Vec2d size(width_, height_);
  const Vec2d low = glm::clamp(rectangle.lower, -beyond, size + beyond);
  const Vec2d high = glm::clamp(rectangle.upper, -beyond, size + beyond);
  add_outline(std::array{low, Vec2d(high.x, low.y), high, Vec2d(low.x, high.y)}, Vec2d(0.0));
}

void LampViews::add(const Geometry& geometry) {
  for (const Sphere& sphere : geometry.spheres) add(sphere);
  std::vector<Projection::Point> points;
  points.reserve(geometry.positions.size());
  for (const Vec3f& position : geometry.positions)
    points.push_back(projection_.point(Vec3d(position)));
  for (const auto& [a, b, c] : geometry.triangles)
    add_convex(std::array{points[a], points[b], points[c]});
}

void LampViews::add(const Sphere& sphere) {
  std::vector<Projection::Point> points;
  for (const Vec3d& corner : polygon_around(sphere, camera_))
    points.push_back(projection_.point(corner));
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  if (points.empty()) return add_rectangle({Vec2d(-everywhere), Vec2d(everywhere)});
  add_convex(points);
}

std::vector<LampView> LampViews::views(const PixelRect& rect) const {
  std::vector<Rectangle> seen(static_cast<std::size_t>(rect.width()) *
                              static_cast<std::size_t>(rect.height()));
  for (const Outline& outline : outlines_) see(outline, rect, seen);
  std::vector<LampView> views;
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x) {
      const Rectangle& pixel = seen[rect.index(x, y)];
      if (pixel.is_empty()) continue;
      const Vec2d centre(x + 0.5, y + 0.5);
      const FilterPart part = filter_.part_within({pixel.lower - centre, pixel.upper - centre});
      if (part.share() > 0) views.push_back({pixel_index(x, y, width_), part});
    }
  return views;
}

}  // namespace candela
