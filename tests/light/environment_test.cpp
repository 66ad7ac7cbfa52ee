// Where environment maps are looked up, and what odd maps do.
#include "renderer/light/environment.h"

#include <gtest/gtest.h>

#include "renderer/light/light_power.h"
#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "renderer/math/colour.h"
#include "tests/image/crafted_files.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using light_test::cube;
using light_test::equal_area;
using light_test::lat_long;
using light_test::MapEnvironment;
using light_test::write_byte_map;
using light_test::write_float_map;

// Of OpenGL's table, written out by hand: which world axis each image axis follows on each face.
struct CubeFace {
  Vec3f axis, right, down;
};
constexpr CubeFace cube_faces[6] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};

TEST(Unit_CubeMap, PointsLieInTheirDirection) {
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec3f d = light_test::random_direction(i, 1);
    const CubePoint point = cube_point(d);
    const CubeFace& face = cube_faces[point.face];
    Vec3f back = face.axis + face.right * (2 * point.st.x - 1) + face.down * (2 * point.st.y - 1);
    ASSERT_LT(length(normalize(back) - d), 1e-6f);
    ASSERT_LT(length(normalize(cube_direction(point)) - d), 1e-6f);
    ASSERT_TRUE(point.st.x >= 0 && point.st.x <= 1 && point.st.y >= 0 && point.st.y <= 1);
  }
}

// 2 x 2 faces, every texel of its own colour (face, column, row).
TEST(Unit_CubeMap, FacesAndCornersLieAsOpenGlLaysThem) {
  std::array<description::Image, 6> images;
  for (std::size_t face = 0; face < 6; ++face)
    images[face] = write_byte_map(fmt::format("corners{}", face), 2, 2, [&](int x, int y) {
      return Vec3f(40 * static_cast<float>(face + 1), 100 * x + 50, 100 * y + 50);
    });
  const MapEnvironment map = cube(images);
  EXPECT_TRUE(map.diagnostics.list().empty());
  const auto decoded = [](double value) { return std::pow(value / 255, 2.2); };
  for (int i = 0; i < 6; ++i) {
    const double red = decoded(40 * (i + 1));
    EXPECT_NEAR(map.radiance(cube_faces[i].axis).x, red, 1e-5) << i;
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y) {
        const Vec3f d = cube_faces[i].axis + cube_faces[i].right * (static_cast<float>(x) - 0.5f) +
                        cube_faces[i].down * (static_cast<float>(y) - 0.5f);
        const Rgb seen = map.radiance(normalize(d));
        EXPECT_NEAR(seen.x, red, 1e-5) << i << x << y;
        EXPECT_NEAR(seen.y, decoded(100 * x + 50), 1e-5) << i << x << y;
        EXPECT_NEAR(seen.z, decoded(100 * y + 50), 1e-5) << i << x << y;
      }
  }
}

// A bright column at a face's left end must not bleed over to the right end.
TEST(Unit_CubeMap, FacesDoNotWrap) {
  std::array<description::Image, 6> images;
  images.fill(write_float_map("no_wrap", 4, 4, [](int x, int) { return Vec3f(x == 0 ? 1 : 0); }));
  const MapEnvironment map = cube(images);
  EXPECT_EQ(map.radiance(normalize(Vec3f(0.999f, 0, 1))), Rgb(0));
  EXPECT_EQ(map.radiance(normalize(Vec3f(-0.999f, 0, 1))), Rgb(1));
}

// pbrt refuses them: they hold latitudes and longitudes, most likely.
TEST(Errors_EqualAreaMap, MapsThatAreNotSquareAreNamed) {
  const description::Image image =
      write_float_map("no_square", 8, 4, [](int, int) { return Vec3f(1); });
  const auto found = equal_area(image).diagnostics.list();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::Warning);
  EXPECT_NE(found[0].message.find("is 8 x 4: maps of equal areas are square"), std::string::npos);
}

// 4 x 4 texels: red tells the column, green the row; the directions are those of their middles.
TEST(Unit_EqualAreaMap, TexelsLieAsTheConventionSays) {
  const description::Image image =
      write_float_map("square", 4, 4, [](int x, int y) { return Vec3f(x + 1, y + 1, 0); });
  const Mat3d turn{Vec3d(0, 1, 0), Vec3d(1, 0, 0), Vec3d(0, 0, 1)};  // mirrors
  const MapEnvironment map = equal_area(image, turn);
  EXPECT_NEAR(map.radiance({0, 0, 1}).x, 2.5, 1e-5);  // the centre, between four texels
  EXPECT_NEAR(map.radiance({0, 0, 1}).y, 2.5, 1e-5);
  EXPECT_NEAR(map.radiance({0, 1, 0}).x, 4, 1e-5);  // +x of the map: the middle of the right edge
  EXPECT_NEAR(map.radiance({0, 1, 0}).y, 2.5, 1e-5);
  EXPECT_NEAR(map.radiance({1, 0, 0}).y, 4, 1e-5);  // +y: the bottom's middle
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) {
      const Vec2f st{(static_cast<float>(x) + 0.5f) / 4, (static_cast<float>(y) + 0.5f) / 4};
      const Vec3f d = square_to_equal_area_sphere(st);
      const Rgb seen = map.radiance({d.y, d.x, d.z});
      EXPECT_NEAR(seen.x, x + 1, 1e-4);
      EXPECT_NEAR(seen.y, y + 1, 1e-4);
    }
}

