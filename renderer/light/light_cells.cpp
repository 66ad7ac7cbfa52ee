#include "renderer/light/light_cells.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/parallel.h"
#include "renderer/light/dim_lights.h"
#include "renderer/sampling/distribution.h"

namespace candela {
namespace {

// Of a list, with what stands for the others.
constexpr std::size_t most_ranges = 512;

// Lights by cells that are looked at, and ranges that are kept: some hundredths of a second, some
// megabytes.
constexpr double most_looks = 1 << 20;
constexpr double most_kept = 1 << 18;

struct Grid {
  Vec3d lower{0};
  Vec3d size{0};  // of a cell
  glm::u32vec3 counts{1};
};

// Of cells that are as near to cubes as may be.
Grid grid_over(const Bounds3f& box, double lights) {
  const double kept = std::min(lights, static_cast<double>(most_ranges));
  const double cells = std::max(std::min(most_looks / lights, most_kept / kept), 1.0);
  Vec3d extent(box.extent());
  extent = glm::max(extent, Vec3d(1e-3 * max_component(extent)));
  double size = std::cbrt(extent.x * extent.y * extent.z / cells);
  Vec3d counts;
  const auto count = [&] {
    counts = glm::clamp(glm::floor(extent / size), Vec3d(1), Vec3d(64));
    return counts.x * counts.y * counts.z;
  };
  // A flat box has one cell across, and would have too many along it.
  while (count() > cells) size *= 1.05;
  return {Vec3d(box.lower), extent / counts, glm::u32vec3(counts)};
}

// A little more than the cell: points are rounded before they are asked for.
Bounds3d box_of(const Grid& grid, std::uint32_t index) {
  const std::uint32_t x = index % grid.counts[0];
  const std::uint32_t y = index / grid.counts[0] % grid.counts[1];
  const std::uint32_t z = index / grid.counts[0] / grid.counts[1];
  const Vec3d lower = grid.lower + Vec3d(x, y, z) * grid.size;
  const Vec3d margin = 1e-3 * grid.size;
  Bounds3d box;
  box.include(lower - margin);
  box.include(lower + grid.size + margin);
  return box;
}

bool is_flat(const Light& light) {
  return !light.is_delta() && light.kind != LightKind::Sphere;
}

Vec3d middle_of(const Light& light) {
  const Vec3d edges = Vec3d(light.edge1) + Vec3d(light.edge2);
  if (!is_flat(light)) return Vec3d(light.position);
  return Vec3d(light.position) + edges / (light.kind == LightKind::Quad ? 2.0 : 3.0);
}

// Whether no point of the box is in front of the light.
bool is_behind(const Bounds3d& box, const Light& light) {
  if (!is_flat(light) || light.emits_both_sides) return false;
  const Vec3d normal(light.normal);
  Vec3d farthest;
  for (int axis = 0; axis < 3; ++axis)
    farthest[axis] = normal[axis] > 0 ? box.upper[axis] : box.lower[axis];
  return dot(normal, farthest - Vec3d(light.position)) <= 0;
}

// The largest cosine at the light of the directions to points of a ball [Conty18].
double largest_cosine(const Light& light, const Vec3d& to_ball, double distance, double radius) {
  if (!is_flat(light) || distance <= radius) return 1;
  double cosine = dot(Vec3d(light.normal), to_ball) / distance;
  if (light.emits_both_sides) cosine = std::abs(cosine);
  const double ball_sine = radius / distance;
  const double ball_cosine = std::sqrt(1 - square(ball_sine));
  if (cosine >= ball_cosine) return 1;
  const double sine = std::sqrt(std::max(1 - square(cosine), 0.0));
  return std::max(cosine * ball_cosine + sine * ball_sine, 0.0);
}

// What a light may send to the points of a box.
double importance_of(const Light& light, double weight, const Bounds3d& box) {
  if (is_behind(box, light)) return 0;
  const Vec3d to_ball = box.centre() - middle_of(light);
  const double distance = length(to_ball);
  const double radius = 0.5 * length(box.extent());
  constexpr double least_cosine = 0.01;  // of a light that is not wholly behind
  const double cosine = std::max(largest_cosine(light, to_ball, distance, radius), least_cosine);
  return weight * cosine / square(std::max(distance, radius));
}

// The importance that `count` of the largest are above; 0 where there are not so many.
double threshold_of(std::vector<double> importance, std::size_t count) {
  if (importance.size() <= count) return 0;
  const auto nth = importance.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(importance.begin(), nth, importance.end(), std::greater<>());
  return *nth;
}

}  // namespace

// `lights` may send something to the cell, in proportion to their `importance`.
LightCells::Cell LightCells::cell_with(std::span<const std::uint32_t> lights,
                                       const std::vector<double>& importance,
                                       std::span<const float> probabilities) {
  const double threshold = threshold_of(importance, most_ranges - 1);
  std::vector<std::uint32_t> listed;
  std::vector<double> weights;
  double others = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (importance[i] > threshold) {
      listed.push_back(lights[i]);
      weights.push_back(importance[i]);
    } else {
      others += importance[i];
    }
  }
  if (others > 0) {
    listed.push_back(Light::none);
    weights.push_back(others);
  }
  constexpr double least_share = 1.0 / (1 << 10);  // leaves 21 bits of the number that picks it
  lift_dim_lights(weights, least_share);
  const std::vector<std::uint64_t> steps = proportional_steps(weights, std::uint64_t{1} << 32);
  const auto probability_of = [](std::uint64_t n) { return static_cast<float>(n) * 0x1p-32f; };
  Cell cell;
  if (others > 0) cell.others = probability_of(steps.back());
  std::vector<LightRange> ranges;
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    float probability = probability_of(steps[i]);
    if (listed[i] != Light::none) probability += cell.others * probabilities[listed[i]];
    ranges.push_back({static_cast<std::uint32_t>(first), listed[i],
                      1 / static_cast<float>(steps[i]), probability});
    first += steps[i];
  }
  cell.list = LightRanges(std::move(ranges));
  return cell;
}

