#include "renderer/math/white_balance.h"

#include <gtest/gtest.h>

#include "renderer/math/cie.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

// The CIE's own figures: D50, D55, D65 and D75, and illuminant A, a black body.
TEST(Unit_WhiteBalance, DaylightIsTheCies) {
  struct Illuminant {
    double kelvins, x, y;
  };
  for (const auto& [kelvins, x, y] :
       {Illuminant{5000, 0.34567, 0.35850}, Illuminant{5500, 0.33242, 0.34743},
        Illuminant{6500, 0.31272, 0.32903}, Illuminant{7500, 0.29902, 0.31485},
        Illuminant{2856 / 1.00056, 0.44758, 0.40745}}) {
    EXPECT_NEAR(daylight(kelvins).x, x, 2e-4) << kelvins;
    EXPECT_NEAR(daylight(kelvins).y, y, 3e-4) << kelvins;
  }
}

Mat3d xyz_of_rgb() {
  return glm::inverse(Mat3d(xyz_to_rgb({1, 0, 0}), xyz_to_rgb({0, 1, 0}), xyz_to_rgb({0, 0, 1})));
}

void expect_rows(const Mat3d& found, const double (&expected)[3][3], double tolerance) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR(found[column][row], expected[row][column], tolerance) << row << column;
}

// Bradford's adaptation of D50 to D65 as it is published everywhere, on XYZ; its D50 is the
// table's, whose y is .0001 less than the formula's.
TEST(Unit_WhiteBalance, IsBradfordsAdaptation) {
  expect_rows(xyz_of_rgb() * white_balance(5000) * glm::inverse(xyz_of_rgb()),
              {{0.9555766, -0.0230393, 0.0631636},
               {-0.0282895, 1.0099416, 0.0210077},
               {0.0122982, -0.0204830, 1.3299098}},
              1e-3);
}

// By another program, from the formulas in another order.
TEST(Unit_WhiteBalance, FiguresOfTwoTemperatures) {
  expect_rows(white_balance(5000),
              {{0.93944336, -0.09369769, -0.01748037},
               {0.00443362, 1.02409183, -0.00654286},
               {0.00815942, 0.02954475, 1.33273449}},
              1e-7);
  expect_rows(white_balance(8000),
              {{1.03832933, 0.05323761, 0.00880662},
               {-0.00253781, 0.99010912, 0.00308954},
               {-0.00401053, -0.01421873, 0.84355531}},
              1e-7);
}

TEST(Unit_WhiteBalance, LightOfItsTemperatureIsWhiteAndAsBright) {
  for (const double kelvins : {1000.0, 2000.0, 3000.0, 3999.0, 4500.0, 6500.0, 12000.0, 1e6}) {
    const Chromaticity c = daylight(kelvins);
    const Vec3d xyz(c.x / c.y, 1, (1 - c.x - c.y) / c.y);
    const Vec3d seen = white_balance(kelvins) * xyz_to_rgb(xyz);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], 1, 1e-5) << kelvins;
  }
}

// D65 is what white means without any balance.
TEST(Unit_WhiteBalance, OfD65IsNone) {
  const Mat3d matrix = white_balance(6500);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(matrix[c][r], c == r, 1e-3);
}

// Below 100 kelvins there is nothing to see by.
TEST(Errors_WhiteBalance, AnyTemperatureHasAFiniteMatrix) {
  for (const double kelvins : {0.0, 1.0, 99.0, 100.0, 300.0, 1e9, 1e300}) {
    const Mat3d matrix = white_balance(kelvins);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(is_finite(matrix[c])) << kelvins;
  }
}

}  // namespace
}  // namespace candela
