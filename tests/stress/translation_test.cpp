// Places far from the origin, and far outliers: compile() moves the scene to its own centre in
// double, before floats are made.
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene_io/load.h"
#include "tests/scene_io/pbrt/write/round_trip.h"
#include "tests/scenes/temporary_folder.h"
#include "tests/stress/busy_room.h"
#include "tests/stress/disturb.h"
#include "tests/stress/row.h"
#include "tests/stress/undisturbed.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

// Neither along an axis nor carried by few bits.
const Vec3d far_direction = normalize(Vec3d(0.9, -0.7, 0.4));

RenderSettings heavy_or_light() {
  return settings_of(24, is_heavy() ? 256 : 16);
}

// Asserted up to 10^6 diameters; what happens at 10^7 the table tells.
template <class Move>
void expect_no_error_against_distance(const std::string& what, const Move& move) {
  const SceneDescription room = busy_room();
  const Renders undisturbed = renders_of("undisturbed", room, heavy_or_light());
  for (int k = 0; k <= 7; ++k) {
    if (!is_heavy() && k % 2 == 1) continue;
    const Vec3d offset = far_direction * (diameter_of(room) * std::pow(10.0, k));
    const Renders disturbed = renders_of(fmt::format("10^{} diameters, {}", k, what),
                                         move(room, offset), heavy_or_light());
    if (k <= 6)
      expect_within_noise(disturbed, undisturbed);
    else
      add_comparison(disturbed, undisturbed);
  }
}

TEST(Stress_Translation, OfVertices) {
  expect_no_error_against_distance("vertices",
                                   [](const SceneDescription& scene, const Vec3d& offset) {
                                     return moved(scene, offset, Where::Vertices);
                                   });
}

TEST(Stress_Translation, OfInstances) {
  expect_no_error_against_distance("instances",
                                   [](const SceneDescription& scene, const Vec3d& offset) {
                                     return moved(scene, offset, Where::Instances);
                                   });
}

// The scene stays where it is, but its meshes' own vertices lie far from their origin.
TEST(Stress_Translation, OfVerticesThatInstancesTakeBack) {
  expect_no_error_against_distance(
      "there and back", [](const SceneDescription& scene, const Vec3d& offset) {
        return moved(moved(scene, offset, Where::Vertices), -offset, Where::Instances);
      });
}

// "v x y z" with enough digits for a double.
std::string moved_obj(const std::string& text, const Vec3d& offset) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line); result += line + '\n') {
    std::istringstream words(line);
    std::string keyword;
    Vec3d p;
    if (words >> keyword >> p.x >> p.y >> p.z && keyword == "v")
      line =
          fmt::format("v {:.17g} {:.17g} {:.17g}", p.x + offset.x, p.y + offset.y, p.z + offset.z);
  }
  return result;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The box of assets/, its numbers written anew around another place.
SceneDescription moved_cornell_box(const Vec3d& offset) {
  const std::filesystem::path assets = CANDELA_SOURCE_DIR "/assets/cornell_box_diffuse";
  const TemporaryFolder folder;
  for (const auto& entry : std::filesystem::directory_iterator(assets)) {
    std::string text = text_of(entry.path());
    if (entry.path().extension() == ".obj") text = moved_obj(text, offset);
    folder.put(entry.path().filename(), text);
  }
  Result<SceneDescription> scene = load(folder.file("cornell_box_diffuse.yaml"), {});
  EXPECT_TRUE(scene);
  scene->cameras[0].eye += offset;
  scene->cameras[0].target += offset;
  return std::move(*scene);
}

TEST(Stress_Translation, OfNumbersInFiles) {
  const Renders undisturbed =
      renders_of("undisturbed", moved_cornell_box(Vec3d(0.0)), heavy_or_light());
  for (const double distance : {1e3, 1e6})
    expect_within_noise(
        renders_of(fmt::format("{:g} diameters, OBJ", distance),
                   moved_cornell_box(far_direction * (559.2 * distance)), heavy_or_light()),
        undisturbed);
}

// Vertices in the text and in PLY files, transforms, lights and the camera's.
TEST(Stress_Translation, OfNumbersInPbrtFiles) {
  for (const Where where : {Where::Vertices, Where::Instances}) {
    const auto read_back = [&](double distance) {
      const SceneDescription room = busy_room();
      const Vec3d offset = far_direction * (diameter_of(room) * distance);
      RoundTrip trip = round_trip(distance == 0 ? room : moved(room, offset, where));
      EXPECT_FALSE(trip.written.meshes.empty());
      return std::move(trip.scene);
    };
    const Renders undisturbed = renders_of("undisturbed", read_back(0), heavy_or_light());
    for (const double distance : {1e3, 1e6})
      expect_within_noise(
          renders_of(fmt::format("{:g} diameters, pbrt, {}", distance,
                                 where == Where::Vertices ? "vertices" : "transforms"),
                     read_back(distance), heavy_or_light()),
          undisturbed);
  }
}

// A triangle out of sight far below and behind the scene, half as large as it is far.
SceneDescription with_outlier(double diameters) {
  SceneDescription scene = busy_room();
  const Vec3d at = Vec3d(-1, -1, -1) * (diameter_of(scene) * diameters);
  add_mesh(scene, triangle(at, at * Vec3d(1.5, 1, 1), at * Vec3d(1, 1.5, 1)),
           add_material(scene, diffuse(Vec3d(0.5))));
  return scene;
}

// A triangle that reaches from just behind the back wall to far away.
SceneDescription with_long_outlier(double diameters) {
  SceneDescription scene = busy_room();
  const Vec3d far = Vec3d(-0.1, -1, -1) * (diameter_of(scene) * diameters);
  add_mesh(scene, triangle({0, -1.5, -1.5}, far, far * Vec3d(1.5, 1, 1)),
           add_material(scene, diffuse(Vec3d(0.5))));
  return scene;
}

TEST(Stress_Translation, OneFarOutlierDoesNotSpoilTheRest) {
  const Renders undisturbed = renders_of("undisturbed", busy_room(), heavy_or_light());
  for (const double distance : {1e1, 1e3, 1e6, 1e9, 1e12, 1e30}) {
    if (!is_heavy() && distance == 1e3) continue;
    expect_within_noise(renders_of(fmt::format("outlier at {:g} diameters", distance),
                                   with_outlier(distance), heavy_or_light()),
                        undisturbed);
    expect_within_noise(renders_of(fmt::format("outlier up to {:g} diameters", distance),
                                   with_long_outlier(distance), heavy_or_light()),
                        undisturbed);
  }
}

}  // namespace
}  // namespace candela
