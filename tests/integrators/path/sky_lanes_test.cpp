// Skies in lanes against the functions of single directions: the same bits.
#include "integrators/path/sky_lanes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/light/directions.h"
#include "tests/light/map_images.h"

namespace candela {
namespace {

using light_test::MapEnvironment;
using light_test::random_direction;
using light_test::random_pair;
using light_test::random_unit;
using light_test::write_byte_map;
using light_test::write_float_map;

constexpr std::uint64_t blocks = 200;

Vec3f uneven(int x, int y) {
  return {1 + static_cast<float>((x * 7 + y * 3) % 11), 2 + static_cast<float>(x % 5),
          y == 3 ? 40.0f : 0.5f};
}

// Turned and mirrored; the faces of the cube are of two sizes and encodings, and one is even.
std::vector<MapEnvironment> maps() {
  const Mat3d turn = Mat3d(Vec3d(0, 0.6, 0.8), Vec3d(1, 0, 0), Vec3d(0, 0.8, -0.6));
  std::array<description::Image, 6> faces;
  for (std::size_t i = 0; i < faces.size(); ++i)
    faces[i] = i < 3 ? write_float_map(fmt::format("lanes{}", i), 8, 8, uneven)
                     : write_byte_map(fmt::format("lanes{}", i), 4, 4, uneven);
  faces[5] = write_byte_map("lanes_even", 1, 1, uneven);
  std::vector<MapEnvironment> made;
  made.push_back(light_test::cube(faces));
  made.push_back(light_test::lat_long(write_float_map("lanes_around", 16, 8, uneven), turn));
  made.push_back(light_test::equal_area(write_float_map("lanes_square", 8, 8, uneven), turn));
  return made;
}

// Random ones, axes and poles.
Vec3Lanes directions_of(std::uint64_t block) {
  Vec3Lanes directions;
  for (std::uint32_t i = 0; i < block_size; ++i)
    directions.set(i, random_direction(block * block_size + i, 1));
  directions.set(1, {0, 1, 0});
  directions.set(2, {0, -1, 0});
  directions.set(3, {-1, 0, 0});
  directions.set(4, {0, 0, 1});
  return directions;
}

TEST(Agreement_SkyLanes, PointsAreThoseOfSingleDirections) {
  for (const MapEnvironment& map : maps())
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const Vec3Lanes directions = directions_of(block);
      SkyPointLanes points;
      find_sky_points(map.environment, directions, points);
      for (std::uint32_t i = 0; i < block_size; ++i) {
        const EnvironmentPoint single = environment_point(map.environment, directions[i]);
        ASSERT_EQ(points.face[i], single.face);
        ASSERT_EQ(points[i].uv, single.uv);
      }
    }
}

TEST(Agreement_SkyLanes, RadianceIsThatOfSingleDirections) {
  const LaneMask lanes = 0xff7b;
  for (const MapEnvironment& map : maps())
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const Vec3Lanes directions = directions_of(block);
      for (const Coherence coherence : {Coherence::Coherent, Coherence::Incoherent}) {
        Vec3Lanes radiance;
        find_sky_radiance(map.environment, map.textures, lanes, directions, coherence, radiance);
        for_each_lane(lanes, [&](std::uint32_t i) {
          ASSERT_EQ(radiance[i], map.radiance(directions[i]));
          ASSERT_GT(radiance[i].x, 0);
        });
      }
    }
}

TEST(Agreement_SkyLanes, LightSamplesAreThoseOfSinglePoints) {
  const LaneMask lanes = 0x7fde;
  for (const MapEnvironment& map : maps())
    for (std::uint64_t block = 0; block < blocks; ++block) {
      PlainLanes plain;
      for (std::uint32_t i = 0; i < block_size; ++i) {
        const std::uint64_t number = block * block_size + i;
        plain.met.position.set(i, random_direction(number, 2));
        plain.met.normal.set(i, random_direction(number, 3));
        plain.met.offset[i] = 1e-3f;
        Vec2f u = random_pair(number, 4);
        plain.lamps.u_x[i] = u.x;
        plain.lamps.u_y[i] = u.y;
        plain.light_samples.pdf[i] = 7;
      }
      sample_sky_in_lanes(map.environment, lanes, plain);
      for (std::uint32_t i = 0; i < block_size; ++i) {
        const LightSample found = plain.light_samples[i];
        if ((lanes >> i & 1) == 0) {
          ASSERT_EQ(found.pdf, 7);
          continue;
        }
        const LightSample single = sky_sample(
            sample_environment(map.environment, {plain.lamps.u_x[i], plain.lamps.u_y[i]}),
            point_of(plain.met, i));
        ASSERT_GT(found.pdf, 0);
        ASSERT_EQ(found.pdf, single.pdf);
        ASSERT_EQ(found.wi, single.wi);
        ASSERT_EQ(found.radiance, single.radiance);
        ASSERT_EQ(found.is_delta, single.is_delta);
        ASSERT_EQ(found.shadow_ray.origin, single.shadow_ray.origin);
        ASSERT_EQ(found.shadow_ray.direction, single.shadow_ray.direction);
        ASSERT_EQ(found.shadow_ray.t_max, single.shadow_ray.t_max);
      }
    }
}

// Paths after delta lobes among them, which light samples do not compete with.
TEST(Agreement_SkyLanes, MetLightIsThatOfSinglePaths) {
  const LaneMask lanes = 0xfbf6;
  for (MapEnvironment& map : maps()) {
    Scene scene;
    scene.environment = std::move(map.environment);
    scene.textures = std::move(map.textures);
    scene.environment_light = 0;
    scene.lights.resize(2);
    scene.lights[0].kind = LightKind::Environment;
    scene.lights[1].kind = LightKind::Quad;
    scene.light_sampler = LightSampler(scene.lights, std::array{1.0, 2.0});
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const Vec3Lanes directions = directions_of(block);
      PathLanes paths;
      Vec3Lanes radiance;
      for (std::uint32_t i = 0; i < block_size; ++i) {
        const std::uint64_t number = block * block_size + i;
        paths.set(i, {.throughput = glm::abs(random_direction(number, 5)),
                      .radiance = Rgb(random_unit(number, 6)),
                      .bsdf_pdf = random_unit(number, 7),
                      .is_delta = i % 5 == 0});
        radiance.set(i, glm::abs(random_direction(number, 8)));
      }
      const PathLanes before = paths;
      add_met_sky(scene, lanes, directions, radiance, paths);
      for (std::uint32_t i = 0; i < block_size; ++i) {
        PathState single = before[i];
        if ((lanes >> i & 1) != 0)
          add_environment<lane_features>(scene, {}, directions[i], radiance[i], single);
        ASSERT_EQ(paths.radiance[i], single.radiance);
      }
    }
  }
}

}  // namespace
}  // namespace candela
