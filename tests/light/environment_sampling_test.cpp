// Sampling of environments: the density is that of the samples, and what they estimate is right.
#include <gtest/gtest.h>

#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "renderer/math/colour.h"
#include "renderer/sampling/hash.h"
#include "renderer/sampling/sampler.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using light_test::Cap;
using light_test::cube;
using light_test::equal_area;
using light_test::lat_long;
using light_test::MapEnvironment;
using light_test::write_float_map;

// Bright spots on a gradient, nothing in one corner; no symmetry.
Vec3f varied_texel(int x, int y) {
  if (x < 5 && y < 4) return Vec3f(0);
  const float spot = (x * 5 + y * 3) % 23 == 0 ? 20.0f : 0.0f;
  return {1 + 0.1f * static_cast<float>(x) + spot, 0.2f * static_cast<float>(y), spot};
}

std::array<description::Image, 6> varied_faces() {
  std::array<description::Image, 6> faces;
  for (std::size_t i = 0; i < 6; ++i)
    faces[i] = write_float_map(fmt::format("varied{}", i), 8, 8, [&](int x, int y) {
      return varied_texel(x + 3 * static_cast<int>(i), y) * (1 + static_cast<float>(i));
    });
  return faces;
}

MapEnvironment varied_lat_long(std::size_t max_cells = default_environment_cells) {
  return lat_long(write_float_map("varied", 16, 8, varied_texel), Mat3d(1.0), max_cells);
}

// Smooth, and of so many texels that cells are merged.
Vec3f smooth_texel(int x, int y) {
  return {2 + std::sin(0.05f * static_cast<float>(x)), 0.1f + 0.01f * static_cast<float>(y), 1};
}
MapEnvironment smooth_lat_long() {
  return lat_long(write_float_map("smooth", 512, 256, smooth_texel));
}
MapEnvironment smooth_cube() {
  std::array<description::Image, 6> faces;
  for (std::size_t i = 0; i < 6; ++i)
    faces[i] = write_float_map(fmt::format("smooth{}", i), 96, 96, [&](int x, int y) {
      return smooth_texel(x, y) * (1 + static_cast<float>(i));
    });
  return cube(faces);
}

// A rotation with a mirror in it.
Mat3d mirrored_turn() {
  return {Vec3d(0.6, 0, 0.8), Vec3d(0, -1, 0), Vec3d(-0.8, 0, 0.6)};
}

MapEnvironment varied_equal_area(std::size_t max_cells = default_environment_cells) {
  return equal_area(write_float_map("varied_square", 16, 16, varied_texel), mirrored_turn(),
                    max_cells);
}

MapEnvironment constant(double radiance) {
  MapEnvironment result;
  description::ConstantEnvironment description;
  description.radiance = Vec3d(radiance);
  result.environment = build_environment(description);
  return result;
}

struct NamedMap {
  const char* name;
  MapEnvironment map;
};
std::vector<NamedMap> all_maps() {
  std::vector<NamedMap> maps;
  maps.push_back({"constant", constant(2)});
  maps.push_back({"lat-long", varied_lat_long()});
  maps.push_back({"coarse lat-long", varied_lat_long(50)});
  maps.push_back({"cube", cube(varied_faces())});
  maps.push_back({"coarse cube", cube(varied_faces(), 100)});
  maps.push_back({"merged lat-long", smooth_lat_long()});
  maps.push_back({"merged cube", smooth_cube()});
  maps.push_back({"equal-area", varied_equal_area()});
  maps.push_back({"coarse equal-area", varied_equal_area(100)});
  maps.push_back({"compensated", varied_lat_long()});
  Environment& environment = maps.back().map.environment;
  environment.distribution = compensated(environment.distribution);
  return maps;
}

TEST(Statistical_Environment, DensityIntegratesToOne) {
  for (const NamedMap& m : all_maps()) {
    if (m.map.environment.mapping == EnvironmentMapping::Constant) continue;  // without spread
    const statistics::Moments sum =
        light_test::random_integral(Cap{}, 1'000'000, [&](const Vec3f& d) { return m.map.pdf(d); });
    EXPECT_GT(sum.p_value(1), 1e-4) << m.name << ": " << sum.mean();
    EXPECT_LT(sum.standard_error(), 0.01) << m.name;
  }
}

