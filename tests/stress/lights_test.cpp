// Lights of odd strengths, places and sizes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/stress/closed_form.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// --- 10^12 beside 10^-12 ---

// Two closed rooms of side 2, about x = -1 and x = 1, with a wall of this thickness between.
void add_rooms(SceneDescription& scene, description::MaterialHandle left,
               description::MaterialHandle right, double wall = 1e-3) {
  add_mesh(scene, inside_out(box({-2, -1, -1}, {-wall / 2, 1, 1})), left);
  add_mesh(scene, inside_out(box({wall / 2, -1, -1}, {2, 1, 1})), right);
}

RenderSettings small_picture(int samples) {
  return settings_of(16, is_heavy() ? 8 * samples : samples);
}

// Walls that emit e and reflect half make 2 e everywhere: a ray that slipped through the wall, or
// through an edge, would bring 10^24 times as much.
TEST(Stress_Lights, RoomsOf24DecadesSideBySideStayApart) {
  SceneDescription scene = empty_scene();
  const auto bright = add_material(scene, diffuse(Vec3d(0.5)), Vec3d(1e12));
  const auto dim = add_material(scene, diffuse(Vec3d(0.5)), Vec3d(1e-12));
  add_rooms(scene, bright, dim);
  set_camera(scene, {1.1, 0.1, -0.2}, {0, 0.2, 0.1}, 100);
  expect_mean(renders_of("in the dim room", scene, small_picture(64)), 2e-12, {.resolution = 0.01});
  set_camera(scene, {-1.1, 0.1, -0.2}, {0, 0.2, 0.1}, 100);
  expect_mean(renders_of("in the bright room", scene, small_picture(64)), 2e12,
              {.resolution = 0.01});
}

// A lamp in each room.
SceneDescription rooms_with_lamps(double bright_radiance) {
  SceneDescription scene = empty_scene();
  const auto white = add_material(scene, diffuse(Vec3d(0.5)));
  add_rooms(scene, white, white);
  const auto bright = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(bright_radiance));
  const auto dim = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1e-12));
  add_mesh(scene, quad({-1.5, 0.9, -0.5}, {1, 0, 0}, {0, 0, 1}), bright);
  add_mesh(scene, quad({0.5, 0.9, -0.5}, {1, 0, 0}, {0, 0, 1}), dim);
  set_camera(scene, {1.1, 0.1, -0.9}, {1, -0.2, 0.5}, 90);
  return scene;
}

// Next-event estimation is left with one sample in 2^32 for the dim lamp; directions find it.
TEST(Stress_Lights, ADimLampIsSeenBesideOneOf24Decades) {
  const Renders alone = renders_of("alone", rooms_with_lamps(0), small_picture(128));
  expect_within_noise(renders_of("beside 10^12", rooms_with_lamps(1e12), small_picture(128)),
                      alone);
}

SceneDescription rooms_with_point_lights(int bright_count, double bright_intensity) {
  SceneDescription scene = empty_scene();
  const auto white = add_material(scene, diffuse(Vec3d(0.5)));
  add_rooms(scene, white, white);
  for (int i = 0; i < bright_count; ++i)
    add_light(scene, description::PointLight{{-1.5 + 0.1 * i, 0.5, 0.1}, Vec3d(bright_intensity)});
  add_light(scene, description::PointLight{{1, 0.5, 0.1}, Vec3d(1e-12)});
  set_camera(scene, {1.1, 0.1, -0.9}, {1, -0.2, 0.5}, 90);
  return scene;
}

TEST(Stress_Lights, FewPointLightsOf24DecadesDoNotDisturbEachOther) {
  const RenderSettings settings = small_picture(16);
  const Renders without = renders_of("without", rooms_with_point_lights(3, 0), settings, 1);
  expect_same_bits(renders_of("with", rooms_with_point_lights(3, 1e12), settings, 1), without);
}

// More point lights than are all sampled: no direction finds one, so each must keep its share. That
// makes noise of many bright samples among dark ones, which the mean of 64 leaves too skewed for
// t-tests.
TEST(Stress_Lights, ManyPointLightsOf24DecadesAreWithinNoise) {
  const RenderSettings settings = small_picture(256);
  const Renders without = renders_of("without", rooms_with_point_lights(9, 0), settings);
  expect_within_noise(renders_of("with", rooms_with_point_lights(9, 1e12), settings), without);
}

// --- places ---

