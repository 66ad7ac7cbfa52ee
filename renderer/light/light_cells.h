// Which lights matter where: the scene's box is cut into cells, each of which knows the lights that
// may send most to its points, by power, distance and the side that they face.
//
// A pick takes a look into the cell's list; the importance of a light is that of a light tree's
// leaf [Conty18], but cells are asked beforehand. Lights that all of a cell is behind are not
// listed. Of many lights a list has the most important; what is left is shared by all by power.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/light/light.h"
#include "renderer/light/light_ranges.h"
#include "renderer/math/bounds.h"

namespace candela {

class LightCells {
 public:
  static constexpr std::uint32_t everywhere = 0xffffffffu;  // no cell

  LightCells() = default;
  // `weights`: one a light, by power; 0: never picked, and all others have a place.
  // `probabilities`: with which lights are picked that a list lacks. `box`: of all points that will
  // be asked for.
  LightCells(std::span<const Light> lights, std::span<const double> weights,
             std::span<const float> probabilities, const Bounds3f& box);

  [[nodiscard]] std::size_t count() const { return cells_.size(); }
  // Whether some list lacks lights that may send something to its cell.
  [[nodiscard]] bool has_others() const { return has_others_; }

  [[nodiscard]] std::uint32_t cell_of(const Vec3f& point) const {
    const Vec3f place = (point - lower_) * inverse_size_;
    const auto along = [&](int axis) {
      return static_cast<std::uint32_t>(std::clamp(place[axis], 0.0f, last_[axis]));
    };
    return along(0) + stride_y_ * along(1) + stride_z_ * along(2);
  }

  // Its light is Light::none for those that the cell's list lacks.
  [[nodiscard]] const LightRange& pick(std::uint32_t bits, std::uint32_t cell) const {
    return cells_[cell].list.pick(bits);
  }
  // With which a light is picked in a cell. `by_power`: with which it is picked where the list
  // lacks it.
  [[nodiscard]] float probability(std::uint32_t light, std::uint32_t cell, float by_power) const;

 private:
  struct Cell {
    LightRanges list;  // by light; last, if there are any, the others
    float others = 0;  // the probability of them all
  };
  static Cell cell_with(std::span<const std::uint32_t> lights,
                        const std::vector<double>& importance,
                        std::span<const float> probabilities);

  std::vector<Cell> cells_;
  Vec3f lower_{0};
  Vec3f inverse_size_{0};
  Vec3f last_{0};  // cells along each axis but one
  std::uint32_t stride_y_ = 0;
  std::uint32_t stride_z_ = 0;
  bool has_others_ = false;
};

}  // namespace candela