TEST(Unit_LatLongMap, DirectionsLieAtTheirPoint) {
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec3f d = light_test::random_direction(i, 2);
    ASSERT_LT(length(lat_long_direction(lat_long_point(d)) - d), 2e-6f);
  }
}

TEST(Unit_LatLongMap, ConventionIsThatOfAViewerLookingAlongMinusZ) {
  // 8 x 4: red tells the column, green the row.
  const MapEnvironment map = lat_long(
      write_float_map("convention", 8, 4, [](int x, int y) { return Vec3f(x + 1, y + 1, 0); }));
  const auto expect = [&](const Vec3f& d, double column, double row) {
    const Rgb seen = map.radiance(normalize(d));
    EXPECT_NEAR(seen.x, column + 1, 2e-5) << d.x << " " << d.y << " " << d.z;
    EXPECT_NEAR(seen.y, row + 1, 2e-5) << d.x << " " << d.y << " " << d.z;
  };
  expect({0, 0, -1}, 3.5, 1.5);  // the centre: between texels 3 and 4, rows 1 and 2
  expect({1, 0, 0}, 5.5, 1.5);   // to the right
  expect({-1, 0, 0}, 1.5, 1.5);
  expect({1e-6f, 0, 1}, 3.5, 1.5);  // behind: half way between the last texel and the first
  EXPECT_NEAR(map.radiance({0, 1, 0}).y, 1, 1e-6);  // up: row 0
  EXPECT_NEAR(map.radiance({0, -1, 0}).y, 4, 1e-6);
  const double centre_of_row_1 = pi_double * 1.5 / 4;
  expect(Vec3f(Vec3d(0, std::cos(centre_of_row_1), -std::sin(centre_of_row_1))), 3.5, 1);
}

TEST(Unit_LatLongMap, TurnsWithTheWorld) {
  const description::Image image =
      write_float_map("turned", 16, 8, [](int x, int y) { return Vec3f(x, y, x * y); });
  const MapEnvironment plain = lat_long(image);
  // The map's -z looks along the world's +x, its y along the world's z (scaled: made unit length).
  const Mat3d world_from_map(Vec3d(0, 3, 0), Vec3d(0, 0, 2), Vec3d(-1, 0, 0));
  const MapEnvironment turned = lat_long(image, world_from_map);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec3f m = light_test::random_direction(i, 2);
    const Vec3f world(-m.z, m.x, m.y);
    EXPECT_LT(length(turned.radiance(world) - plain.radiance(m)), 1e-3f);
    const EnvironmentSample a =
        sample_environment(plain.environment, light_test::random_pair(i, 3));
    const EnvironmentSample b =
        sample_environment(turned.environment, light_test::random_pair(i, 3));
    EXPECT_EQ(a.pdf, b.pdf);
    EXPECT_LT(length(Vec3f(-a.direction.z, a.direction.x, a.direction.y) - b.direction), 1e-6f);
  }
}

TEST(Unit_Environment, ConstantIsTheSameEverywhere) {
  description::ConstantEnvironment constant;
  constant.radiance = Vec3d(1, 2, 3);
  constant.is_seen_by_camera = false;
  const Environment environment = build_environment(constant);
  EXPECT_FALSE(environment.is_seen_by_camera);
  EXPECT_EQ(environment_radiance(environment, TextureStore(), {0, 1, 0}), Rgb(1, 2, 3));
  EXPECT_NEAR(environment_pdf(environment, {0, 1, 0}), 1 / (4 * pi_double), 1e-8);
}

void expect_no_light(const Environment& environment) {
  EXPECT_TRUE(environment.is_black());
  EXPECT_EQ(light_power(make_environment_light(), &environment, 1), 0);
  EXPECT_EQ(sample_environment(environment, {0.3f, 0.6f}).pdf, 0.0f);
  EXPECT_EQ(environment_pdf(environment, {0, 0, 1}), 0.0f);
}

