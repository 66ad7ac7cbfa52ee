// Bitterli's scenes as pbrt-v4 files, where they are present: they load without an error, to what
// their authors put in.
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/description/validate.h"
#include "scene_io/load.h"
#include "tests/scene_io/shared_scenes.h"

namespace candela {
namespace {

struct Expected {
  const char* file;
  std::size_t triangles;
  std::size_t spheres = 0;
  std::size_t warnings = 0;
};

std::size_t triangles_of(const description::SceneDescription& scene) {
  std::size_t count = 0;
  for (const description::Instance& instance : scene.instances)
    count += scene.meshes[instance.mesh.index].triangles.size();
  return count;
}

std::size_t spheres_of(const description::SceneDescription& scene) {
  std::size_t count = 0;
  for (const description::Instance& instance : scene.instances)
    count += scene.meshes[instance.mesh.index].sphere.has_value();
  return count;
}

// Disks count with the triangles that they become.
constexpr std::size_t disk = 128;

class Agreement_PbrtScenes : public testing::TestWithParam<Expected> {};

TEST_P(Agreement_PbrtScenes, LoadWithWhatIsInThem) {
  const Expected& expected = GetParam();
  const auto path = shared_scene("pbrt/" + std::string(expected.file) + "/scene-v4.pbrt");
  if (!path) GTEST_SKIP() << "the shared scene is not here";
  const auto scene = load(*path, {});
  ASSERT_TRUE(scene) << to_string(scene.diagnostics.list().front());
  EXPECT_EQ(triangles_of(*scene), expected.triangles);
  EXPECT_EQ(spheres_of(*scene), expected.spheres);
  EXPECT_EQ(scene.diagnostics.warning_count(), expected.warnings);
  EXPECT_FALSE(description::validate(*scene).has_errors());
}

INSTANTIATE_TEST_SUITE_P(, Agreement_PbrtScenes,
                         testing::Values(Expected{"cornell-box", 36}, Expected{"veach-mis", 52, 3},
                                         Expected{"veach-ajar", 382690},
                                         Expected{"classroom", 103832},
                                         Expected{"staircase2", 30927 + 5 * disk},
                                         Expected{"staircase", 262663}, Expected{"teapot", 126050}),
                         [](const auto& info) {
                           std::string name = info.param.file;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace candela
