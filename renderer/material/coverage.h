// What an opacity means for visibility: nothing there, wholly there, or there for some rays.
#pragma once

#include <cstdint>

namespace candela {

enum class Coverage : std::uint8_t { Clear, Partial, Opaque };

// Of opacities between `low` and `high`. `is_lab`: below 0.2 is a hole, from 0.9 on solid
// (docs/scene_format.md).
[[nodiscard]] constexpr Coverage coverage_of_range(float low, float high, bool is_lab) {
  constexpr float lab_hole = 0.2f;
  constexpr float lab_solid = 0.9f;
  if (low >= (is_lab ? lab_solid : 1.0f)) return Coverage::Opaque;
  if (is_lab ? high < lab_hole : high <= 0) return Coverage::Clear;
  return Coverage::Partial;
}

}  // namespace candela
