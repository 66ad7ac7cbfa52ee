// pbrt scenes as files: through load(), gzip'ed or not.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "scene_io/load.h"
#include "tests/scene_io/gzip.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 "
    "0 1 2\n";

TEST(Unit_PbrtFiles, MayBeGziped) {
  const TemporaryFolder folder;
  folder.put("triangle.ply.gz", gzip(triangle_ply));
  folder.put("world.pbrt.gz", gzip("Shape \"plymesh\" \"string filename\" \"triangle.ply.gz\"\n"));
  const std::string text = "\xef\xbb\xbfWorldBegin\r\nInclude \"world.pbrt.gz\"\r\n";
  for (const auto& path : {folder.put("a.pbrt", text), folder.put("b.PBRT.gz", gzip(text))}) {
    const auto scene = load(path, {});
    ASSERT_TRUE(scene) << path;
    EXPECT_EQ(scene->meshes.at(0).triangles.size(), 1u);
    // The scene's hash is of all that was read.
    EXPECT_EQ(scene->files.size(), 3u);
    EXPECT_EQ(scene->path, path);
  }
}

// So that no output overwrites them.
TEST(Unit_PbrtFiles, SpectraCount) {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (const char* name : {"light.spd", "surface.spd", "index.spd", "medium.spd"})
    files.push_back(folder.put(name, std::string("400 1\n700 1\n")));
  const std::string text = R"(WorldBegin
    LightSource "infinite" "spectrum L" "light.spd"
    Material "diffuse" "spectrum reflectance" "surface.spd"
    Shape "disk"
    Material "dielectric" "spectrum eta" "index.spd"
    MakeNamedMedium "m" "string type" "homogeneous" "spectrum sigma_a" "medium.spd"
    MediumInterface "m" ""
    Shape "sphere")";
  const auto scene = load(folder.put("a.pbrt", text), {});
  ASSERT_TRUE(scene);
  for (const std::string& file : files)
    EXPECT_EQ(std::count(scene->files.begin(), scene->files.end(), file), 1) << file;
}

// Names are relative to the file that they stand in.
TEST(Unit_PbrtFiles, EqualMaterialsOfTwoFoldersNameTwoFiles) {
  const TemporaryFolder folder;
  std::string text = "WorldBegin\n";
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directory(folder.file(name));
    const std::string inside = std::string(name) + "/";
    folder.put(inside + "s.spd", std::string(name[0] == 'a' ? "300 1\n900 1\n" : "300 0\n900 0"));
    folder.put(inside + "n.png", std::string("not looked into by the reader"));
    folder.put(inside + "part.pbrt",
               std::string("Material \"diffuse\" \"spectrum reflectance\" \"s.spd\"\n"
                           "Shape \"disk\"\n"
                           "Material \"diffuse\" \"string normalmap\" \"n.png\"\n"
                           "Shape \"disk\"\n"));
    text += "Include \"" + inside + "part.pbrt\"\n";
  }
  text += "Include \"a/part.pbrt\"\n";  // whose materials are there
  const auto scene = load(folder.put("scene.pbrt", text), {});
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->materials.size(), 4u);
  const auto reflectance = [&](std::size_t i) {
    return std::get<description::DiffuseMaterial>(scene->materials[i].model).reflectance.factor.y;
  };
  EXPECT_NEAR(reflectance(0), 1, 1e-9);
  EXPECT_NEAR(reflectance(2), 0, 1e-9);
  EXPECT_NE(scene->materials[1].normal_map, scene->materials[3].normal_map);
}

TEST(Unit_PbrtFiles, MeshesComeInTheOrderOfTheText) {
  const TemporaryFolder folder;
  std::string text = "WorldBegin\n";
  for (int i = 0; i < 40; ++i) {
    const std::string name = std::to_string(i) + ".ply";
    folder.put(name, std::string(triangle_ply));
    text += "Shape \"plymesh\" \"string filename\" \"" + name + "\"\n";
  }
  const auto scene = load(folder.put("a.pbrt", text), {});
  ASSERT_TRUE(scene);
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_TRUE(scene->meshes.at(i).name.ends_with("/" + std::to_string(i) + ".ply"));
}

TEST(Errors_PbrtFiles, FilesThatAreNotThereOrNoFiles) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& text) {
    const auto scene = load(folder.put("a.pbrt", "WorldBegin\n" + text), {});
    return scene.diagnostics.list().empty() ? "" : to_string(scene.diagnostics.list()[0]);
  };
  EXPECT_NE(
      error_of("Shape \"plymesh\" \"string filename\" \"none.ply\"").find("a.pbrt:2:17: error: '"),
      std::string::npos);
  EXPECT_NE(error_of("Shape \"plymesh\" \"string filename\" \"\"").find("a.pbrt:2:17: error: '"),
            std::string::npos);
  EXPECT_NE(error_of("Include \"none.pbrt\"").find("a.pbrt:2:9: error: '"), std::string::npos);
  EXPECT_NE(
      error_of("LightSource \"infinite\" \"string filename\" \"/\"").find("is no regular file"),
      std::string::npos);
}

TEST(Errors_PbrtFiles, LetterCaseIsSpokenOfOnce) {
  const TemporaryFolder folder;
  folder.put("triangle.ply", std::string(triangle_ply));
  const auto scene = load(
      folder.put("a.pbrt",
                 std::string("WorldBegin\nShape \"plymesh\" \"string filename\" \"Triangle.ply\"")),
      {});
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene.diagnostics.warning_count(), 1u);
}

}  // namespace
}  // namespace candela
