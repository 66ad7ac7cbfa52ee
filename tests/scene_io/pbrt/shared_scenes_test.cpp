// Bitterli's scenes as pbrt-v4 files, where they are present: they load without an error, to what
// their authors put in.
#include <gtest/gtest.h>

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

TEST(Agreement_PbrtScenes, LoadWithWhatIsInThem) {
  const Expected scenes[] = {{"cornell-box", 36},
                             {"veach-mis", 52, 3},
                             {"veach-ajar", 382690},
                             {"classroom", 103832},
                             {"staircase2", 30927 + 5 * disk},
                             {"staircase", 262663},
                             {"teapot", 126050}};
  for (const Expected& expected : scenes) {
    const auto path = shared_scene("pbrt/" + std::string(expected.file) + "/scene-v4.pbrt");
    if (!path) GTEST_SKIP() << "the shared scenes are not here";
    const auto scene = load(*path, {});
    ASSERT_TRUE(scene) << to_string(scene.diagnostics.list().front());
    EXPECT_EQ(triangles_of(*scene), expected.triangles) << expected.file;
    EXPECT_EQ(spheres_of(*scene), expected.spheres) << expected.file;
    EXPECT_EQ(scene.diagnostics.warning_count(), expected.warnings) << expected.file;
    EXPECT_FALSE(description::validate(*scene).has_errors()) << expected.file;
  }
}

}  // namespace
}  // namespace candela
