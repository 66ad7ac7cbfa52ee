// The lamps of the report: one point, uniform by area over all of them (docs/report.md, 3.1).
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/light/triangle_light.h"
#include "renderer/sampling/distribution.h"
#include "renderer/scene/scene.h"

namespace candela {

// Emitting triangles by their areas.
class EmitterTable {
 public:
  explicit EmitterTable(const Scene& scene) : table_(areas_of(scene)) {}

  [[nodiscard]] bool is_empty() const { return table_.is_empty(); }
  // `bits`: 32 random bits. Only where there are emitters.
  [[nodiscard]] std::uint32_t pick(std::uint32_t bits) const { return table_.pick(bits); }
  // The density by area of a light's points: 1 / (area of all lights), but for the rounding of
  // probabilities to multiples of 2^-32, with which it is exact.
  [[nodiscard]] float pdf_area(const Scene& scene, std::uint32_t light) const {
    return table_.probability(light) / scene.lights[light].area;
  }

 private:
  [[nodiscard]] static std::vector<double> areas_of(const Scene& scene) {
    std::vector<double> areas;
    for (const Light& light : scene.lights)
      areas.push_back(light.kind == LightKind::Triangle && !is_black(light.emission) ? light.area
                                                                                     : 0.0);
    return areas;
  }

  AliasTable table_;
};

}  // namespace candela
