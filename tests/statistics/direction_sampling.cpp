#include "tests/statistics/direction_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "renderer/sampling/hash.h"

namespace candela::statistics {
namespace {

constexpr double pi_value = 3.14159265358979323846;
constexpr int max_depth = 9;

struct Cell {
  double t0, t1, phi0, phi1;
};

// A density on the sphere in the grid's coordinates (t, phi), with the Jacobian
// sin(angle) d angle / dt.
class GridDensity {
 public:
  GridDensity(const DirectionDensity& density, const DirectionGrid& grid)
      : density_(density), frame_(frame_from_normal(grid.axis)), power_(grid.power) {}

  [[nodiscard]] double operator()(double t, double phi) const {
    const double angle = pi_value * std::pow(t, power_);
    const double sine = std::sin(angle);
    const Vec3d local{sine * std::cos(phi), sine * std::sin(phi), std::cos(angle)};
    const Vec3d world =
        Vec3d(frame_.x) * local.x + Vec3d(frame_.y) * local.y + Vec3d(frame_.z) * local.z;
    const double jacobian = sine * pi_value * power_ * std::pow(t, power_ - 1);
    return density_(Vec3f(world)) * jacobian;
  }

 private:
  const DirectionDensity& density_;
  Frame frame_;
  double power_;
};

// Gauss-Legendre with 3 x 3 points: inner points only, so that a density that jumps at a cell's
// border is seen on one side.
double gauss(const GridDensity& density, const Cell& cell) {
  constexpr std::array<double, 3> nodes = {-0.7745966692414834, 0, 0.7745966692414834};
  constexpr std::array<double, 3> weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const double dt = cell.t1 - cell.t0;
  const double dphi = cell.phi1 - cell.phi0;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      sum += weights[i] * weights[j] *
             density(cell.t0 + 0.5 * dt * (1 + nodes[i]), cell.phi0 + 0.5 * dphi * (1 + nodes[j]));
  return sum * dt * dphi;
}

// True where the density is 0 at one corner and positive at another: the horizon runs through, and
// Gauss' points may lie on one side of it.
bool is_cut(const GridDensity& density, const Cell& cell) {
  int zeros = 0;
  for (const double t : {cell.t0, cell.t1})
    for (const double phi : {cell.phi0, cell.phi1}) zeros += density(t, phi) == 0 ? 1 : 0;
  return zeros != 0 && zeros != 4;
}

// Quarters cells until the quarters together agree with the whole.
double integrate(const GridDensity& density, const Cell& cell, double whole, double tolerance,
                 int depth) {
  const double t = 0.5 * (cell.t0 + cell.t1);
  const double phi = 0.5 * (cell.phi0 + cell.phi1);
  const std::array<Cell, 4> quarters = {
      Cell{cell.t0, t, cell.phi0, phi}, Cell{t, cell.t1, cell.phi0, phi},
      Cell{cell.t0, t, phi, cell.phi1}, Cell{t, cell.t1, phi, cell.phi1}};
  std::array<double, 4> values{};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += values[i] = gauss(density, quarters[i]);
  if (depth == 0) return sum;
  const bool is_settled = std::abs(sum - whole) <= tolerance;
  if (is_settled && (depth <= max_depth - 4 || !is_cut(density, cell))) return sum;
  sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    sum += integrate(density, quarters[i], values[i], 0.5 * tolerance, depth - 1);
  return sum;
}

std::size_t cell_of(const Vec3f& direction, const Frame& frame, const DirectionGrid& grid) {
  const Vec3d d(direction);
  const double x = dot(d, Vec3d(frame.x));
  const double y = dot(d, Vec3d(frame.y));
  const double z = dot(d, Vec3d(frame.z));
  const double angle = std::atan2(std::sqrt(x * x + y * y), z);
  double phi = std::atan2(y, x) / (2 * pi_value);
  if (phi < 0) phi += 1;
  const double t = std::pow(angle / pi_value, 1 / grid.power);
  const int ring = std::clamp(static_cast<int>(t * grid.rings), 0, grid.rings - 1);
  const int sector = std::clamp(static_cast<int>(phi * grid.sectors), 0, grid.sectors - 1);
  return static_cast<std::size_t>(ring * grid.sectors + sector);
}

}  // namespace

std::vector<double> integrate_cells(const DirectionDensity& density, const DirectionGrid& grid) {
  const GridDensity on_grid(density, grid);
  std::vector<double> integrals;
  for (int ring = 0; ring < grid.rings; ++ring)
    for (int sector = 0; sector < grid.sectors; ++sector) {
      const Cell cell{
          static_cast<double>(ring) / grid.rings, static_cast<double>(ring + 1) / grid.rings,
          2 * pi_value * sector / grid.sectors, 2 * pi_value * (sector + 1) / grid.sectors};
      integrals.push_back(
          integrate(on_grid, cell, gauss(on_grid, cell), integration_tolerance, max_depth));
    }
  return integrals;
}

double integrate_sphere(const DirectionDensity& density, const DirectionGrid& grid) {
  const std::vector<double> cells = integrate_cells(density, grid);
  return std::accumulate(cells.begin(), cells.end(), 0.0);
}

DirectionTestResult test_directions(const DirectionSampler& sampler,
                                    const DirectionDensity& density, const DirectionGrid& grid,
                                    std::uint64_t seed, int count) {
  std::vector<double> expected = integrate_cells(density, grid);
  std::vector<double> observed(expected.size() + 1);
  const Frame frame = frame_from_normal(grid.axis);
  std::uint64_t state = mix_bits(seed);
  const auto random = [&state] {
    state += 0x9e3779b97f4a7c15ull;
    return unit_float(static_cast<std::uint32_t>(mix_bits(state) >> 32));
  };
  for (int i = 0; i < count; ++i) {
    const float first = random();
    const float second = random();
    const std::optional<Vec3f> direction = sampler(first, {second, random()});
    ++observed[direction ? cell_of(*direction, frame, grid) : expected.size()];
  }
  DirectionTestResult result;
  result.integral = std::accumulate(expected.begin(), expected.end(), 0.0);
  result.accepted_fraction = 1 - observed.back() / count;
  // Never quite 0: one sample in a thousand million may be rejected for rounding.
  expected.push_back(std::max(1e-9, 1 - result.integral));
  for (double& e : expected) e *= count;
  result.chi_square = chi_square_test(observed, expected);
  return result;
}

}  // namespace candela::statistics
