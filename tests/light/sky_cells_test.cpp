// How the table of a sky follows its light.
#include <gtest/gtest.h>

#include "renderer/light/environment.h"
#include "renderer/math/colour.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"

namespace candela {
namespace {

using light_test::cube;
using light_test::equal_area;
using light_test::lat_long;
using light_test::MapEnvironment;
using light_test::write_float_map;

// Between the points where they are fewer than the patches: in one of 16 x 16 patches of a dim sky.
TEST(Unit_SkyCells, LampsBetweenTheTablesPointsKeepTheirShare) {
  constexpr int side = 64;
  for (int row = 2; row < side; row += 4)
    for (int column = 2; column < side; column += 4) {
      const description::Image image = write_float_map("lamp", side, side, [&](int x, int y) {
        return Vec3f(x == column && y == row ? 1e4f : 0.01f);
      });
      const MapEnvironment map = equal_area(image, Mat3d(1.0), 256);
      const Vec2f st = (Vec2f(Vec2i(column, row)) + 0.5f) / float{side};
      const float pdf = environment_pdf(map.environment, square_to_equal_area_sphere(st));
      EXPECT_GT(pdf, 0.5f) << column << ',' << row;  // of 7 where the lamp has all
    }
}

// The probability of the table's cell that has a direction.
float share_of_cell(const MapEnvironment& map, const Vec3f& d) {
  return environment_pdf(map.environment, d) / environment_place(map.environment, d).density;
}

// Likewise of 16 x 8 patches and of 8 x 8 on each face of a cube.
TEST(Unit_SkyCells, LampsOfOtherMapsKeepTheirShare) {
  const auto lamp = [](int column, int row) {
    return [=](int x, int y) { return Vec3f(x == column && y == row ? 1e4f : 0.01f); };
  };
  for (int row = 2; row < 32; row += 4)
    for (int column = 2; column < 64; column += 4) {
      const MapEnvironment map =
          lat_long(write_float_map("lamp", 64, 32, lamp(column, row)), Mat3d(1.0), 128);
      const Vec3f d = lat_long_direction(
          {(static_cast<float>(column) + 0.5f) / 64, (static_cast<float>(row) + 0.5f) / 32});
      EXPECT_GT(share_of_cell(map, d), 0.4f) << column << ',' << row;
      EXPECT_LT(share_of_cell(map, {-d.x, d.y, d.z}), 0.3f) << column << ',' << row;
    }
  std::array<description::Image, 6> faces;
  faces.fill(write_float_map("dim", 32, 32, [](int, int) { return Vec3f(0.01f); }));
  for (std::uint32_t face = 0; face < 6; ++face)
    for (int row = 2; row < 32; row += 4)
      for (int column = 2; column < 32; column += 4) {
        std::array<description::Image, 6> lit = faces;
        lit[face] = write_float_map("lamp", 32, 32, lamp(column, row));
        const MapEnvironment map = cube(lit, 384);
        const Vec2f st = (Vec2f(Vec2i(column, row)) + 0.5f) / 32.0f;
        const Vec3f d = normalize(cube_direction({face, st}));
        EXPECT_GT(share_of_cell(map, d), 0.01f) << face << ' ' << column << ',' << row;
      }
}

// The second moment of radiance over density, over the squared integral: 1 where the density
// follows the light.
double second_moment_of(const MapEnvironment& map) {
  double first = 0, second = 0;
  constexpr std::uint64_t count = 200'000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3f d = light_test::random_direction(i, 7);
    const auto light = static_cast<double>(luminance(map.radiance(d)));
    const double pdf = map.pdf(d);
    first += light;
    if (light > 0) second += light * light / pdf;
  }
  return second * count / (first * first) / (4 * pi_double);
}

TEST(Unit_SkyCells, DensityFollowsLightBesideDarknessAndInRings) {
  const auto dome = [](int, int y) { return Vec3f(y < 64 ? 1.0f : 0.0f); };
  EXPECT_LT(second_moment_of(lat_long(write_float_map("dome", 256, 128, dome))), 1.03);
  const auto half = [](int x, int) { return Vec3f(x < 64 ? 1.0f : 0.0f); };
  EXPECT_LT(second_moment_of(equal_area(write_float_map("half", 128, 128, half))), 1.03);
  for (const int rows : {256, 1024}) {
    const auto rings = [&](int, int y) {
      return Vec3f(0.1f + static_cast<float>(y) / float(rows));
    };
    EXPECT_LT(second_moment_of(lat_long(write_float_map("rings", 1, rows, rings))), 1.05) << rows;
    const auto dark = [&](int, int y) {
      return Vec3f(y < rows / 2 ? 0.1f + static_cast<float>(y) / float(rows) : 0.0f);
    };
    EXPECT_LT(second_moment_of(lat_long(write_float_map("dark", 1, rows, dark))), 1.25) << rows;
  }
}

// Of so many that none is a lamp.
TEST(Unit_SkyCells, NoStarIsLost) {
  constexpr int side = 1024;
  const auto star = [](int x, int y) { return Vec3f(x % 12 == 6 && y % 12 == 6 ? 1.0f : 0.0f); };
  const MapEnvironment map =
      equal_area(write_float_map("stars", side, side, star), Mat3d(1.0), 65536);
  int lost = 0;
  for (int y = 6; y < side; y += 12)
    for (int x = 6; x < side; x += 12) {
      const Vec2f st = (Vec2f(Vec2i(x, y)) + 0.5f) / float{side};
      lost += environment_pdf(map.environment, square_to_equal_area_sphere(st)) > 0 ? 0 : 1;
    }
  EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace candela