LightCells::LightCells(std::span<const Light> lights, std::span<const double> weights,
                       std::span<const float> probabilities, const Bounds3f& box) {
  std::vector<std::uint32_t> picked;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (weights[i] > 0) picked.push_back(i);
  const Grid grid = grid_over(box, static_cast<double>(picked.size()));
  lower_ = Vec3f(grid.lower);
  inverse_size_ = Vec3f(1.0 / grid.size);
  for (int axis = 0; axis < 3; ++axis) last_[axis] = static_cast<float>(grid.counts[axis] - 1);
  stride_y_ = grid.counts[0];
  stride_z_ = grid.counts[0] * grid.counts[1];
  cells_.resize(static_cast<std::size_t>(stride_z_) * grid.counts[2]);
  parallel_for(cells_.size(), [&](std::size_t c) {
    const Bounds3d cell = box_of(grid, static_cast<std::uint32_t>(c));
    std::vector<std::uint32_t> reaching;
    std::vector<double> importance;
    for (const std::uint32_t i : picked) {
      const double of_light = importance_of(lights[i], weights[i], cell);
      if (of_light == 0) continue;
      reaching.push_back(i);
      importance.push_back(of_light);
    }
    if (reaching.empty()) {  // something must be picked
      reaching = picked;
      for (const std::uint32_t i : picked) importance.push_back(weights[i]);
    }
    cells_[c] = cell_with(reaching, importance, probabilities);
  });
  has_others_ = std::ranges::any_of(cells_, [](const Cell& cell) { return cell.others > 0; });
}

float LightCells::probability(std::uint32_t light, std::uint32_t cell, float by_power) const {
  const std::span<const LightRange> ranges = cells_[cell].list.ranges();
  const auto at = std::ranges::lower_bound(ranges, light, {}, &LightRange::light);
  if (at != ranges.end() && at->light == light) return at->probability;
  return cells_[cell].others * by_power;
}

}  // namespace candela
