#include "tests/light/finite_samples.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/light/sample_light.h"
#include "tests/light/directions.h"
#include "tests/light/met_lamp.h"

namespace candela::light_test {
namespace {

void expect_finite(const Light& light, const SurfacePoint& point, const Vec2f& u) {
  const LightSample s = sample_light({}, light, point, u);
  ASSERT_TRUE(is_finite(s.wi) && is_finite(s.radiance) && std::isfinite(s.pdf));
  ASSERT_GE(s.pdf, 0.0f);
  if (!s.is_valid()) return;
  ASSERT_NEAR(length(s.wi), 1, 1e-6);
  ASSERT_TRUE(is_finite(s.radiance / s.pdf));
}

}  // namespace

void expect_finite_samples(const Light& light, std::span<const Vec3f> points, std::uint64_t count) {
  const MetLamp lamp(light);
  for (const Vec3f& p : points)
    for (const Vec3f& normal : {Vec3f(0), Vec3f(0, 0, 1), Vec3f(1, 0, 0)}) {
      SurfacePoint point = at(p);
      point.receiving_normal = normal;
      const float met = lamp.pdf(p, normal, {0, 0, 1}, 1);
      ASSERT_TRUE(std::isfinite(met) && met >= 0);
      for (std::uint64_t i = 0; i < count; ++i) {
        expect_finite(light, point, i == 0 ? Vec2f(0) : random_pair(i, 20));
        if (testing::Test::HasFatalFailure()) return;
      }
    }
}

}  // namespace candela::light_test