// A diffuse floor about the origin, seen from above through a narrow field of view; what stands on
// it or above must leave that view free. Direct light only.
SceneDescription floor_scene(double fovy_degrees = 20) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}),
           add_material(scene, diffuse(Vec3d(0.5))));
  set_camera(scene, {0, 3, 0}, {0, 0, 0}, fovy_degrees, {0, 0, -1});
  return scene;
}

RenderSettings direct_light(int size, int samples,
                            SamplingStrategy sampling = SamplingStrategy::Mis) {
  RenderSettings settings = settings_of(size, is_heavy() ? 8 * samples : samples);
  settings.options.max_depth = 1;
  settings.options.filter = FilterKind::Box;
  settings.options.sampling = sampling;
  return settings;
}

// The mean over a pixel of what the floor sends up where `irradiance` arrives.
template <class Irradiance>
auto floor_radiance(int size, double fovy_degrees, Irradiance irradiance) {
  return [=](int x, int y) {
    constexpr int steps = 16;
    const double half = 3 * std::tan(fovy_degrees / 2 * pi_double / 180);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double u = 2 * (x + (i + 0.5) / steps) / size - 1;
        const double v = 2 * (y + (j + 0.5) / steps) / size - 1;
        sum += irradiance(Vec3d(u * half, 0, v * half));
      }
    return 0.5 / pi_double * sum / (steps * steps);
  };
}

// Two far triangles that no one sees, so that scenes with more or less in them are stored alike.
void add_extent(SceneDescription& scene) {
  const auto black = add_material(scene, diffuse(Vec3d(0.0)));
  for (const double side : {-4.0, 4.0}) {
    const Vec3d corner(side);
    add_mesh(scene, triangle(corner, corner * Vec3d(1, 1, 0.99), corner * Vec3d(1, 0.99, 1)),
             black);
  }
}

// The tip of a tetrahedron over the floor; nothing hides the light from below.
TEST(Stress_Lights, AtAVertexOfAMesh) {
  const Vec3d tip(0.9, 1.0, 0.2);
  const auto irradiance = [&](const Vec3d& p) {
    const double distance = length(tip - p);
    return 4 * tip.y / (distance * distance * distance);
  };
  SceneDescription scene = floor_scene();
  add_extent(scene);
  add_light(scene, description::PointLight{tip, Vec3d(4.0)});
  const RenderSettings settings = direct_light(8, 16);
  const Renders free = renders_of("in the air", scene, settings);
  expect_pixels(free, floor_radiance(8, 20, irradiance), {.allowed_relative = 1e-3});
  description::Mesh tetrahedron;
  tetrahedron.positions = {tip, tip + Vec3d(0.3, 0.5, 0), tip + Vec3d(-0.2, 0.5, 0.2),
                           tip + Vec3d(-0.1, 0.5, -0.3)};
  tetrahedron.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  add_mesh(scene, tetrahedron, add_material(scene, diffuse(Vec3d(0.5))));
  expect_same_bits(renders_of("at a vertex", scene, settings), free);
}

// In a corner of a room, at the vertex of three walls: they see it edge-on, and the box in the
// room's middle sees it in full.
TEST(Stress_Lights, InTheCornerOfARoom) {
  const auto scene_with = [](bool has_room) {
    SceneDescription scene = empty_scene();
    const auto grey = add_material(scene, diffuse(Vec3d(0.5)));
    if (has_room) add_mesh(scene, inside_out(box({-1, -1, -1}, {1, 1, 1})), grey);
    add_mesh(scene, box({-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3}), grey);
    add_extent(scene);
    add_light(scene, description::PointLight{Vec3d(1.0), Vec3d(4.0)});
    set_camera(scene, {0.9, 0.8, 0.9}, {0, 0, 0}, 12);  // sees the box alone
    return scene;
  };
  const RenderSettings settings = direct_light(16, 16);
  expect_same_bits(renders_of("in a corner", scene_with(true), settings),
                   renders_of("in the air", scene_with(false), settings));
}

// --- shapes of emitters ---

// A square lamp of side 1 and radiance 1 at a height of 1, over x in [0.4, 1.4]: its corners in the
// order in which it shines down.
const std::array<Vec3d, 4> square_lamp{Vec3d(0.4, 1, -0.5), Vec3d(1.4, 1, -0.5), Vec3d(1.4, 1, 0.5),
                                       Vec3d(0.4, 1, 0.5)};

