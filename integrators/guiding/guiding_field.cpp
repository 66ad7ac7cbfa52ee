#include "integrators/guiding/guiding_field.h"

#include <algorithm>

#include "integrators/guiding/fit_cell.h"

namespace candela {
namespace {

constexpr std::size_t most_records = 256;   // of a cell
constexpr std::size_t fewest_records = 32;  // of a side

int longest_axis(std::span<const TrainingRecord> records) {
  Vec3f low = records[0].position;
  Vec3f high = low;
  for (const TrainingRecord& record : records) {
    low = glm::min(low, record.position);
    high = glm::max(high, record.position);
  }
  return max_axis(high - low);
}

}  // namespace

GuidingField::GuidingField(std::span<const TrainingRecord> records) {
  std::array<std::vector<TrainingRecord>, receiving_sides> sides;
  for (const TrainingRecord& record : records)
    sides[receiving_side(record.receiving_normal)].push_back(record);
  for (std::size_t side = 0; side < receiving_sides; ++side) {
    if (sides[side].size() < fewest_records) continue;
    roots_[side] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    build(sides[side], roots_[side]);
  }
}

std::size_t GuidingField::guided_cells() const {
  return static_cast<std::size_t>(std::count_if(
      mixtures_.begin(), mixtures_.end(), [](const auto& mixture) { return mixture.share > 0; }));
}

// Halves of equally many records.
void GuidingField::build(std::span<TrainingRecord> records, std::uint32_t node) {
  if (records.size() <= most_records) {
    nodes_[node].next = static_cast<std::uint32_t>(mixtures_.size());
    mixtures_.push_back(fit_cell(records));
    return;
  }
  const int axis = longest_axis(records);
  const std::size_t half = records.size() / 2;
  const auto middle = records.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(records.begin(), middle, records.end(), [axis](const auto& a, const auto& b) {
    return a.position[axis] < b.position[axis];
  });
  const auto next = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {middle->position[axis], static_cast<std::uint32_t>(axis), next};
  nodes_.resize(nodes_.size() + 2);
  build(records.first(half), next);
  build(records.subspan(half), next + 1);
}

}  // namespace candela
