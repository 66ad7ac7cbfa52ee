#include "renderer/math/white_balance.h"

#include <algorithm>

#include "renderer/math/cie.h"

namespace candela {
namespace {

// XYZ -> Bradford's responses [Lam85]; GLM takes columns.
Mat3d bradford_matrix() {
  return {{0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296}};
}

// Of luminance 1.
Vec3d xyz_of(const Chromaticity& c) {
  return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

}  // namespace

Chromaticity daylight(double kelvins) {
  constexpr double constants_ratio = 1.4388 / 1.4380;
  const double t = std::clamp(kelvins, coolest_kelvins, hottest_kelvins) * constants_ratio;
  if (t < 4000) {
    const Vec3d xyz = xyz_of_light([&](double nanometres) { return black_body(nanometres, t); });
    const double sum = sum_of_components(xyz);
    return {xyz.x / sum, xyz.y / sum};
  }
  const double r = 1000 / t;
  const double x = t <= 7000 ? ((-4.6070 * r + 2.9678) * r + 0.09911) * r + 0.244063
                             : ((-2.0064 * r + 1.9018) * r + 0.24748) * r + 0.237040;
  return {x, (-3.000 * x + 2.870) * x - 0.275};
}

Mat3d white_balance(double kelvins) {
  const Mat3d responses_of_xyz = bradford_matrix();
  const Mat3d rgb_of_xyz(xyz_to_rgb({1, 0, 0}), xyz_to_rgb({0, 1, 0}), xyz_to_rgb({0, 0, 1}));
  const Mat3d xyz_of_rgb = glm::inverse(rgb_of_xyz);
  const Vec3d target = xyz_of_rgb * Vec3d(1.0);
  const Vec3d source = responses_of_xyz * xyz_of(daylight(kelvins));
  const Vec3d scale = responses_of_xyz * (target / target.y) / source;
  const Mat3d scaling(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z);
  return rgb_of_xyz * glm::inverse(responses_of_xyz) * scaling * responses_of_xyz * xyz_of_rgb;
}

}  // namespace candela
