// The scenes we ship are read without a word of complaint and are what their files say.
#include <gtest/gtest.h>

#include <filesystem>

#include "renderer/scene/compile.h"
#include "scene_io/load.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

const fs::path assets = fs::path(CANDELA_SOURCE_DIR) / "assets";

std::string all_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.list()) text += to_string(diagnostic) + "\n";
  return text;
}

std::vector<std::string> files_with(const std::string& extension) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(assets))
    if (entry.path().extension() == extension) files.push_back(entry.path().string());
  return files;
}

std::vector<std::string> scene_files() {
  std::vector<std::string> files = files_with(".yaml");
  for (std::string& file : files_with(".pbrt")) files.push_back(std::move(file));
  return files;
}

TEST(Unit_Assets, LoadAndCompileWithoutDiagnostics) {
  ASSERT_GE(files_with(".yaml").size(), 4u);
  ASSERT_GE(files_with(".pbrt").size(), 3u);
  for (const std::string& file : scene_files()) {
    const Result<description::SceneDescription> description = load(file, {});
    EXPECT_EQ(all_of(description.diagnostics), "");
    ASSERT_TRUE(description) << file;
    const Result<Scene> scene = compile(*description, {});
    EXPECT_EQ(all_of(scene.diagnostics), "");
    EXPECT_TRUE(scene) << file;
  }
}

TEST(Unit_Assets, AreSmall) {
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(assets))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LT(bytes, 2'000'000u);
}

// Where a mesh shines it shines downwards: the lamps hang under ceilings.
TEST(Unit_Assets, LampsFaceDown) {
  int lamps = 0;
  for (const std::string& file : files_with(".yaml")) {
    const Result<description::SceneDescription> description = load(file, {});
    ASSERT_TRUE(description) << file;
    for (const description::Instance& instance : description->instances) {
      const description::Mesh& mesh = description->meshes[instance.mesh.index];
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto own = mesh.materials[mesh.materials.size() == 1 ? 0 : i];
        const auto material = instance.material_override ? instance.material_override : own;
        if (description->materials[material.index].emission == Vec3d{0.0}) continue;
        const auto& [a, b, c] = mesh.triangles[i];
        const Vec3d& p = mesh.positions[a];
        EXPECT_LT(cross(mesh.positions[b] - p, mesh.positions[c] - p).y, 0.0) << file;
        ++lamps;
      }
    }
  }
  EXPECT_GE(lamps, 6);
}

}  // namespace
}  // namespace candela
