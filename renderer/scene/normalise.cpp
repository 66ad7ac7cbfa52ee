#include "renderer/scene/normalise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "renderer/math/bounds.h"

namespace candela {
namespace {

using description::SceneDescription;

constexpr std::size_t most_points_an_instance = 4096;

// The box of a placed sphere, by its corners.
void append_corners(const description::Sphere& sphere, const Transform& object_to_world,
                    std::vector<Vec3d>& points) {
  const Vec3d half(sphere.radius * similarity_scale(object_to_world));
  const Bounds3d box{-half, half};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p = object_to_world.translation + box.corner(corner);
    if (is_finite(p)) points.push_back(p);
  }
}

// What is placed at once: its part of a list of points.
struct Primitive {
  std::size_t begin = 0, end = 0;
  bool is_sphere = false;

  // A sphere's corners are of one place.
  [[nodiscard]] std::size_t votes() const { return is_sphere ? 1 : end - begin; }
};

// How many vertices of each instance are enough for a sample of them all.
std::size_t points_an_instance(const SceneDescription& description) {
  constexpr std::size_t fewest = 8, most_of_all = std::size_t{1} << 20;
  const std::size_t instances = std::max<std::size_t>(description.instances.size(), 1);
  return std::max(fewest, std::min(most_points_an_instance, most_of_all / instances));
}

// From one vertex of a sample to the next.
std::size_t stride_of(const std::vector<Vec3d>& positions, std::size_t most) {
  return std::max<std::size_t>(1, positions.size() / most);
}

// A sample of the vertices in world space, evenly strided, and which of them are which instance's.
std::vector<Vec3d> sampled_points(const SceneDescription& description,
                                  std::vector<Primitive>& primitives) {
  std::vector<Vec3d> points;
  const std::size_t most = points_an_instance(description);
  for (const description::Instance& instance : description.instances) {
    const description::Mesh& mesh = description.meshes[instance.mesh.index];
    const std::size_t begin = points.size();
    if (mesh.sphere) append_corners(*mesh.sphere, instance.object_to_world, points);
    const auto& positions = mesh.positions;
    const std::size_t stride = stride_of(positions, most);
    for (std::size_t i = 0; i < positions.size(); i += stride) {
      const Vec3d p = instance.object_to_world.point(positions[i]);
      if (is_finite(p)) points.push_back(p);
    }
    primitives.push_back({begin, points.size(), mesh.sphere.has_value()});
  }
  return points;
}

Bounds3d bounds_of(const std::vector<Vec3d>& positions) {
  Bounds3d bounds;
  for (const Vec3d& position : positions)
    if (is_finite(position)) bounds.include(position);
  return bounds;
}

// Whether no point of the placed box can be outside of `bounds`, whatever rounding does to it.
bool is_well_within(const Bounds3d& bounds, const Bounds3d& box, const Transform& object_to_world) {
  const Vec3d margin = 1e-12 * bounds.extent();
  const Vec3d lower = bounds.lower + margin, upper = bounds.upper - margin;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p = object_to_world.point(box.corner(corner));
    for (int axis = 0; axis < 3; ++axis)
      if (!(p[axis] >= lower[axis] && p[axis] <= upper[axis])) return false;
  }
  return true;
}

// The box of all vertices, exactly: a stride must not miss a corner. Of many instances of a large
// mesh most are inside of what the others span, and their vertices need no look. `points` are not
// of the instance `left_out`.
Bounds3d full_bounds(const SceneDescription& description, const std::vector<Vec3d>& points,
                     std::optional<std::size_t> left_out) {
  const std::size_t most = points_an_instance(description);
  Bounds3d bounds;
  for (const Vec3d& p : points) bounds.include(p);
  std::vector<std::optional<Bounds3d>> boxes(description.meshes.size());
  for (std::size_t i = 0; i < description.instances.size(); ++i) {
    const description::Instance& instance = description.instances[i];
    const auto& positions = description.meshes[instance.mesh.index].positions;
    if (stride_of(positions, most) == 1 || i == left_out) continue;
    std::optional<Bounds3d>& box = boxes[instance.mesh.index];
    if (!box) box = bounds_of(positions);
    if (!box->is_empty() && is_well_within(bounds, *box, instance.object_to_world)) continue;
    for (const Vec3d& position : positions) {
      const Vec3d p = instance.object_to_world.point(position);
      if (is_finite(p)) bounds.include(p);
    }
  }
  return bounds;
}

// How far apart two boxes are on the axis on which they are farthest; negative where they overlap.
double gap(const Bounds3d& a, const Bounds3d& b) {
  return max_component(glm::max(a.lower - b.upper, b.lower - a.upper));
}

// The boxes of all primitives but one, by that one.
std::vector<Bounds3d> boxes_of_others(const std::vector<Bounds3d>& boxes) {
  std::vector<Bounds3d> others(boxes.size());
  Bounds3d before;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    others[i] = before;
    before.include(boxes[i]);
  }
  Bounds3d after;
  for (std::size_t i = boxes.size(); i-- > 0;) {
    others[i].include(after);
    after.include(boxes[i]);
  }
  return others;
}