void expect_square_lamp(const std::string& name, const description::Mesh& lamp) {
  SceneDescription scene = floor_scene();
  add_mesh(scene, lamp, add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0)));
  const std::vector<Vec3d> polygon(square_lamp.begin(), square_lamp.end());
  const auto irradiance = [&](const Vec3d& p) {
    return light_test::lambert_irradiance(polygon, p, {0, 1, 0});
  };
  expect_pixels(renders_of(name, scene, direct_light(8, 64)), floor_radiance(8, 20, irradiance),
                {.allowed_relative = 2e-5, .resolution = 0.02});
}

// The lamp in columns x rows cells of two triangles each.
description::Mesh tessellated_lamp(int columns, int rows) {
  description::Mesh mesh;
  const auto row_length = static_cast<std::uint32_t>(columns + 1);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.positions.push_back(
          {0.4 + static_cast<double>(i) / columns, 1, -0.5 + static_cast<double>(j) / rows});
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
      const std::uint32_t at = j * row_length + i;
      mesh.triangles.push_back({at, at + 1, at + row_length + 1});
      mesh.triangles.push_back({at, at + row_length + 1, at + row_length});
    }
  return mesh;
}

TEST(Stress_Lights, NeedlesAndDegenerateTrianglesAsEmitters) {
  expect_square_lamp("two triangles", tessellated_lamp(1, 1));
  expect_square_lamp("2000 needles of 1:1000", tessellated_lamp(1000, 1));
  expect_square_lamp("200,000 needles of 1:100,000", tessellated_lamp(1, 100'000));
  // Triangles without an area, on its edges and beside it: points, lines, a fan of slivers.
  description::Mesh lamp = tessellated_lamp(8, 8);
  const auto first = static_cast<std::uint32_t>(lamp.positions.size());
  lamp.positions.insert(lamp.positions.end(), {{3, 3, 3}, {3.5, 3, 3}, {4, 3, 3}});
  for (int i = 0; i < 1000; ++i) {
    lamp.triangles.push_back({0, 0, 0});
    lamp.triangles.push_back({0, 1, 2});
    lamp.triangles.push_back({first, first + 1, first + 2});
    lamp.triangles.push_back({3, 40, 3});
  }
  expect_square_lamp("with 4000 degenerate ones", lamp);
}

TEST(Stress_Lights, AMillionEmitters) {
  expect_square_lamp("a million", tessellated_lamp(1000, 500));
}

// Upright on the floor and crossing the picture: light from a distance of 0 upwards.
TEST(Stress_Lights, AnEmitterThatStandsOnTheFloor) {
  SceneDescription scene = floor_scene();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
  add_mesh(scene, quad({-0.2, 0, 1}, {0, 0, -2}, {0, 0.7, 0}), lamp);  // faces +x
  const std::vector<Vec3d> polygon{{-0.2, 0, 1}, {-0.2, 0, -1}, {-0.2, 0.7, -1}, {-0.2, 0.7, 1}};
  // The camera sees the floor before the lamp as it is, and behind it only darkness.
  const auto irradiance = [&](const Vec3d& p) {
    return p.x > -0.2 ? light_test::lambert_irradiance(polygon, p, {0, 1, 0}) : 0.0;
  };
  RenderSettings settings = direct_light(16, 256);
  settings.options.crop = PixelRect{6, 0, 16, 16};  // x > -0.13, and the line of contact at -0.2
  const auto expected = floor_radiance(16, 20, irradiance);
  const auto in_crop = [&](int x, int y) { return expected(x + 6, y); };
  expect_pixels(renders_of("before it", scene, settings), in_crop,
                {.allowed_relative = 1e-4, .resolution = 0.02});
}

// --- solid angles ---

// A right triangle or a square with its corner above the origin at a height of 1, and sides of
// 2^k: from 4.5e-13 sr (half of 2^-40) to all that a plane has above it.
void expect_solid_angle(int k, bool is_square, LightSampling light_sampling) {
  const bool is_by_area = light_sampling == LightSampling::Area;
  const double side = std::ldexp(1.0, k);
  const double height = k > 0 ? std::ldexp(1.0, -k) : 1;
  const double edge = k > 0 ? 1 : side;
  // Beyond its corner, so that the origin looks into it.
  const double inset = k > 0 ? edge / 4 : 0;
  const Vec3d corner(-inset, height, -inset);
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}),
           add_material(scene, diffuse(Vec3d(0.5))));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
  const Vec3d x(edge, 0, 0), z(0, 0, edge);
  add_mesh(scene, is_square ? quad(corner, x, z) : triangle(corner, corner + x, corner + z), lamp);
  const Vec3d eye = k > 0 ? Vec3d(0, height / 4, height / 4) : Vec3d(-0.5, 0.5, 0);
  set_camera(scene, eye, {0, 0, 0}, 1e-4);
  std::vector<Vec3d> polygon{corner, corner + x};
  if (is_square) polygon.push_back(corner + x + z);
  polygon.push_back(corner + z);
  const double expected =
      0.5 / pi_double * light_test::lambert_irradiance(polygon, Vec3d(0.0), {0, 1, 0});
  const double solid_angle_bound = std::min(2 * pi_double, side * side);
  for (const SamplingStrategy sampling : {SamplingStrategy::Mis, SamplingStrategy::Light}) {
    // By area alone 1 / distance^2 has no bound for lamps that cover the sky.
    if (sampling == SamplingStrategy::Light && k > 0 && is_by_area) continue;
    const std::string name =
        fmt::format("{} of about {:.2g} sr by {}, {}", is_square ? "square" : "triangle",
                    solid_angle_bound, is_by_area ? "area" : "solid angle", name_of(sampling));
    RenderSettings settings = direct_light(2, 1024, sampling);
    settings.options.light_sampling = light_sampling;
    expect_mean(renders_of(name, scene, settings), expected,
                {.allowed_relative = 1e-5, .resolution = 0.02});
  }
}

