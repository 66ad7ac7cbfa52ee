#include "integrators/lamp_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/math/constants.h"

namespace candela {
namespace {

using Polygon = std::vector<Vec2d>;

// What lies on the side of `limit` that `sign` tells [Sutherland74b].
void clip(Polygon& polygon, int axis, double limit, double sign, Polygon& clipped) {
  clipped.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d& a = polygon[i];
    const Vec2d& b = polygon[(i + 1) % polygon.size()];
    const double inside_a = sign * (a[axis] - limit);
    const double inside_b = sign * (b[axis] - limit);
    if (inside_a >= 0) clipped.push_back(a);
    if ((inside_a < 0) == (inside_b < 0)) continue;
    clipped.push_back(a + (b - a) * (inside_a / (inside_a - inside_b)));
  }
  polygon.swap(clipped);
}

// Of what of a convex polygon lies in a rectangle; empty where nothing does.
Bounds<Vec2d> bounds_within(Polygon polygon, const Bounds<Vec2d>& rectangle) {
  Polygon clipped;
  for (int axis = 0; axis < 2; ++axis) {
    clip(polygon, axis, rectangle.lower[axis], 1, clipped);
    clip(polygon, axis, rectangle.upper[axis], -1, clipped);
  }
  Bounds<Vec2d> bounds;
  for (const Vec2d& corner : polygon) bounds.include(corner);
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
  constexpr int corners = 16;
  const double distance = radius * std::sqrt(1 - share) / std::cos(pi_double / corners);
  std::vector<Vec3d> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi_double * i / corners;
    polygon.push_back(centre + axis * share +
                      (u * std::cos(angle) + v * std::sin(angle)) * distance);
  }
  return polygon;
}

}  // namespace

LampViews::LampViews(const Camera& camera, const Bounds3f& bounds, const Filter& filter, int width,
                     int height)
    : camera_(camera),
      filter_(filter),
      projection_(camera, extent_of(bounds)),
      width_(width),
      height_(height),
      slack_(std::max(width, height) * 0x1p-20),
      slots_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0u) {}

LampViews::Rectangle& LampViews::rectangle_of(int x, int y) {
  std::uint32_t& slot = slots_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(x)];
  if (slot == 0) {
    rectangles_.emplace_back();
    slot = static_cast<std::uint32_t>(rectangles_.size());
  }
  return rectangles_[slot - 1];
}

// If an outline is off by no more than `wrong`, so is what lies within a rectangle of what it
// should be within one that is larger by that.
void LampViews::add_outline(std::span<const Vec2d> outline, const Vec2d& wrong) {
  const Vec2d slack = wrong + slack_;
  const Vec2d reach = slack + static_cast<double>(filter_.radius());
  Rectangle all;
  for (const Vec2d& corner : outline) all.include(corner);
  all = widened(all, reach + 0.5);  // of the pixels' middles
  const Vec2d last(width_ - 1, height_ - 1);
  const glm::ivec2 low(glm::clamp(all.lower, Vec2d(0.0), last));
  const glm::ivec2 high(glm::clamp(all.upper, Vec2d(0.0), last));
  const Polygon polygon(outline.begin(), outline.end());
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      const Vec2d centre(x + 0.5, y + 0.5);
      const Rectangle seen = bounds_within(polygon, {centre - reach, centre + reach});
      if (!seen.is_empty()) rectangle_of(x, y).include(widened(seen, slack));
    }
}

void LampViews::add_convex(std::span<const Projection::Point> corners) {
  const Vec2d half_size(0.5 * width_, 0.5 * height_);
  const auto in_pixels = [&](const Vec2d& film) {
    return Vec2d((film.x + 1) * half_size.x, (1 - film.y) * half_size.y);
  };
  Polygon outline;
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

std::vector<LampView> LampViews::views() const {
  std::vector<LampView> views;
  views.reserve(rectangles_.size());
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i] == 0) continue;
    const auto x = static_cast<double>(i % static_cast<std::size_t>(width_));
    const auto y = static_cast<double>(i / static_cast<std::size_t>(width_));
    const Vec2d centre(x + 0.5, y + 0.5);
    const Rectangle& seen = rectangles_[slots_[i] - 1];
    const FilterPart part = filter_.part_within({seen.lower - centre, seen.upper - centre});
    if (part.share() > 0) views.push_back({static_cast<std::uint32_t>(i), part});
  }
  return views;
}

}  // namespace candela
