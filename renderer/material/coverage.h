// What an opacity means for visibility: nothing there, wholly there, or there for some rays.
#pragma once

#include <cstdint>

namespace candela {

enum class Coverage : std::uint8_t { Clear, Partial, Opaque };

// lab3's: below the one a surface is a hole, from the other on solid (docs/scene_format.md); in
// whitted rays that are no shadow rays go on straight behind what is not solid.
inline constexpr float lab_hole_below = 0.2f;
inline constexpr float lab_solid_from = 0.9f;

// Of opacities between `low` and `high`. `is_lab`: by lab3's thresholds.
[[nodiscard]] constexpr Coverage coverage_of_range(float low, float high, bool is_lab) {
  if (low >= (is_lab ? lab_solid_from : 1.0f)) return Coverage::Opaque;
  if (is_lab ? high < lab_hole_below : high <= 0) return Coverage::Clear;
  return Coverage::Partial;
}

}  // namespace candela
