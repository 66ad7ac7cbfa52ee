// A colour map whose steps look equally large: a path through Oklab.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/image/compare.h"

namespace candela {
namespace {

// Oklab to linear Rec.709 [Ottosson20].
std::array<double, 3> from_oklab(double lightness, double a, double b) {
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool is_displayable(const std::array<double, 3>& colour) {
  return std::ranges::all_of(colour, [](double v) { return v >= 0 && v <= 1; });
}

}  // namespace

// Chroma is as large as the display allows, up to 0.13, and none at both ends; bringing it down
// leaves lightness and hue as they are.
std::array<float, 3> heat_colour(double place) {
  const double t = std::clamp(place, 0.0, 1.0);
  const double hue = (310 - 200 * t) * std::numbers::pi / 180;  // violet, blue, green, yellow
  double chroma = 0.13 * std::sqrt(std::sin(std::numbers::pi * t) + 1e-12);
  std::array<double, 3> colour = from_oklab(t, chroma * std::cos(hue), chroma * std::sin(hue));
  while (!is_displayable(colour) && chroma > 1e-4) {
    chroma *= 0.98;
    colour = from_oklab(t, chroma * std::cos(hue), chroma * std::sin(hue));
  }
  std::array<float, 3> result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = static_cast<float>(std::clamp(colour[c], 0.0, 1.0));
  return result;
}

}  // namespace candela
