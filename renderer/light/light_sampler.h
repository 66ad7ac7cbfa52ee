// Picks lights for next-event estimation.
//
// With at most `delta_limit` delta lights each of them is sampled at every hit, and one more light
// is picked by power among the rest (lights with an area, the environment). With more delta lights
// all are picked by power. Black lights are never picked, dim ones not less than every tenth of an
// equal share.
//
// Few lights are picked by inversion (light_ranges.h). Where there are cells (light_cells.h),
// lights are picked by what they may send to the point's cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/light/light.h"
#include "renderer/light/light_cells.h"
#include "renderer/light/light_ranges.h"
#include "renderer/sampling/distribution.h"

namespace candela {

struct LightPick {
  std::uint32_t light = 0;
  float probability = 0;  // > 0
  float rest = 0;         // of the number that chose, in [0, 1): see tells_rest()
};

class LightSampler {
 public:
  static constexpr std::size_t delta_limit = 4;

  LightSampler() = default;
  // `powers`: one a light, from light_power(); 0 or NaN: black.
  LightSampler(std::span<const Light> lights, std::span<const double> powers);

  // Lights that are sampled at every hit, beside the one that is picked.
  [[nodiscard]] const std::vector<std::uint32_t>& always() const { return always_; }

  // False where only `always` has lights, or nothing has.
  [[nodiscard]] bool has_table() const { return !table_.is_empty(); }

  // Lights that are picked by what they may send to a point: where all are finite, and not too few.
  // `box`: of all points that will be asked for.
  void make_cells(std::span<const Light> lights, const Bounds3f& box);

  [[nodiscard]] const LightCells& cells() const { return cells_; }
  [[nodiscard]] bool has_cells() const { return bounces_with_cells_ > 0; }
  // By which lights are picked where a path is after `bounce` bounces; everywhere: by power. Few
  // lights are, behind the first hit: there a pick by power is so cheap that the look into a cell
  // costs more than it brings.
  [[nodiscard]] std::uint32_t cell_of(const Vec3f& point, std::uint32_t bounce) const {
    return bounce < bounces_with_cells_ ? cells_.cell_of(point) : LightCells::everywhere;
  }

  // Whether pick() tells what is left of the number, 21 bits of it at least.
  [[nodiscard]] bool tells_rest() const { return !few_.is_empty() && !cells_.has_others(); }

  // By power. `bits`: 32 random bits (Sampler::sample_1d_bits). Only where has_table().
  [[nodiscard]] LightPick pick(std::uint32_t bits) const {
    if (few_.is_empty()) {
      const std::uint32_t light = table_.pick(bits);
      return {light, table_.probability(light)};
    }
    return pick_of(few_.pick(bits), bits);
  }
  // For the points of a cell. `u`: random, of the place on the light; where what the cell lists is
  // not picked, it has a say in which of all others is.
  [[nodiscard]] LightPick pick(std::uint32_t bits, std::uint32_t cell, Vec2f u) const {
    if (cell == LightCells::everywhere) return pick(bits);
    const LightRange& range = cells_.pick(bits, cell);
    return range.light == Light::none ? pick_other(bits, cell, u) : pick_of(range, bits);
  }
  // With which pick() gives this light; 0 for black ones and those in `always`.
  [[nodiscard]] float probability(std::uint32_t light,
                                  std::uint32_t cell = LightCells::everywhere) const {
    const float by_power = table_.probability(light);
    return cell == LightCells::everywhere ? by_power : cells_.probability(light, cell, by_power);
  }

 private:
  static LightPick pick_of(const LightRange& range, std::uint32_t bits) {
    return {range.light, range.probability, range.rest(bits)};
  }
  [[nodiscard]] LightPick pick_other(std::uint32_t bits, std::uint32_t cell, Vec2f u) const;
  void keep_few();

  std::vector<std::uint32_t> always_;
  std::vector<double> weights_;  // one a light; 0 for those in `always`
  AliasTable table_;             // by weight
  LightRanges few_;              // the same; empty where they are many
  LightCells cells_;             // empty where the place is not asked for
  std::uint32_t bounces_with_cells_ = 0;
};

}  // namespace candela
