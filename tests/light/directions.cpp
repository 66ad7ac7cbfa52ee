#include "tests/light/directions.h"

#include <vector>

#include "renderer/math/constants.h"
#include "renderer/sampling/hash.h"
#include "tests/statistics/chi_square.h"

namespace candela::light_test {

float random_unit(std::uint64_t i, std::uint64_t stream) {
  return unit_float(static_cast<std::uint32_t>(hash_combine(stream, i) >> 32));
}

Vec2f random_pair(std::uint64_t i, std::uint64_t stream) {
  return {random_unit(i, 2 * stream), random_unit(i, 2 * stream + 1)};
}

Vec3f random_direction(std::uint64_t i, std::uint64_t stream) {
  const Vec2f u = random_pair(i, stream);
  return Cap{}.direction(static_cast<double>(u.x), static_cast<double>(u.y));
}

double Cap::solid_angle() const {
  return 2 * pi_double * (1 - cos_min);
}

Vec3f Cap::direction(double a, double b) const {
  const double z = 1 - a * (1 - cos_min);
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = 2 * pi_double * b;
  return normalize(frame.to_world(Vec3f(Vec3d(r * std::cos(phi), r * std::sin(phi), z))));
}

std::optional<Vec2d> Cap::coordinates(const Vec3f& direction) const {
  const Vec3d d(direction);
  const Vec3d local(dot(d, Vec3d(frame.x)), dot(d, Vec3d(frame.y)), dot(d, Vec3d(frame.z)));
  const double r2 = local.x * local.x + local.y * local.y;
  const double all = std::sqrt(r2 + local.z * local.z);
  const double versine = local.z > 0 ? r2 / (all * (all + local.z)) : 1 - local.z / all;
  const double a = versine / (1 - cos_min);
  if (!(a >= 0 && a < 1)) return std::nullopt;
  const double turn = std::atan2(local.y, local.x) / (2 * pi_double);
  return Vec2d(a, turn < 0 ? turn + 1 : turn);
}

double integral(const Cap& cap, int steps, const DirectionFunction& f) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) sum += f(cap.direction((i + 0.5) / steps, (j + 0.5) / steps));
  return sum * cap.solid_angle() / (static_cast<double>(steps) * steps);
}

statistics::Moments random_integral(const Cap& cap, std::uint64_t count,
                                    const DirectionFunction& f) {
  statistics::Moments moments;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec2d u(random_pair(i, 2));
    moments.add(f(cap.direction(u.x, u.y)) * cap.solid_angle());
  }
  return moments;
}

namespace {

// The density's integral over bin (i, j), by 16 x 16 midpoints; 0 where it vanishes at one.
double bin_mass(const Cap& cap, int bins, int i, int j, const DirectionFunction& pdf) {
  constexpr int steps = 16;
  const double fine = bins * steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k)
    for (int l = 0; l < steps; ++l) {
      const double density =
          pdf(cap.direction((i * steps + k + 0.5) / fine, (j * steps + l + 0.5) / fine));
      if (!(density > 0)) return 0;
      sum += density;
    }
  return sum * cap.solid_angle() / (fine * fine);
}

}  // namespace

double chi_square_p_value(const Cap& cap, int bins, std::uint64_t count,
                          const DirectionSampler& sample, const DirectionFunction& pdf) {
  std::vector<double> expected;
  double inside = 0;
  for (int i = 0; i < bins; ++i)
    for (int j = 0; j < bins; ++j) {
      const double mass = j + 1 < bins ? bin_mass(cap, bins, i, j, pdf) : 0;
      inside += mass;
      expected.push_back(mass * static_cast<double>(count));
    }
  const std::size_t shared_cell = expected.size();
  expected.push_back(std::max(0.0, 1 - inside) * static_cast<double>(count));
  std::vector<double> observed(expected.size(), 0.0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::optional<Vec3f> direction = sample(random_pair(i, 1));
    const std::optional<Vec2d> at = direction ? cap.coordinates(*direction) : std::nullopt;
    const auto bin = [&](double x) { return std::min(static_cast<int>(x * bins), bins - 1); };
    std::size_t cell = at ? static_cast<std::size_t>(bin(at->x) * bins + bin(at->y)) : shared_cell;
    if (!(expected[cell] > 0)) cell = shared_cell;
    observed[cell] += 1;
  }
  return statistics::chi_square_test(observed, expected).p_value;
}

double lambert_irradiance(const std::vector<Vec3d>& polygon, const Vec3d& p, const Vec3d& n) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d a = normalize(polygon[i] - p);
    const Vec3d b = normalize(polygon[(i + 1) % polygon.size()] - p);
    sum += std::acos(dot(a, b)) * dot(normalize(cross(a, b)), n);
  }
  return std::abs(sum) / 2;
}

}  // namespace candela::light_test
