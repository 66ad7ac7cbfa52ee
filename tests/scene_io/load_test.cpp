#include "scene_io/load.h"

#include <sys/stat.h>

#include <cerrno>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;

// The first sentence, without the folder.
std::string only_error(const std::string& path) {
  const Result<SceneDescription> scene = load(path, {});
  if (scene || scene.diagnostics.list().size() != 1) return "not one error";
  std::string sentence = to_string(scene.diagnostics.list()[0]);
  const std::size_t folder = sentence.find(test::lab3_folder());
  if (folder != std::string::npos) sentence.erase(folder, test::lab3_folder().size());
  return sentence;
}

TEST(Unit_Load, AMeshAloneIsAScene) {
  for (const char* name : {"triangle.obj", "triangle.ply"}) {
    const Result<SceneDescription> scene = load(test::lab3_folder() + name, {});
    ASSERT_TRUE(scene) << name;
    ASSERT_EQ(scene->meshes.size(), 1u);
    EXPECT_EQ(scene->instances.size(), 1u);
    EXPECT_EQ(scene->materials.size(), 1u);
    EXPECT_EQ(scene->meshes[0].materials.size(), 1u);
    ASSERT_EQ(scene->lights.size(), 1u);
    const auto& light = std::get<ConstantEnvironment>(scene->lights[0].kind);
    EXPECT_EQ(light.radiance, Vec3d(1.0));
    EXPECT_TRUE(light.is_seen_by_camera);
    ASSERT_EQ(scene->cameras.size(), 1u);
    EXPECT_EQ(scene->cameras[0].target, Vec3d(0.5, 0.5, 0));
    EXPECT_EQ(scene->path, test::lab3_folder() + name);
    ASSERT_EQ(scene->files.size(), 1u);
    EXPECT_EQ(scene->files[0], test::lab3_folder() + name);
  }
}

TEST(Unit_Load, TheMtlOfAMeshAloneCountsInFull) {
  const Result<SceneDescription> scene = load(test::lab3_folder() + "with_mtl.obj", {});
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->materials.size(), 2u);
  EXPECT_EQ(scene->materials[0].emission, Vec3d(2, 0, 0));
}

// Squares of its coordinates may be 0 or no number.
TEST(Unit_Load, TheCameraOfAMeshAloneIsWhereAllOfItIsSeen) {
  for (const char* exponent : {"-170", "0", "200", "300"}) {
    const std::string path = test::lab3_folder() + "scaled.obj";
    std::ofstream(path) << fmt::format("v 0 0 0\nv 1e{0} 0 0\nv 0 1e{0} 0\nf 1 2 3\n", exponent);
    const Result<SceneDescription> scene = load(path, {});
    ASSERT_TRUE(scene) << exponent;
    const double size = scene->meshes.at(0).positions.at(1).x;
    EXPECT_NEAR(scene->cameras.at(0).eye.z / size, 1.7926, 1e-3) << exponent;
    EXPECT_FALSE(description::validate(*scene).has_errors()) << exponent;
    EXPECT_EQ(*scene->cameras.at(0).span.file, path);
  }
}

TEST(Unit_Load, TakesYamlByEitherExtension) {
  for (const char* name : {"load.yaml", "load.yml", "load.YAML"}) {
    const std::string path = test::lab3_folder() + name;
    std::ofstream(path) << "Cameras: [{Fovy: 33}]\n";
    const Result<SceneDescription> scene = load(path, {});
    ASSERT_TRUE(scene) << name;
    EXPECT_EQ(scene->cameras.at(0).fovy_degrees, 33);
    EXPECT_EQ(scene->path, path);
  }
}

TEST(Errors_Load, OptionsOfLab3ScenesCountForNoOthers) {
  const std::string pbrt = test::lab3_folder() + "options.pbrt";
  std::ofstream(pbrt) << "WorldBegin\nShape \"sphere\"\n";
  LoadOptions options;
  options.lab3_ground = "absent.jpg";
  options.ambient = Vec3d(1.0);
  options.use_mtl_materials = true;
  const auto warnings = [&](const std::string& path) {
    std::string sentences;
    const Result<SceneDescription> scene = load(path, options);
    EXPECT_TRUE(scene) << path;
    for (const Diagnostic& d : scene.diagnostics.list())
      if (d.severity == Severity::Warning) sentences += d.message + "\n";
    return sentences;
  };
  EXPECT_EQ(warnings(pbrt),
            "--lab3-ground counts for lab3 scenes only\n--ambient counts for lab3 scenes only\n"
            "--materials mtl counts for lab3 scenes only\n");
  EXPECT_EQ(warnings(test::lab3_folder() + "triangle.obj"),
            "--lab3-ground counts for lab3 scenes only\n");
}

TEST(Errors_Load, WhatIsInUtf16) {
  const std::string path = test::lab3_folder() + "utf16.pbrt";
  std::ofstream(path) << "\xff\xfeW";
  EXPECT_EQ(only_error(path), "error: 'utf16.pbrt' is in UTF-16, expected UTF-8");
}

TEST(Errors_Load, LongPathsKeepTheirEnd) {
  const std::string path = fmt::format("{}/{}.blend", std::string(60, 'a'), std::string(60, 'b'));
  EXPECT_NE(only_error(path).find("'" + path + "': found the extension '.blend'"),
            std::string::npos);
}

TEST(Errors_Load, WhatIsNoScene) {
  EXPECT_EQ(only_error("scene.blend"),
            "error: 'scene.blend': found the extension '.blend', expected a scene: .yaml, .yml, "
            ".pbrt, .obj or .ply (each also with .gz)");
  EXPECT_EQ(only_error("scene"),
            "error: 'scene': found a name without an extension, expected a scene: .yaml, .yml, "
            ".pbrt, .obj or .ply (each also with .gz)");
  EXPECT_EQ(only_error(CANDELA_SOURCE_DIR),
            "error: '" CANDELA_SOURCE_DIR
            "': found a folder, expected a scene: .yaml, .yml, .pbrt, .obj or .ply (each also "
            "with .gz)");
}

TEST(Errors_Load, FilesThatCannotBeRead) {
  EXPECT_EQ(only_error(test::lab3_folder() + "missing.yaml"),
            "missing.yaml: error: cannot be opened: No such file or directory");
  EXPECT_EQ(only_error(test::lab3_folder() + "missing.obj"),
            "missing.obj: error: cannot be opened: No such file or directory");
  const std::string pipe = test::lab3_folder() + "pipe.yaml";
  ASSERT_TRUE(::mkfifo(pipe.c_str(), 0600) == 0 || errno == EEXIST);
  EXPECT_EQ(only_error(pipe), "pipe.yaml: error: is a FIFO; expected a regular file");
}

}  // namespace
}  // namespace candela