TEST(Statistical_Environment, SamplesFitTheDensity) {
  const std::vector<NamedMap> maps = all_maps();
  const double level = statistics::sidak_level(0.01, static_cast<double>(maps.size()));
  for (const NamedMap& m : maps) {
    const auto sample = [&](Vec2f u) -> std::optional<Vec3f> {
      return sample_environment(m.map.environment, u).direction;
    };
    EXPECT_GT(light_test::chi_square_p_value(Cap{}, 64, 1'000'000, sample,
                                             [&](const Vec3f& d) { return m.map.pdf(d); }),
              level)
        << m.name;
  }
}

TEST(Unit_Environment, TablesOfSmoothSkiesAreCoarserThanTheirTexels) {
  EXPECT_EQ(smooth_lat_long().environment.distribution.cells().columns(), 256u);
  EXPECT_EQ(smooth_cube().environment.distribution.cells().columns(), 164u);  // of 332
}

TEST(Unit_Environment, ColumnsGoAllAround) {
  for (int i = 0; i <= 64; ++i) {
    const float quarters = static_cast<float>(i) / 16;
    Vec2f chord = sky_chord(quarters);
    EXPECT_FLOAT_EQ(std::abs(chord.x) + std::abs(chord.y), 1);
    EXPECT_NEAR(std::remainder(sky_quarters(chord.x, chord.y) - quarters, 4.0f), 0, 1e-6) << i;
  }
  EXPECT_EQ(sky_chord(1), Vec2f(0, 1));
  EXPECT_EQ(sky_chord(4), sky_chord(0));
}

// [Karlik19]: p - 1/2 of an even sky's share, at least p / 10. A quarter of the sky lies in the two
// rows at the poles, where 1 - cos(theta) is below a quarter.
TEST(Unit_Environment, CompensationTakesOffHalfTheMean) {
  const double weights[4] = {3, 0.2, 1, 1};
  const double even[4] = {0.125, 0.375, 0.375, 0.125};
  GridDistributionBuilder grid(4, 4);
  double expected[4];
  double total = 0;
  for (std::uint32_t row = 0; row < 4; ++row) {
    grid.set_row(row, std::vector<double>(4, weights[row]));
    const double p = weights[row] / 5.2;
    expected[row] = std::max(p - 0.5 * even[row], 0.1 * p);
    total += expected[row];
  }
  const SkyDistribution sky = compensated(SkyDistribution(std::move(grid).build()));
  for (std::uint32_t row = 0; row < 4; ++row)
    for (std::uint32_t column = 0; column < 4; ++column)
      EXPECT_NEAR(sky.cells().probability(column, row), expected[row] / total / 4, 1e-6) << row;
}

// Of the light on a floor, by sixteen well spread points a time: relative to the mean's square.
double noise_on_a_floor(const MapEnvironment& map, const Vec3f& up) {
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 16; ++i) {
      const Vec2f u = Sampler(mix_bits(seed), i).sample_2d(0, Dimension::LightPoint);
      const EnvironmentSample s = sample_environment(map.environment, u);
      sum += static_cast<double>(average(map.radiance(s.direction)) *
                                 std::max(0.0f, dot(up, s.direction)) / s.pdf);
    }
    means.add(sum / 16);
  }
  return means.variance() / (means.mean() * means.mean());
}

// The horizon is a line of the square, whatever the map (on a diamond they have five times the
// noise), and so are walls' sides, if across columns.
TEST(Statistical_Environment, WellSpreadPointsStayWellSpreadOverAFloor) {
  const auto even = [](int, int) { return Vec3f(1); };
  std::array<description::Image, 6> faces;
  faces.fill(write_float_map("even_face", 32, 32, even));
  const MapEnvironment cube_map = cube(faces);
  const MapEnvironment square = equal_area(write_float_map("even_square", 64, 64, even));
  const double native =
      noise_on_a_floor(lat_long(write_float_map("even", 96, 48, even)), {0, 1, 0});
  EXPECT_LT(native, 0.01);  // independent numbers: 5 / 3 / 16
  EXPECT_NEAR(noise_on_a_floor(cube_map, {0, 1, 0}) / native, 1, 0.15);
  EXPECT_NEAR(noise_on_a_floor(square, {0, 0, 1}) / native, 1, 0.15);
}

