// Tests of samplers of directions: the density's integral by adaptive quadrature, and a chi-square
// test of a million directions against it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "renderer/math/frame.h"
#include "tests/statistics/chi_square.h"

namespace candela::statistics {

// Cells of the sphere about `axis`: rings of equal steps of t in [0, 1], angle = pi t^power, so
// that a power of 3 or 4 resolves a narrow lobe about the axis. Rings times sectors cells.
struct DirectionGrid {
  Vec3f axis{0, 0, 1};
  int rings = 24;
  int sectors = 32;
  double power = 1;
};

// Three independent numbers in [0, 1) -> a direction, or none where the sampler rejects.
using DirectionSampler = std::function<std::optional<Vec3f>(float, Vec2f)>;
// In solid angle.
using DirectionDensity = std::function<double(const Vec3f&)>;

struct DirectionTestResult {
  double integral = 0;           // of the density over the sphere
  double accepted_fraction = 0;  // of the samples
  ChiSquareResult chi_square;    // cells and, as one more, the rejected samples
};

// The density's integral over each cell, ring by ring; each to about this error.
inline constexpr double integration_tolerance = 1e-7;
[[nodiscard]] std::vector<double> integrate_cells(const DirectionDensity& density,
                                                  const DirectionGrid& grid);
[[nodiscard]] double integrate_sphere(const DirectionDensity& density, const DirectionGrid& grid);

[[nodiscard]] DirectionTestResult test_directions(const DirectionSampler& sampler,
                                                  const DirectionDensity& density,
                                                  const DirectionGrid& grid, std::uint64_t seed,
                                                  int count = 1'000'000);

}  // namespace candela::statistics