TEST(Stress_Lights, SolidAnglesFromABillionthOfTheSunToTheWholeSky) {
  for (const LightSampling sampling : {LightSampling::Area, LightSampling::SolidAngle})
    for (const int k : {-20, -15, -10, -5, -2, 0, 2, 5, 10})
      for (const bool is_square : {false, true}) expect_solid_angle(k, is_square, sampling);
}

// --- environments ---

constexpr int map_width = 32, map_height = 16;

SceneDescription floor_under_map(const std::string& name, const light_test::TexelFunction& texel) {
  SceneDescription scene = floor_scene(1);
  scene.images.push_back(light_test::write_float_map(name, map_width, map_height, texel));
  description::LatLongEnvironment sky;
  sky.image = description::ImageHandle(std::size_t{0});
  add_light(scene, sky);
  return scene;
}

// One texel is a tent two texels wide and high (bilinear interpolation): its irradiance on the
// floor, in double.
double tent_irradiance(int y0) {
  constexpr int steps = 2000;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double du = 2 * (i + 0.5) / steps - 1, dv = 2 * (j + 0.5) / steps - 1;
      const double theta = pi_double * (y0 + 0.5 + dv) / map_height;
      sum += (1 - std::abs(du)) * (1 - std::abs(dv)) * std::max(0.0, std::cos(theta)) *
             std::sin(theta);
    }
  return sum * square(2.0 / steps) * (2 * pi_double / map_width) * (pi_double / map_height);
}

TEST(Stress_Lights, ASkyWithOneTexelOf1e9) {
  const auto texel = [](int x, int y) { return Vec3f(x == 21 && y == 3 ? 1e9f : 1.0f); };
  const SceneDescription scene = floor_under_map("sun", texel);
  const double sky = pi_double;
  const double expected = 0.5 / pi_double * (sky + (1e9 - 1) * tent_irradiance(3));
  expect_mean(renders_of("10^9", scene, direct_light(4, 256)), expected,
              {.allowed_relative = 2e-5, .resolution = 5e-3});
}

TEST(Stress_Lights, ABlackSkyIsNone) {
  const auto with_lamp = [](SceneDescription scene) {
    const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
    add_mesh(scene, tessellated_lamp(1, 1), lamp);
    return scene;
  };
  SceneDescription constant = floor_scene();
  add_light(constant, description::ConstantEnvironment{Vec3d(0.0), true});
  const auto black = [](int, int) { return Vec3f(0); };
  SceneDescription map = floor_under_map("black", black);
  map.cameras = constant.cameras;
  const RenderSettings settings = direct_light(16, 16);
  const Renders none = renders_of("none", with_lamp(floor_scene()), settings, 2);
  expect_same_bits(renders_of("constant", with_lamp(constant), settings, 2), none);
  expect_same_bits(renders_of("map", with_lamp(map), settings, 2), none);
}

}  // namespace
}  // namespace candela