TEST(Unit_Environment, BlackOnesAreNoLight) {
  expect_no_light(build_environment(description::ConstantEnvironment{}));
  const description::Image black =
      write_float_map("black", 4, 2, [](int, int) { return Vec3f(0); });
  const MapEnvironment map = lat_long(black);
  expect_no_light(map.environment);
  EXPECT_EQ(map.radiance({0, 0, 1}), Rgb(0));
  std::array<description::Image, 6> faces;
  faces.fill(black);
  expect_no_light(cube(faces).environment);
}

// Wherever there is light there is density: else next-event estimation would lose it.
void expect_density_where_light(const MapEnvironment& map) {
  Environment beside_bsdfs = map.environment;
  beside_bsdfs.distribution = compensated(map.environment.distribution);
  int lit = 0;
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const Vec3f d = light_test::random_direction(i, 4);
    if (is_black(map.radiance(d))) continue;
    ++lit;
    ASSERT_GT(map.pdf(d), 0) << d.x << " " << d.y << " " << d.z;
    ASSERT_GT(environment_pdf(beside_bsdfs, d), 0) << d.x << " " << d.y << " " << d.z;
  }
  EXPECT_GT(lit, 100);
}

// Isolated pixels, so that bilinear lookups reach into cells whose own texel is black.
Vec3f sparse_texel(int x, int y) {
  return (x * 7 + y * 13) % 29 == 0 ? Vec3f(x % 3 == 0 ? 1e9f : 1e-3f, 0, y % 2 == 0 ? 1 : 0)
                                    : Vec3f(0);
}

TEST(Unit_Environment, DensityIsPositiveWhereverLightIs) {
  const description::Image image = write_float_map("sparse", 64, 32, sparse_texel);
  const description::Image square = write_float_map("sparse_square", 48, 48, sparse_texel);
  for (const std::size_t max_cells :
       {default_environment_cells, std::size_t{300}, std::size_t{7}}) {
    expect_density_where_light(lat_long(image, Mat3d(1.0), max_cells));
    expect_density_where_light(equal_area(square, Mat3d(1.0), max_cells));
    std::array<description::Image, 6> faces;
    faces.fill(image);
    faces[2] = write_float_map("sparse_other_size", 9, 21, sparse_texel);
    expect_density_where_light(cube(faces, max_cells));
  }
}

// Of any shape, with light in one texel alone.
TEST(Unit_Environment, NoTexelLiesBetweenTheTablesPoints) {
  const auto expect_found = [](const MapEnvironment& map, int x, int y) {
    EXPECT_FALSE(map.environment.distribution.cells().is_empty()) << x << "," << y;
  };
  constexpr std::pair<int, int> sizes[] = {{64, 1}, {256, 2}, {128, 4},
                                           {2, 64}, {4, 256}, {32, 16}};
  for (const auto& [width, height] : sizes)
    for (int i = 0; i < 16; ++i) {
      const int x = i * 37 % width;
      const int y = i * 101 % height;
      const description::Image image = write_float_map(
          "one_texel", width, height,
          [&](int column, int row) { return Vec3f(column == x && row == y ? 1.0f : 0.0f); });
      expect_found(lat_long(image), x, y);
      expect_found(equal_area(image), x, y);
      std::array<description::Image, 6> faces;
      faces.fill(image);
      expect_found(cube(faces), x, y);
    }
}

TEST(Unit_Environment, LargeMapsGetCoarserGrids) {
  const description::Image image = write_float_map("large", 64, 32, sparse_texel);
  const MapEnvironment map = lat_long(image, Mat3d(1.0), 128);
  EXPECT_EQ(map.environment.distribution.cells().columns(), 16u);
  EXPECT_EQ(map.environment.distribution.cells().rows(), 8u);
}

void expect_small_grid(const MapEnvironment& map) {
  const std::size_t texels = map.textures.info(map.environment.faces[0]).bytes;
  EXPECT_LE(map.environment.distribution.cells().bytes(), texels);
  EXPECT_GE(map.environment.distribution.cells().bytes(), texels / 3);  // no coarser than need be
}

TEST(Unit_Environment, GridsTakeNoMoreMemoryThanTheirMaps) {
  expect_small_grid(lat_long(write_byte_map("bytes", 256, 128, sparse_texel)));
  expect_small_grid(lat_long(write_float_map("floats", 256, 128, sparse_texel)));
}