// The one instance that is so far from all others that these would lose their digits to it, a sun
// that is a mesh or a sphere: the one of fewest points where two lie like that. None beside which
// the others are crumbs, narrower than its floats tell and near for its size: a floor below a speck
// is the scene, a planet below a plate is not.
std::optional<std::size_t> far_primitive(const std::vector<Vec3d>& points,
                                         const std::vector<Primitive>& primitives) {
  constexpr double farthest = 1e4;
  constexpr double widest = 1e11;  // a plate of a hand's width is 10^-8 of a planet
  constexpr std::size_t few = 64;
  std::vector<Bounds3d> boxes(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i)
    for (std::size_t k = primitives[i].begin; k < primitives[i].end; ++k)
      boxes[i].include(points[k]);
  const std::vector<Bounds3d> others = boxes_of_others(boxes);
  std::optional<std::size_t> far;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (boxes[i].is_empty() || others[i].is_empty()) continue;
    const double extent = max_component(others[i].extent());
    const double distance = gap(boxes[i], others[i]);
    if (!(extent > 0) || !(distance > farthest * extent)) continue;
    const double own_extent = max_component(boxes[i].extent());
    if (own_extent > widest * extent && own_extent > 4 * distance) continue;
    const std::size_t votes = primitives[i].votes();
    if (votes > std::max(few, points.size() / 2)) continue;
    if (!far || votes < primitives[*far].votes()) far = i;
  }
  return far;
}

// The box without the outermost hundredth of the points at either end of each axis, and without
// three points (a triangle) at least.
Bounds3d inner_bounds(std::vector<Vec3d> points) {
  Bounds3d bounds;
  const std::size_t cut =
      std::min(std::max<std::size_t>(3, points.size() / 100), (points.size() - 1) / 2);
  for (int axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const Vec3d& a, const Vec3d& b) { return a[axis] < b[axis]; };
    const auto low = points.begin() + static_cast<std::ptrdiff_t>(cut);
    const auto high = points.end() - 1 - static_cast<std::ptrdiff_t>(cut);
    std::nth_element(points.begin(), low, points.end(), less);
    bounds.lower[axis] = (*low)[axis];
    std::nth_element(points.begin(), high, points.end(), less);
    bounds.upper[axis] = (*high)[axis];
  }
  return bounds;
}

// Whether a quarter of the points lie in `box` or no farther from it than `ratio` times its extent.
// Of the few corners of a diamond none lies near the box of what is between on each axis by itself.
bool are_often_near(const Bounds3d& box, double ratio, const std::vector<Vec3d>& points) {
  const Vec3d reach(ratio * max_component(box.extent()));
  const auto is_near = [&](const Vec3d& p) {
    return glm::all(glm::greaterThanEqual(p, box.lower - reach)) &&
           glm::all(glm::lessThanEqual(p, box.upper + reach));
  };
  return 4 * std::count_if(points.begin(), points.end(), is_near) >=
         static_cast<std::ptrdiff_t>(points.size());
}

// `points` are some of what `full` bounds.
Normalisation normalisation_of(const Bounds3d& full, const std::vector<Vec3d>& points) {
  constexpr double most_ratio = 100;
  Bounds3d bounds = full;
  const Bounds3d inner = inner_bounds(points);
  if (max_component(full.extent()) > most_ratio * max_component(inner.extent()) &&
      max_component(inner.extent()) > 0 && are_often_near(inner, most_ratio, points))
    bounds = inner;
  const double half_extent = 0.5 * max_component(bounds.extent());
  if (!(half_extent > 0) || !std::isfinite(half_extent)) return {bounds.centre(), 1.0};
  int exponent = 0;
  (void)std::frexp(half_extent, &exponent);
  return {bounds.centre(), std::ldexp(1.0, -exponent)};
}

}  // namespace

Normalisation normalisation_of(const SceneDescription& description) {
  std::vector<Primitive> primitives;
  std::vector<Vec3d> points = sampled_points(description, primitives);
  if (points.empty()) return {};
  const std::optional<std::size_t> far = far_primitive(points, primitives);
  if (far) {
    const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
    points.erase(at(primitives[*far].begin), at(primitives[*far].end));
  }
  const Bounds3d bounds = full_bounds(description, points, far);
  return normalisation_of(bounds, points);
}

Normalisation normalisation_of(const description::Mesh& mesh) {
  Bounds3d bounds;
  std::vector<Vec3d> points;
  if (mesh.sphere) append_corners(*mesh.sphere, {}, points);
  for (const Vec3d& corner : points) bounds.include(corner);
  const std::size_t stride = stride_of(mesh.positions, most_points_an_instance);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!is_finite(mesh.positions[i])) continue;
    bounds.include(mesh.positions[i]);
    if (i % stride == 0) points.push_back(mesh.positions[i]);
  }
  return points.empty() ? Normalisation{} : normalisation_of(bounds, points);
}

Rgb normalised_intensity(const Normalisation& n, const Vec3d& intensity) {
  constexpr double largest = std::numeric_limits<float>::max();
  const Vec3d scaled = intensity * (n.scale * n.scale);
  return max_component(scaled) <= largest ? Rgb(scaled) : Rgb(infinity);
}

}  // namespace candela
