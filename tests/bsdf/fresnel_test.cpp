#include "renderer/bsdf/fresnel.h"

#include <gtest/gtest.h>

#include <complex>
#include <limits>

#include "renderer/base/floating_point_traps.h"
#include "renderer/math/constants.h"
#include "tests/bsdf/reference_bsdf.h"

namespace candela {
namespace {

using tests::exact_fresnel;

TEST(Unit_Fresnel, DielectricMatchesTheAmplitudes) {
  for (const float eta : {1.0001f, 1.33f, 1.5f, 2.4f, 1000.0f, 1 / 1.33f, 0.5f})
    for (int i = 1; i <= 1000; ++i) {
      const float cos_theta = static_cast<float>(i) / 1000;
      const DielectricFresnel fresnel = fresnel_dielectric(cos_theta, eta);
      ASSERT_NEAR(fresnel.reflectance, exact_fresnel(cos_theta, {eta, -1e-30}), 2e-5)
          << eta << " " << cos_theta;
    }
}

TEST(Unit_Fresnel, ConductorMatchesTheAmplitudes) {
  for (const float eta : {0.05f, 0.2f, 1.0f, 3.0f})
    for (const float k : {0.0f, 0.5f, 3.9f, 100.0f})
      for (int i = 1; i <= 1000; ++i) {
        const float cos_theta = static_cast<float>(i) / 1000;
        ASSERT_NEAR(fresnel_conductor(cos_theta, eta, k),
                    exact_fresnel(cos_theta, {eta, -static_cast<double>(k)}), 1e-4)
            << eta << " " << k << " " << cos_theta;
      }
}

// As far as floats reach: squares of eta and k do not.
TEST(Unit_Fresnel, ConductorsThatAbsorbAllAtOnceAreMirrors) {
  for (const float k : {1e8f, 4.2e9f, 5e9f, 1e15f, 1.8e19f, 1e20f, 3e38f})
    for (const float eta : {0.5f, 1.0f, 2.0f})
      for (const float cos_theta : {1.0f, 0.5f, 1e-3f})
        EXPECT_NEAR(fresnel_conductor(cos_theta, eta, k), 1, 1e-4) << k << " " << cos_theta;
  EXPECT_NEAR(fresnel_conductor(0.5f, 4e9f, 4e9f), 1, 1e-6);
}

// Without absorption a conductor is a dielectric, at grazing angles and of index 1 as well.
TEST(Unit_Fresnel, ConductorWithoutAbsorptionIsADielectric) {
  for (const float eta : {1.0f, 1.0000001f, 1.0001f, 1.5f, 1000.0f, 0.9999f, 0.5f})
    for (const float cos_theta : {1.0f, 0.3f, 1e-2f, 1e-3f, 1e-4f, 1e-6f}) {
      const float dielectric = fresnel_dielectric(cos_theta, eta).reflectance;
      EXPECT_NEAR(fresnel_conductor(cos_theta, eta, 0), dielectric, 2e-6)
          << eta << " " << cos_theta;
    }
}

TEST(Unit_Fresnel, KnownPlaces) {
  EXPECT_FLOAT_EQ(fresnel_dielectric(1, 1.5f).reflectance, 0.04f);
  EXPECT_FLOAT_EQ(normal_reflectance(1.5f), 0.04f);
  // Brewster: the parallel part vanishes, half of the perpendicular one is left.
  const float brewster = std::cos(std::atan(1.5f));
  EXPECT_NEAR(fresnel_dielectric(brewster, 1.5f).reflectance, 0.5 * square(5.0 / 13), 1e-6);
  EXPECT_EQ(fresnel_dielectric(0.7f, 1 / 1.5f).reflectance, 1);  // beyond 41.8 degrees
  EXPECT_EQ(fresnel_dielectric(0.7f, 1 / 1.5f).cos_transmitted, 0);
  EXPECT_EQ(fresnel_dielectric(0.3f, 1).reflectance, 0);
  EXPECT_FLOAT_EQ(fresnel_dielectric(0.3f, 1).cos_transmitted, 0.3f);
  EXPECT_FLOAT_EQ(fresnel_conductor(1, 2, 3), (1.0f + 9) / (9 + 9));
  EXPECT_EQ(fresnel_schlick(Rgb{0.3f}, 1).x, 0.3f);
  EXPECT_EQ(fresnel_schlick(Rgb{0.3f}, 0).x, 1);
}

// Reciprocity of the interface: the same reflectance from both sides along one path.
TEST(Unit_Fresnel, DielectricIsTheSameFromBothSides) {
  for (const float eta : {1.1f, 1.5f, 2.4f})
    for (int i = 1; i < 100; ++i) {
      const float cos_theta = static_cast<float>(i) / 100;
      const DielectricFresnel outside = fresnel_dielectric(cos_theta, eta);
      const DielectricFresnel inside = fresnel_dielectric(outside.cos_transmitted, 1 / eta);
      // From inside, cos^2 comes from a difference of numbers about eta^2, rounded to 3 eps; the
      // reflectance's slope is below 6.
      const double tolerance = 3e-6 + 6 * 1.5 * 1.2e-7 * square(double{eta}) / cos_theta;
      ASSERT_NEAR(outside.reflectance, inside.reflectance, tolerance);
      ASSERT_NEAR(inside.cos_transmitted, cos_theta, tolerance);
    }
}

TEST(Unit_Fresnel, NeverInvalid) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const float tiny = std::numeric_limits<float>::min();
  for (const float cos_theta : {0.0f, tiny / 2, tiny, 1e-20f, 1e-6f, 0.5f, 1.0f, 1.0000001f})
    for (const float eta : {0.0f, 0.001f, 1.0f, 1.0000001f, 1.5f, 1000.0f, 1e10f, infinity})
      for (const float k : {0.0f, 1e-20f, 100.0f, 1e10f}) {
        const float dielectric = fresnel_dielectric(cos_theta, eta).reflectance;
        const float conductor = fresnel_conductor(cos_theta, eta, k);
        ASSERT_TRUE(dielectric >= 0 && dielectric <= 1) << cos_theta << " " << eta;
        ASSERT_TRUE(conductor >= 0 && conductor <= 1) << cos_theta << " " << eta << " " << k;
      }
  EXPECT_EQ(clamp_unit(std::numeric_limits<float>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace candela