// A sound header, and behind it data that cannot be decoded: found only when texels are wanted.
TEST(Unit_Environment, BrokenPixelsAreMagenta) {
  using crafted::operator+;
  const crafted::Bytes sound = crafted::png_rgba(64, 32, [](int, int, int) { return 7u; });
  const crafted::Bytes header(sound.begin(), sound.begin() + 33);  // signature and IHDR
  const TemporaryFolder folder;
  description::Image image;
  image.path =
      folder.put("broken.png", header + crafted::png_chunk("IDAT", crafted::Bytes(600, 1)) +
                                   crafted::png_chunk("IEND", {}));
  const MapEnvironment map = lat_long(image);
  EXPECT_FALSE(map.diagnostics.has_errors());
  EXPECT_EQ(map.textures.decoding_diagnostics().warning_count(), 1u);
  const double magenta = luminance(Vec3d(1, 0, 1));
  EXPECT_NEAR(map.environment.mean_luminance, magenta, 1e-3 * magenta);
  EXPECT_EQ(map.radiance({0, 0, 1}), Rgb(1, 0, 1));
}

// Nor do they darken what lies between them and their neighbours.
TEST(Unit_Environment, ValuesBelowZeroAreNoLight) {
  const auto sky_with = [](const char* name, float value) {
    return lat_long(write_float_map(
        name, 16, 8, [&](int x, int y) { return Vec3f(x == 5 && y == 3 ? value : 1.0f); }));
  };
  const MapEnvironment negative = sky_with("negative", -100);
  const MapEnvironment black = sky_with("black", 0);
  EXPECT_EQ(negative.textures.decoding_diagnostics().warning_count(), 1u);
  EXPECT_EQ(black.textures.decoding_diagnostics().warning_count(), 0u);
  EXPECT_EQ(negative.environment.mean_luminance, black.environment.mean_luminance);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Vec3f d = light_test::random_direction(i, 7);
    ASSERT_EQ(negative.radiance(d), black.radiance(d));
  }
}

// The same file may hold heights as well.
TEST(Unit_Environment, OtherUsesOfAnImageKeepItsValuesBelowZero) {
  const description::Image image =
      write_float_map("both", 4, 2, [](int, int) { return Vec3f(-3); });
  TextureStore store;
  Diagnostics diagnostics;
  const TextureHandle heights = store.add(image, diagnostics);
  const TextureHandle light = store.add_light(image, diagnostics);
  EXPECT_EQ(store.lookup(light, Vec2f(0.5f)).x, 0);
  EXPECT_EQ(store.lookup(heights, Vec2f(0.5f)).x, -3);
  const description::Image bytes =
      write_byte_map("bytes_of_both", 4, 2, [](int, int) { return Vec3f(7); });
  EXPECT_EQ(store.add(bytes, diagnostics), store.add_light(bytes, diagnostics));
}

TEST(Unit_Environment, CountsTexelsThatAreNotRadiance) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const description::Image image = write_float_map("invalid", 16, 8, [&](int x, int y) {
    if (x == 3 && y == 2) return Vec3f(nan, 1, 1);
    if (x == 9 && y == 5) return Vec3f(1, infinity, 1);
    if (x == 12 && y == 1) return Vec3f(-4, 1, 1);
    return Vec3f(x % 4 == 0 ? 1 : 0);
  });
  const MapEnvironment map = lat_long(image);
  EXPECT_GE(map.diagnostics.warning_count() + map.textures.decoding_diagnostics().warning_count(),
            1u);
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const Vec3f d = light_test::random_direction(i, 5);
    const Rgb seen = map.radiance(d);
    ASSERT_TRUE(is_finite(seen) && min_component(seen) >= 0);
    ASSERT_TRUE(is_black(seen) || map.pdf(d) > 0);
    const LightSample s = sample_light({&map.environment, &map.textures}, make_environment_light(),
                                       light_test::at(Vec3f(0)), light_test::random_pair(i, 6));
    ASSERT_TRUE(is_finite(s.radiance) && std::isfinite(s.pdf));
  }
}

TEST(Unit_Environment, AxesAndTheSquaresCornersAreFinite) {
  const description::Image image =
      write_float_map("ends", 16, 8, [](int, int) { return Vec3f(1); });
  std::array<description::Image, 6> faces;
  faces.fill(image);
  for (const MapEnvironment& map : {lat_long(image), cube(faces)}) {
    for (const Vec3f d : {Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1), Vec3f(-0.0f, -1, -0.0f),
                          Vec3f(-1, 0, 0), Vec3f(0, -0.0f, -1), normalize(Vec3f(1, 1, 1))}) {
      EXPECT_NEAR(map.radiance(d).x, 1, 1e-6);
      EXPECT_TRUE(std::isfinite(map.pdf(d)) && map.pdf(d) > 0);
    }
    for (const float x : {0.0f, one_minus_epsilon})
      for (const float y : {0.0f, one_minus_epsilon}) {
        const EnvironmentSample s = sample_environment(map.environment, {x, y});
        EXPECT_NEAR(length(s.direction), 1, 1e-6);
        EXPECT_TRUE(std::isfinite(s.pdf) && s.pdf > 0);
      }
  }
}

}  // namespace
}  // namespace candela
