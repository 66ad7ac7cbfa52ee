// --stats against docs/stats.schema.json, by a validator that is tested here too.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/json_schema.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

std::string schema() {
  return file_text(CANDELA_SOURCE_DIR "/docs/stats.schema.json");
}

Json stats_of(const std::vector<std::string>& more, const std::string& scene = small_scene()) {
  const std::string folder = fresh_folder("stats");
  std::vector<std::string> arguments{
      "render", scene,   "-o", folder + "/a.exr", "--size",
      "12x8",   "--spp", "3",  "--stats",         folder + "/stats.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = run_candela(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return Json::parse(file_text(folder + "/stats.json"));
}

void expect_valid(const Json& stats) {
  for (const std::string& violation : schema_violations(schema(), stats.dump()))
    ADD_FAILURE() << violation << "\n" << stats.dump(2);
}

TEST(Unit_Stats, KeepToTheirSchema) {
  expect_valid(stats_of({}));
  expect_valid(stats_of({"--ray-limit"}));
  expect_valid(stats_of({"--replicates", "1", "--clamp", "3"}));
  expect_valid(stats_of({"--error", "50%", "--time", "10s"}));
  expect_valid(stats_of({"--integrator", "whitted", "--spp", "4", "--specular", "phong"}));
  expect_valid(stats_of({"--integrator", "raster", "--spp", "1", "--lab-normals"}));
  expect_valid(stats_of({"--crop", "1,2,5,6", "--max-depth", "3", "--transparent", "--accel", "bvh",
                         "--filter", "box", "--seed", "18446744073709551615"}));
}

TEST(Unit_Stats, TellWhatWasAskedAndDone) {
  Json stats = stats_of({"-t", "2", "--seed", "9", "--max-depth", "4"});
  EXPECT_EQ(stats["scene"], small_scene());
  EXPECT_EQ(stats["width"], 12);
  EXPECT_EQ(stats["height"], 8);
  EXPECT_EQ(stats["spp"], 3);
  EXPECT_EQ(stats["min_samples"], 3);
  EXPECT_EQ(stats["max_samples"], 3);
  EXPECT_EQ(stats["threads"], 2);
  EXPECT_EQ(stats["seed"], 9);
  EXPECT_EQ(stats["max_depth"], 4);
  EXPECT_EQ(stats["invalid_samples"], 0);
  EXPECT_EQ(stats["rays"]["camera"], 12 * 8 * 3);
  EXPECT_GT(stats["rays"]["shadow"], 0);
  EXPECT_GT(stats["rays"]["indirect"], 0);
  EXPECT_GT(stats["peak_memory_bytes"], 1'000'000);
  EXPECT_GT(stats["seconds"]["render"], 0);
  const double cpu_seconds = stats["cpu_seconds"]["render"];
  EXPECT_GT(cpu_seconds, 0);
  EXPECT_LE(cpu_seconds, 4 * stats["seconds"]["render"].get<double>() + 0.05);  // two threads
  EXPECT_EQ(stats["cpu_seconds"]["decoding"], 0);
  EXPECT_EQ(stats["outputs"].size(), 1u);
  EXPECT_EQ(stats["interrupted"], false);
}

TEST(Unit_Stats, TellWhatImagesTookThatRaysMet) {
  const Json stats = stats_of({"-t", "1"}, CANDELA_SOURCE_DIR "/assets/cutouts/cutouts.yaml");
  const double decoding = stats["cpu_seconds"]["decoding"];
  EXPECT_GT(decoding, 0);
  EXPECT_LT(decoding, stats["cpu_seconds"]["render"]);
}

// A wall before the camera, another one behind it, and a point light at this z; nothing but direct
// light, so that no ray leaves for what the camera does not see.
Json stats_of_two_walls(const std::string& light_z, const std::string& wall_behind,
                        const std::vector<std::string>& more) {
  const std::string folder = fresh_folder("walls");
  for (const char* image : {"tiles", "bricks"})
    std::filesystem::copy(fmt::format("{}/assets/cutouts/{}.png", CANDELA_SOURCE_DIR, image),
                          folder);
  write_text(folder + "/before.obj",
             "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
             "f 1/1 2/2 3/3 4/4\n");
  write_text(folder + "/behind.obj",
             "v -9 -9 8\nv 9 -9 8\nv 9 9 8\nv -9 9 8\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
             "f 4/4 3/3 2/2 1/1\n");
  write_text(folder + "/walls.yaml",
             "Cameras: [{Eye: [0, 0, 4], Target: [0, 0, 0], Fovy: 40}]\n"
             "Lights: [{Type: Point, Position: [0, 0, " +
                 light_z +
                 "], Intensity: [9, 9, 9]}]\n"
                 "Materials:\n"
                 "  - {Name: tiles, Type: diffuse, kd_map: tiles.png}\n"
                 "  - {Name: bricks, Type: diffuse, kd_map: bricks.png}\n"
                 "Models:\n  - {Mesh: before.obj, Material: tiles}\n"
                 "  - {Mesh: behind.obj, Material: " +
                 wall_behind + "}\n");
  std::vector<std::string> arguments{"--max-depth", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return stats_of(arguments, folder + "/walls.yaml");
}

TEST(Unit_Stats, CountShadowRaysOfSurfacesThatTurnFromTheirLamp) {
  constexpr int samples = 12 * 8 * 3;
  for (const char* kernel : {"special", "general"}) {
    const auto stats_with_light_at = [&](const char* z) {
      return stats_of_two_walls(z, "bricks", {"--kernel", kernel});
    };
    const Json behind_the_wall = stats_with_light_at("-2");
    EXPECT_EQ(behind_the_wall["skipped"]["shadow_rays"], samples) << kernel;
    EXPECT_EQ(behind_the_wall["rays"]["shadow"], 0) << kernel;
    const Json before_it = stats_with_light_at("2");
    EXPECT_EQ(before_it["skipped"]["shadow_rays"], 0) << kernel;
    EXPECT_EQ(before_it["rays"]["shadow"], samples) << kernel;
    // Of the box's walls some turn from some of its lamp.
    EXPECT_GT(stats_of({"--kernel", kernel})["skipped"]["shadow_rays"], 0) << kernel;
  }
}

TEST(Unit_Stats, CountTheImagesThatNoRayMeets) {
  EXPECT_EQ(stats_of_two_walls("2", "bricks", {})["skipped"]["textures"], 1);
  EXPECT_EQ(stats_of_two_walls("2", "tiles", {})["skipped"]["textures"], 0);
  EXPECT_EQ(stats_of({})["skipped"]["textures"], 0);
}

TEST(Unit_Stats, TheImageTellsTheSame) {
  const std::string folder = fresh_folder("metadata");
  const ProgramResult result =
      run_candela({"render", small_scene(), "-q", "-o", folder + "/a.exr", "--size", "4x4", "--spp",
                   "1", "--seed", "77", "--stats", folder + "/stats.json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  Json stats = Json::parse(file_text(folder + "/stats.json"));
  const std::string exr = file_text(folder + "/a.exr");
  // An EXR header holds a text as name, 0, type, 0, size (four bytes), characters.
  const auto text_in_exr = [&](const std::string& name) {
    const std::size_t place = exr.find(name + '\0' + "string" + '\0');
    return place == std::string::npos ? "" : exr.substr(place + name.size() + 12);
  };
  for (const char* name : {"version", "command", "scene", "scene_hash", "integrator", "kernel"})
    EXPECT_TRUE(
        text_in_exr("candela:" + std::string(name)).starts_with(stats[name].get<std::string>()))
        << name;
  EXPECT_TRUE(text_in_exr("candela:seed").starts_with("77"));
  for (const char* name : {"candela:options", "candela:spp", "candela:seconds_render"})
    EXPECT_NE(exr.find(name), std::string::npos) << name;
}

TEST(Unit_Stats, TheLimitRatioIsThereWhenAskedFor) {
  EXPECT_FALSE(stats_of({}).contains("limit_ratio"));
  EXPECT_GT(stats_of({"--ray-limit"})["limit_ratio"], 0);
}

TEST(Unit_Stats, TheSceneHashDoesNotDependOnTheFolder) {
  const std::string folder = fresh_folder("stats_copy");
  std::filesystem::copy(std::filesystem::path(small_scene()).parent_path(), folder,
                        std::filesystem::copy_options::recursive);
  const std::string copy = folder + "/cornell_box_diffuse.yaml";
  const Json hash = stats_of({}).at("scene_hash");
  EXPECT_EQ(hash, stats_of({}, copy)["scene_hash"]);
  write_text(folder + "/tall_box.obj", file_text(folder + "/tall_box.obj") + "# changed\n");
  EXPECT_NE(hash, stats_of({}, copy)["scene_hash"]);
}

// Each kind of lie is found.
TEST(Unit_Stats, TheValidatorFindsViolations) {
  const Json valid = stats_of({});
  const auto count_after = [&](const char* patch) {
    return schema_violations(schema(), valid.patch(Json::parse(patch)).dump()).size();
  };
  EXPECT_EQ(count_after("[]"), 0u);
  EXPECT_EQ(count_after(R"([{"op":"remove","path":"/kernel"}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"add","path":"/surprise","value":1}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"replace","path":"/spp","value":1.5}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"replace","path":"/spp","value":0}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"replace","path":"/accel","value":"none"}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"replace","path":"/scene_hash","value":"xyz"}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"remove","path":"/seconds/write"}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"remove","path":"/crop/0"}])"), 1u);
  EXPECT_EQ(count_after(R"([{"op":"add","path":"/warnings/0","value":3}])"), 1u);
  EXPECT_EQ(schema_violations(R"({"maximum":3})", "1").size(), 1u);
}

}  // namespace
}  // namespace candela::cli_test
