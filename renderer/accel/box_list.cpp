#include "renderer/accel/box_list.h"

#include <algorithm>
#include <cmath>

#include "renderer/accel/placement.h"
#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"
#include "renderer/geometry/geometry_bounds.h"
#include "renderer/math/constants.h"

namespace candela {
namespace {

using Boxes = std::vector<Bounds3f>;

Boxes boxes_of(const Scene& scene, std::span<const GeometryHandle> geometries) {
  Boxes boxes;
  for (const GeometryHandle handle : geometries) {
    const Geometry& geometry = scene.geometries[handle.index];
    for (std::size_t i = 0; i < geometry.triangles.size(); ++i)
      if (const std::optional<Bounds3f> box = usable_box(geometry, i)) boxes.push_back(*box);
    for (const Sphere& sphere : geometry.spheres) boxes.push_back(bounds_of(sphere));
  }
  return boxes;
}

// Boxes next to each other in an array, and the box around all.
struct Group {
  Boxes::iterator begin, end;
  Bounds3f bounds;

  Group(Boxes::iterator first, Boxes::iterator last) : begin(first), end(last) {
    for (auto box = begin; box != end; ++box) bounds.include(*box);
  }
};

// At the middle of its longest side; false where all lie on one half of it.
bool split(std::vector<Group>& groups, std::size_t index) {
  const Group whole = groups[index];
  const Vec3f extent = whole.bounds.extent();
  const int axis = max_axis(extent);
  const float middle = whole.bounds.centre()[axis];
  const auto half = std::partition(
      whole.begin, whole.end, [&](const Bounds3f& box) { return box.centre()[axis] < middle; });
  if (half == whole.begin || half == whole.end) return false;
  groups[index] = Group(whole.begin, half);
  groups.emplace_back(half, whole.end);
  return true;
}

// The largest that can be is split until there are enough.
std::vector<Bounds3f> around(Boxes boxes) {
  if (boxes.empty()) return {};
  std::vector<Group> groups{{boxes.begin(), boxes.end()}};
  std::vector<bool> is_whole{false};  // and stays so
  while (groups.size() < BoxList::most_boxes) {
    std::size_t largest = groups.size();
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (!is_whole[i] && (largest == groups.size() ||
                           groups[i].bounds.surface_area() > groups[largest].bounds.surface_area()))
        largest = i;
    if (largest == groups.size()) break;
    if (split(groups, largest))
      is_whole.push_back(false);
    else
      is_whole[largest] = true;
  }
  std::vector<Bounds3f> bounds;
  for (const Group& group : groups) bounds.push_back(group.bounds);
  return bounds;
}

// One ray and one box [Williams05], with what rounding may do to the far end [Ize13].
inline float finite_inverse(float direction) {
  return 1 / std::copysign(std::max(std::abs(direction), 1e-30f), direction);
}
[[gnu::always_inline]] inline std::uint32_t enters(const Vec3f& origin, const Vec3f& inverse,
                                                   float t_max, const Vec3f& lower,
                                                   const Vec3f& upper) {
  Vec3f a = (lower - origin) * inverse;
  Vec3f b = (upper - origin) * inverse;
  const auto lesser = [](float s, float t) { return s < t ? s : t; };
  const auto greater = [](float s, float t) { return s > t ? s : t; };
  const float near =
      greater(greater(lesser(a.x, b.x), lesser(a.y, b.y)), greater(lesser(a.z, b.z), 0.0f));
  const float far = lesser(lesser(greater(a.x, b.x), greater(a.y, b.y)), greater(a.z, b.z));
  constexpr float wider = 1 + 2 * gamma_bound(3);
  return flag(near <= far * wider) & flag(near <= t_max * wider);
}

}  // namespace

BoxList::BoxList(const Scene& scene, std::span<const GeometryHandle> geometries) {
  constexpr float beyond = 1e8f;
  for (std::size_t i = 0; i < block_size; ++i) {
    lower_.set(i, Vec3f(beyond));
    upper_.set(i, Vec3f(beyond));
  }
  for (const Bounds3f& box : around(boxes_of(scene, geometries))) {
    // So that rays in a side's plane enter.
    const float wider =
        0x1p-22f * max_component(glm::max(glm::abs(box.lower), glm::abs(box.upper)));
    lower_.set(size_, box.lower - wider);
    upper_.set(size_, box.upper + wider);
    ++size_;
  }
}

LaneMask BoxList::entered(const RayBlock& rays, LaneMask lanes) const {
  const FloatingPointTraps traps(Traps::Off);  // lanes that no ray fills may hold anything
  return lanes & entered_lanes(rays);
}

CANDELA_LANES LaneMask BoxList::entered_lanes(const RayBlock& rays) const {
  Vec3Lanes inverse;
  for (std::size_t i = 0; i < block_size; ++i)
    inverse.set(i, {finite_inverse(rays.direction.x[i]), finite_inverse(rays.direction.y[i]),
                    finite_inverse(rays.direction.z[i])});
  LaneFlags flags{};
  for (std::size_t k = 0; k < size_; ++k) {
    const Vec3f lower = lower_[k];
    const Vec3f upper = upper_[k];
    for (std::size_t i = 0; i < block_size; ++i)
      flags[i] |= enters(rays.origin[i], inverse[i], rays.t_max[i], lower, upper);
  }
  return mask_of(flags);
}

CANDELA_LANES bool BoxList::is_entered(const Ray& ray) const {
  Vec3f origin = ray.origin;
  Vec3f inverse{finite_inverse(ray.direction.x), finite_inverse(ray.direction.y),
                finite_inverse(ray.direction.z)};
  const float t_max = ray.t_max;
  std::uint32_t any = 0;
  for (std::size_t k = 0; k < most_boxes; ++k)
    any |= enters(origin, inverse, t_max, lower_[k], upper_[k]);
  return any != 0;
}

}  // namespace candela
