// tools/scene_gen: the scenes that benchmarks are made of are read without a word, are the same for
// the same seed, and are what they say.
#include <filesystem>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/generated_scenes.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

ProgramResult generate_all(const std::string& out, int seed) {
  return generate_scenes(generated_scenes(), out, seed);
}

// All meshes of a folder, one after another. (The YAML file's comment names the seed.)
std::string meshes_of(const std::string& folder) {
  std::string all;
  for (const std::string& name : file_names(folder))
    if (!name.ends_with(".yaml")) all += name + file_text(folder + "/" + name);
  return all;
}

class Unit_SceneGen : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_generate_scenes()) GTEST_SKIP() << "Debian's python3-numpy is not installed";
  }
};

TEST_F(Unit_SceneGen, EverySceneIsReadWithoutAWordAndHasTheTrianglesThatItSays) {
  const std::string folder = fresh_folder("scenes");
  const ProgramResult made = generate_all(folder, 1);
  ASSERT_EQ(made.exit_code, 0) << made.error;
  for (const GeneratedScene& scene : generated_scenes()) {
    const ProgramResult read =
        run_candela({"info", folder + "/" + scene.name + "/" + scene.name + ".yaml", "--json"});
    ASSERT_EQ(read.exit_code, 0) << read.error;
    EXPECT_EQ(read.error, "") << scene.name;
    EXPECT_EQ(Json::parse(read.output)["instanced_triangles"], scene.triangles) << scene.name;
  }
}

TEST_F(Unit_SceneGen, TheSameSeedGivesTheSameFilesAndAnotherOneOthers) {
  const std::string first = fresh_folder("first"), again = fresh_folder("again"),
                    other = fresh_folder("other");
  ASSERT_EQ(generate_all(first, 1).exit_code, 0);
  ASSERT_EQ(generate_all(again, 1).exit_code, 0);
  ASSERT_EQ(generate_all(other, 2).exit_code, 0);
  for (const GeneratedScene& scene : generated_scenes()) {
    const std::string name = "/" + scene.name, yaml = name + name + ".yaml";
    EXPECT_TRUE(file_text(first + yaml) == file_text(again + yaml)) << scene.name;
    EXPECT_TRUE(meshes_of(first + name) == meshes_of(again + name)) << scene.name;
    EXPECT_EQ(meshes_of(first + name) != meshes_of(other + name), scene.is_random) << scene.name;
  }
}

TEST_F(Unit_SceneGen, WhatIsRefusedLeavesNoFolder) {
  const std::string folder = fresh_folder("refused") + "/none";
  const ProgramResult refused =
      Program({python, "-B", CANDELA_SOURCE_DIR "/tools/dev/scene_gen/main.py", "lamps", "--lamps",
               "0", "--out", folder},
              ErrorStream::File)
          .finish();
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.error.find("lamps"), std::string::npos) << refused.error;
  EXPECT_EQ(refused.error.find("Traceback"), std::string::npos) << refused.error;
  EXPECT_FALSE(std::filesystem::exists(folder));
}

// Large meshes are PLY files; they look like the OBJ files of small ones.
TEST_F(Unit_SceneGen, LargeMeshesAreFlatOrSmoothAsSmallOnesAre) {
  const std::string folder = fresh_folder("mesh");
  const std::string script =
      "import sys, pathlib; sys.path.insert(0, '" CANDELA_SOURCE_DIR
      "/tools/dev')\n"
      "from scene_gen import files, shapes\n"
      "folder = pathlib.Path('" +
      folder +
      "')\n"
      "for name, mesh in (('flat', shapes.sphere((0, 0, 0), 1.0, 1, smooth=False)),\n"
      "                   ('smooth', shapes.sphere((0, 0, 0), 1.0, 2))):\n"
      "    files.write_obj(folder / (name + '_obj.obj'), mesh)\n"
      "    files.write_ply(folder / (name + '_ply.ply'), mesh)\n"
      "    for end in ('obj', 'ply'):\n"
      "        (folder / f'{name}_{end}.yaml').write_text(\n"
      "            'Lights: [{Type: Directional, Direction: [3, 1, 2]}]\\nCameras: [{Eye: [3, 4, "
      "5], Target: [0, 0, "
      "0]}]\\n'\n"
      "            'Materials: [{Name: a, Type: diffuse}]\\n'\n"
      "            f'Models: [{{Mesh: {name}_{end}.{end}, Material: a}}]\\n')\n";
  const ProgramResult written = Program({python, "-B", "-c", script}, ErrorStream::File).finish();
  ASSERT_EQ(written.exit_code, 0) << written.error;
  for (const std::string name : {"flat", "smooth"}) {
    std::vector<std::string> pictures;
    for (const std::string end : {"obj", "ply"}) {
      const std::string base = folder + "/" + name + "_" + end;
      pictures.push_back(base + ".exr");
      ASSERT_EQ(run_candela({"render", base + ".yaml", "-o", pictures.back(), "--size", "24x24",
                             "--spp", "4", "--quiet"})
                    .exit_code,
                0);
    }
    const ProgramResult compared =
        run_candela({"compare", pictures[0], pictures[1], "--max-relmse", "1e-6"});
    EXPECT_EQ(compared.exit_code, 0) << name << compared.output;
  }
}

TEST_F(Unit_SceneGen, TheForestShowsTenMillionTrianglesAndStoresFew) {
  const std::string folder = fresh_folder("forest");
  ASSERT_EQ(Program({python, "-B", CANDELA_SOURCE_DIR "/tools/dev/scene_gen/main.py", "forest",
                     "--out", folder},
                    ErrorStream::File)
                .finish()
                .exit_code,
            0);
  const Json info =
      Json::parse(run_candela({"info", folder + "/forest.yaml", "--json", "--strict"}).output);
  EXPECT_GT(info["instanced_triangles"], 10'000'000);
  EXPECT_LT(info["triangles"], 50'000);
}

TEST_F(Unit_SceneGen, WithoutArgumentsTheCommandNamesAllScenesAndTheirParameters) {
  const ProgramResult told =
      Program({python, "-B", CANDELA_SOURCE_DIR "/tools/dev/scene_gen/main.py"}, ErrorStream::File)
          .finish();
  EXPECT_EQ(told.exit_code, 0) << told.error;
  for (const GeneratedScene& scene : generated_scenes())
    EXPECT_NE(told.output.find("tools/scene_gen " + scene.name + " "), std::string::npos)
        << scene.name;
  EXPECT_NE(told.output.find("--albedo"), std::string::npos);
}

TEST_F(Unit_SceneGen, TheCommandWritesWhatItSaysAndRefusesInASentence) {
  const std::string folder = fresh_folder("command");
  const auto run = [&](const std::string& albedo) {
    return Program({python, "-B", CANDELA_SOURCE_DIR "/tools/dev/scene_gen/main.py", "white_room",
                    "--out", folder, "--albedo", albedo},
                   ErrorStream::File)
        .finish();
  };
  EXPECT_EQ(run("0.5").output, folder + "/white_room.yaml\n");
  EXPECT_EQ(run_candela({"check", folder + "/white_room.yaml", "--strict"}).exit_code, 0);
  const ProgramResult refused = run("1");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.error,
            "tools/scene_gen: --albedo is 1; expected 0 to below 1, or light never ends\n");
}

}  // namespace
}  // namespace candela::cli_test