// The polar rows by themselves, where a cell's solid angle shrinks to nothing.
TEST(Statistical_Environment, SamplesFitTheDensityNextToThePoles) {
  const MapEnvironment map = lat_long(write_float_map(
      "poles", 64, 256, [](int x, int y) { return Vec3f(y < 2 || y > 253 ? 1 + x % 5 : 0); }));
  const auto sample = [&](Vec2f u) -> std::optional<Vec3f> {
    return sample_environment(map.environment, u).direction;
  };
  const double cos_min = std::cos(pi_double * 3 / 256);
  for (const float up : {1.0f, -1.0f}) {
    const Cap cap{{{1, 0, 0}, {0, 0, up}, {0, up, 0}}, cos_min};
    EXPECT_GT(light_test::chi_square_p_value(cap, 48, 1'000'000, sample,
                                             [&](const Vec3f& d) { return map.pdf(d); }),
              statistics::sidak_level(0.01, 2))
        << up;
  }
}

// pdf() is asked about directions that sample() gave; but for cells' edges both say the same.
TEST(Unit_Environment, SampleAndPdfAgree) {
  for (const NamedMap& m : all_maps()) {
    int differing = 0;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
      const EnvironmentSample s =
          sample_environment(m.map.environment, light_test::random_pair(i, 7));
      ASSERT_NEAR(length(s.direction), 1, 1e-6) << m.name;
      differing += std::abs(m.map.pdf(s.direction) / static_cast<double>(s.pdf) - 1) > 1e-5 ? 1 : 0;
    }
    EXPECT_LT(differing, 10) << m.name;
  }
}

// Irradiance on a plane with normal n, by sampling the light.
statistics::Moments irradiance(const MapEnvironment& map, const Vec3f& n, std::uint64_t count) {
  const LightTables tables{&map.environment, &map.textures};
  const Light light = make_environment_light();
  statistics::Moments moments;
  for (std::uint64_t i = 0; i < count; ++i) {
    const LightSample s =
        sample_light(tables, light, light_test::at(Vec3f(0)), light_test::random_pair(i, 8));
    moments.add(s.is_valid() ? static_cast<double>(average(s.radiance)) *
                                   std::max(0.0f, dot(n, s.wi)) / static_cast<double>(s.pdf)
                             : 0);
  }
  return moments;
}

TEST(Statistical_Environment, ConstantGivesPiTimesItsRadiance) {
  const statistics::Moments moments = irradiance(constant(2), {0.6f, 0, 0.8f}, 1'000'000);
  EXPECT_GT(moments.p_value(2 * pi_double), 1e-4) << moments.mean();
  EXPECT_LT(moments.standard_error() / moments.mean(), 2e-3);
}

// Each face of its own constant radiance: the top is a square over the plane, and the upper halves
// of the four sides share what it leaves of pi.
TEST(Statistical_Environment, CubeOfConstantFacesGivesLambertsIrradiance) {
  std::array<description::Image, 6> faces;
  const double radiance[6] = {1, 2, 30, 4, 5, 6};
  for (std::size_t i = 0; i < 6; ++i)
    faces[i] = write_float_map(fmt::format("constant{}", i), 4, 4,
                               [&](int, int) { return Vec3f(Vec3d(radiance[i])); });
  const double top = light_test::lambert_irradiance(
      {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}, Vec3d(0), Vec3d(0, 1, 0));
  const double exact = 30 * top + (1 + 2 + 5 + 6) * (pi_double - top) / 4;
  const statistics::Moments moments = irradiance(cube(faces), {0, 1, 0}, 1'000'000);
  EXPECT_GT(moments.p_value(exact), 1e-4) << moments.mean() << ", exact " << exact;
  EXPECT_LT(moments.standard_error(), 2e-3 * exact);
}

// Bilinear interpolation of the same map in double, by the convention in words: row 0 is up, the
// centre is -z, right of it +x; columns wrap, rows end.
double reference_radiance(int width, int height, const light_test::TexelFunction& texel,
                          const Vec3d& d) {
  const double x = (0.5 + std::atan2(d.x, -d.z) / (2 * pi_double)) * width - 0.5;
  const double y = std::clamp(std::acos(d.y) / pi_double * height - 0.5, 0.0, height - 1.0);
  const double fx = x - std::floor(x), fy = y - std::floor(y);
  const auto at = [&](int i, int j) {
    const Vec3f value = texel((i + width) % width, std::min(j, height - 1));
    return static_cast<double>(value.x + value.y + value.z) / 3;
  };
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  return (at(i, j) * (1 - fx) + at(i + 1, j) * fx) * (1 - fy) +
         (at(i, j + 1) * (1 - fx) + at(i + 1, j + 1) * fx) * fy;
}

