// `candela info`, `check` and `bench` through the built program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

constexpr const char* cutouts = CANDELA_SOURCE_DIR "/assets/cutouts/cutouts.yaml";

Json json_of(const std::vector<std::string>& arguments) {
  const ProgramResult result = run_candela(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return Json::parse(result.output, nullptr, false);
}

TEST(Unit_Info, TellsWhatIsInTheCornellBox) {
  Json info = json_of({"info", small_scene(), "--json", "--accel", "embree"});
  EXPECT_EQ(info["scene"], small_scene());
  EXPECT_EQ(info["scene_hash"].get<std::string>().size(), 32u);
  EXPECT_EQ(info["lights"], Json({{"triangle", 2}}));
  EXPECT_EQ(info["cameras"], 1);
  EXPECT_GE(info["triangles"], 30);
  EXPECT_EQ(info["instanced_triangles"], info["triangles"]);
  EXPECT_NEAR(info["bounds"]["min"][1].get<double>(), 0, 1e-3);
  EXPECT_NEAR(info["bounds"]["max"][1].get<double>(), 548.8, 1e-3);
  EXPECT_GT(info["memory_bytes"]["meshes"], 30 * 12);
  EXPECT_GT(info["memory_bytes"]["embree"], 0);
  EXPECT_FALSE(info["memory_bytes"].contains("bvh"));
  EXPECT_FALSE(info["kernel"].get<std::string>().empty());
  EXPECT_EQ(info["faces"], 17);
  EXPECT_EQ(info["listed_spheres"], 0);
  EXPECT_EQ(info["boxes"], 0);
  EXPECT_EQ(info["textures"].size(), 0u);
}

TEST(Unit_Info, TellsWhichTexturesAreRead) {
  const std::string folder = fresh_folder("info_textures");
  std::filesystem::copy(std::filesystem::path(cutouts).parent_path(), folder,
                        std::filesystem::copy_options::recursive);
  const std::string text = file_text(cutouts);
  const std::size_t materials = text.find("Materials:\n");
  ASSERT_NE(materials, std::string::npos);
  std::filesystem::copy(folder + "/bricks.png", folder + "/unused.png");
  write_text(folder + "/cutouts.yaml",
             text.substr(0, materials + 11) +
                 "  - Name: nobody_uses_this\n    Type: diffuse\n    kd_map: unused.png\n" +
                 text.substr(materials + 11));
  Json info = json_of({"info", folder + "/cutouts.yaml", "--json"});
  const auto is_used = [&](const std::string& name) {
    for (Json& texture : info["textures"])
      if (texture["path"].get<std::string>().ends_with("/" + name)) return texture["used"] == true;
    ADD_FAILURE() << name << " is not listed";
    return false;
  };
  EXPECT_TRUE(is_used("leaf.png"));
  EXPECT_TRUE(is_used("bricks.png"));
  EXPECT_FALSE(is_used("unused.png"));
}

TEST(Unit_Info, TheTextNamesEveryPart) {
  const ProgramResult result = run_candela({"info", small_scene()});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  for (const char* part : {"hash", "triangles", "instances", "cameras", "lights", "bounds",
                           "memory", "kernel", "rays", "materials", "textures", "dropped"})
    EXPECT_NE(result.output.find(fmt::format("\n  {} ", part)), std::string::npos) << part;
}

TEST(Unit_Info, TellsWhatIsLookedAtWithoutATree) {
  const std::string scene =
      CANDELA_SOURCE_DIR "/assets/pbrt_textured_lights/pbrt_textured_lights.pbrt";
  Json info = json_of({"info", scene, "--json"});
  EXPECT_EQ(info["faces"], 3);
  EXPECT_EQ(info["listed_spheres"], 2);
  EXPECT_EQ(info["boxes"], 0);
  const ProgramResult text = run_candela({"info", scene});
  EXPECT_NE(text.output.find("against all of 3 faces and 2 spheres, without a tree\n"),
            std::string::npos)
      << text.output;
}

TEST(Unit_Check, CountsWhatIsWrong) {
  const ProgramResult good = run_candela({"check", small_scene()});
  EXPECT_EQ(good.exit_code, 0) << good.error;
  EXPECT_EQ(good.output, small_scene() + ": 0 errors, 0 warnings\n");

  const std::string scene = fresh_folder("check") + "/scene.yaml";
  write_text(scene,
             "Cameras:\n  - Eye: [0, 0, 1]\n    Target: [0, 0, 0]\n    Fovi: 3\n"
             "Lights:\n  - Type: Point\nMaterials:\n  - Name: m\n"
             "Models:\n  - Mesh: absent.obj\n  - Mesh: missing.obj\n");
  const ProgramResult bad = run_candela({"check", scene});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_NE(bad.error.find("absent.obj"), std::string::npos) << bad.error;
  EXPECT_NE(bad.error.find("missing.obj"), std::string::npos) << bad.error;
  EXPECT_NE(bad.error.find("did you mean 'Fovy'"), std::string::npos) << bad.error;
  EXPECT_NE(bad.output.find(": 2 errors, 1 warning\n"), std::string::npos) << bad.output;
}

// The header is whole, so that only decoding finds it.
TEST(Unit_Check, FindsImagesThatBreakOffInTheirPixels) {
  const std::string folder = fresh_folder("check_image");
  std::filesystem::copy(std::filesystem::path(cutouts).parent_path(), folder,
                        std::filesystem::copy_options::recursive);
  const std::string image = file_text(folder + "/tiles.png");
  write_text(folder + "/tiles.png", image.substr(0, image.size() / 2));
  const ProgramResult result = run_candela({"check", folder + "/cutouts.yaml"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.error.find("tiles.png"), std::string::npos) << result.error;
  EXPECT_EQ(result.output.find(", 0 warnings"), std::string::npos) << result.output;
}

TEST(Unit_Check, RefusesWhatTheScenesOwnIntegratorCannotDraw) {
  const std::string folder = fresh_folder("check_integrator");
  std::filesystem::copy(std::filesystem::path(small_scene()).parent_path(), folder,
                        std::filesystem::copy_options::recursive);
  std::string text = file_text(small_scene());
  const std::string integrator = "Integrator: path";
  const std::size_t place = text.find(integrator);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, integrator.size(), "Integrator: report");
  const std::string scene = folder + "/scene.yaml";
  write_text(scene, text +
                        "\nLights:\n  - Type: Point\n    Position: [278, 273, 0]\n"
                        "    Intensity: [1, 1, 1]\n");
  const ProgramResult result = run_candela({"check", scene});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.error.find("the scene has a point light; the report"), std::string::npos)
      << result.error;
  EXPECT_NE(result.output.find(": 1 error, 0 warnings\n"), std::string::npos) << result.output;
}

TEST(Unit_Bench, MeasuresBothBackEnds) {
  Json bench = json_of({"bench", small_scene(), "--json", "-t", "1", "--seconds", "0.01"});
  EXPECT_EQ(bench["agreement"]["disagreeing"], 0);
  for (const char* back_end : {"embree", "bvh"}) {
    EXPECT_GT(bench[back_end]["bytes"], 0);
    for (const char* rays : {"camera", "bounce", "shadow"}) {
      EXPECT_GT(bench["rays"][rays], 0);
      EXPECT_GT(bench[back_end]["mrays_per_second"][rays], 0) << back_end << rays;
    }
  }
  for (const char* rays : {"camera", "bounce", "shadow"}) {
    const Json ratio = bench["embree_over_bvh"][rays];
    EXPECT_GT(ratio["least"], 0) << rays;
    EXPECT_GE(ratio["most"], ratio["median"]) << rays;
  }
  for (const char* way : {"block", "single"}) EXPECT_GT(bench["number_nanoseconds"][way], 0) << way;
}

}  // namespace
}  // namespace candela::cli_test