double reference_irradiance(int width, int height, const light_test::TexelFunction& texel,
                            const Vec3d& n) {
  const int across = width * 32, down = height * 64;
  double sum = 0;
  for (int j = 0; j < down; ++j) {
    const double theta = pi_double * (j + 0.5) / down;
    for (int i = 0; i < across; ++i) {
      const double phi = 2 * pi_double * (i + 0.5) / across;
      const Vec3d d(std::sin(theta) * std::sin(phi), std::cos(theta),
                    std::sin(theta) * std::cos(phi));
      const double cosine = dot(d, n);
      if (cosine > 0) sum += reference_radiance(width, height, texel, d) * cosine * std::sin(theta);
    }
  }
  return sum * (pi_double / down) * (2 * pi_double / across);
}

// The square's convention in words: nearest texels of a fine map, summed over its equal areas.
TEST(Statistical_Environment, EqualAreaGivesTheIrradianceOfItsTexels) {
  constexpr int side = 64;
  const auto texel = [](int x, int y) {
    return Vec3f(1 + std::sin(0.2f * static_cast<float>(x)),
                 0.02f * static_cast<float>(y) * static_cast<float>(y), 1);
  };
  const Mat3d turn = mirrored_turn();
  const MapEnvironment map = equal_area(write_float_map("smooth_square", side, side, texel), turn);
  for (const Vec3f n : {Vec3f(0, 1, 0), Vec3f(0.6f, 0, 0.8f), Vec3f(-0.48f, -0.64f, -0.6f)}) {
    double exact = 0;
    constexpr int fine = 8 * side;
    for (int y = 0; y < fine; ++y)
      for (int x = 0; x < fine; ++x) {
        const Vec2f st{(static_cast<float>(x) + 0.5f) / fine,
                       (static_cast<float>(y) + 0.5f) / fine};
        const Vec3d d = turn * Vec3d(square_to_equal_area_sphere(st));
        const Rgb radiance = map.radiance(Vec3f(d));
        exact += static_cast<double>(average(radiance)) * std::max(0.0, dot(d, Vec3d(n))) * 4 *
                 pi_double / (double{fine} * fine);
      }
    const statistics::Moments moments = irradiance(map, n, 500'000);
    EXPECT_GT(moments.p_value(exact), 1e-4) << moments.mean() << ", exact " << exact;
    EXPECT_LT(moments.standard_error(), 1e-2 * exact);
  }
}

void expect_reference_irradiance(const char* name, int width, int height,
                                 const light_test::TexelFunction& texel, double max_error) {
  const MapEnvironment map = lat_long(write_float_map(name, width, height, texel));
  for (const Vec3f n : {Vec3f(0, 1, 0), Vec3f(0.6f, 0, 0.8f), Vec3f(-0.48f, -0.64f, -0.6f)}) {
    const double exact = reference_irradiance(width, height, texel, Vec3d(n));
    const statistics::Moments moments = irradiance(map, n, 500'000);
    EXPECT_GT(moments.p_value(exact), 1e-4) << name << ": " << moments.mean() << " +- "
                                            << moments.standard_error() << ", exact " << exact;
    EXPECT_LT(moments.standard_error(), max_error * exact) << name;
  }
}

TEST(Statistical_Environment, GradientGivesTheIrradianceOfQuadrature) {
  expect_reference_irradiance(
      "gradient", 16, 8, [](int x, int y) { return Vec3f(y + 1, 0.5f * static_cast<float>(x), 2); },
      4e-3);
}

TEST(Statistical_Environment, OneVeryBrightPixelIsFoundByItsSamples) {
  const auto sun = [](int x, int y) { return Vec3f(x == 21 && y == 14 ? 1e9f : 1.0f); };
  const MapEnvironment map = lat_long(write_float_map("sun", 64, 32, sun));
  // Seen from its own side; below the horizon the sky alone is left.
  const double angle = pi_double * 14.5 / 32, azimuth = 2 * pi_double * (21.5 / 64 - 0.5);
  const Vec3d towards(std::sin(angle) * std::sin(azimuth), std::cos(angle),
                      -std::sin(angle) * std::cos(azimuth));
  const statistics::Moments moments = irradiance(map, Vec3f(towards), 1'000'000);
  const double exact = reference_irradiance(64, 32, sun, towards);
  EXPECT_NEAR(moments.mean() / exact, 1, 1e-4 + 4 * moments.standard_error() / exact);
  EXPECT_LT(moments.standard_error(), 2e-3 * exact);
  EXPECT_GT(map.pdf(Vec3f(-towards)), 0);
}

}  // namespace
}  // namespace candela
