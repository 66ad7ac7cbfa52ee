// The kernel that a scene gets for what it needs against the one for all scenes, with the command
// line's options: the same bits and the same counts, of every asset and every generated scene, and
// of the shared scenes where they are present.
#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>

#include "scene_io/load.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scene_io/shared_scenes.h"
#include "tests/scenes/coincident_walls.h"
#include "tests/scenes/render_scene.h"
#include "tests/tools/generated_scenes.h"

namespace candela {
namespace {

namespace fs = std::filesystem;
using test::RenderSettings;

constexpr int size = 32;
constexpr int samples_per_pixel = 20;  // no whole blocks: pixels share those of the last four

// A scene's file, or the word with which its test is skipped.
struct Found {
  std::string path;
  std::string missing;
};

struct Case {
  std::string name;
  std::function<Found()> find;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

Found find_shared(const std::string& name) {
  if (const std::optional<std::string> path = shared_scene(name)) return {*path, ""};
  return {"", "the shared scenes are not here"};
}

Found generate(const cli_test::GeneratedScene& scene) {
  if (!cli_test::can_generate_scenes()) return {"", "Debian's python3-numpy is not installed"};
  const std::string folder = cli_test::fresh_folder(scene.name);
  const cli_test::ProgramResult made = cli_test::generate_scenes({scene}, folder, 1);
  EXPECT_EQ(made.exit_code, 0) << made.error;
  return {folder + "/" + scene.name + "/" + scene.name + ".yaml", ""};
}

std::string as_test_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return text;
}

// Whatever lies there, so that a new asset is a new case.
void add_assets(std::vector<Case>& cases) {
  for (const auto& entry : fs::recursive_directory_iterator(CANDELA_SOURCE_DIR "/assets")) {
    const fs::path& path = entry.path();
    if (path.extension() == ".yaml" || path.extension() == ".pbrt")
      cases.push_back({"asset_" + path.stem().string(), [file = path.string()] {
                         return Found{file, ""};
                       }});
  }
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_assets(cases);
  for (const cli_test::GeneratedScene& scene : cli_test::generated_scenes())
    cases.push_back({"generated_" + scene.name, [scene] { return generate(scene); }});
  for (const std::string name : {"cornell_box", "floor", "teapot", "bunny", "white_oak", "sibenik",
                                 "breakfast_room", "sports_car", "sponza"})
    cases.push_back({"lab3_" + name,
                     [file = "lab3/" + name + "/" + name + ".yaml"] { return find_shared(file); }});
  for (const std::string name :
       {"cornell-box", "veach-mis", "classroom", "staircase", "staircase2", "teapot", "veach-ajar"})
    cases.push_back({as_test_name("pbrt_" + name),
                     [file = "pbrt/" + name + "/scene-v4.pbrt"] { return find_shared(file); }});
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.name < b.name; });
  return cases;
}

// The command line's, for so few pixels and samples.
RenderSettings settings_for(const description::SceneDescription& description) {
  RenderSettings settings = test::settings_of(size, samples_per_pixel);
  settings.options.max_depth = description.defaults.max_depth;
  settings.options.chooses_roulette = true;
  settings.options.lamp_rays = 8;
  return settings;
}

RenderResult by_general_kernel(const Scene& scene, RenderSettings settings) {
  settings.options.uses_general_kernel = true;
  return test::rendered(scene, settings);
}

// In any bit.
std::size_t different_pixels(const Image& a, const Image& b) {
  EXPECT_EQ(a.values.size(), b.values.size());
  const std::size_t bytes = a.channel_count() * sizeof(float);
  std::size_t count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      count += std::memcmp(a.pixel(x, y), b.pixel(x, y), bytes) != 0 ? 1 : 0;
  return count;
}

void expect_same_counts(const RenderStatistics& special, const RenderStatistics& general) {
  EXPECT_EQ(special.rays.camera, general.rays.camera);
  EXPECT_EQ(special.skipped.samples, general.skipped.samples);
  EXPECT_EQ(special.rays.indirect, general.rays.indirect);
  EXPECT_EQ(special.rays.shadow, general.rays.shadow);
  EXPECT_EQ(special.rays.lamp, general.rays.lamp);
  EXPECT_EQ(special.skipped.shadow_rays, general.skipped.shadow_rays);
}

void expect_same_by_both(const Scene& scene, const RenderSettings& settings) {
  const RenderResult special = test::rendered(scene, settings);
  const RenderResult general = by_general_kernel(scene, settings);
  // Scenes that are seen from within a medium have none of their own.
  EXPECT_EQ(special.statistics.kernel == general.statistics.kernel,
            scene.features.cameras_in_media);
  EXPECT_GT(special.statistics.rays.indirect, 0u);
  const Image picture = special.film.to_image(true);
  EXPECT_GT(test::mean_of(picture), 0);
  EXPECT_EQ(different_pixels(picture, general.film.to_image(true)), 0u);
  expect_same_counts(special.statistics, general.statistics);
}

class Agreement_SpecialKernels : public testing::TestWithParam<Case> {};

TEST_P(Agreement_SpecialKernels, GiveTheBitsOfTheGeneralOne) {
  const Found found = GetParam().find();
  if (!found.missing.empty()) GTEST_SKIP() << found.missing;
  const Result<description::SceneDescription> description = load(found.path, {});
  ASSERT_TRUE(description) << found.path;
  RenderSettings settings = settings_for(*description);
  const Scene scene = test::compiled(*description, settings.options);
  settings.options.replicates = 1;
  expect_same_by_both(scene, settings);
  settings.options.replicates = 4;
  settings.options.aovs = test::all_aovs | aov_bit(Aov::Variance);
  expect_same_by_both(scene, settings);
}

INSTANTIATE_TEST_SUITE_P(, Agreement_SpecialKernels, testing::ValuesIn(all_cases()),
                         [](const auto& scene) { return scene.param.name; });

// Of surfaces in the very same place a packet may meet another one in other company
// (integrators/path/trace_block.h): both kernels have to fill their packets alike, also beside
// pixels that see nothing but a constant background, whose samples are skipped.
TEST(Agreement_CoincidentWalls, AreTheSameByBothKernels) {
  for (const double distance : {2.5, 6.0}) {
    description::SceneDescription description = test::walls_of_two_colours();
    test::set_camera(description, {0.1, 0.2, distance}, {0, 0, 0}, 40);
    for (const int samples : {1, 3, 7, 16, 20}) {
      RenderSettings settings = test::settings_of(48, samples);
      settings.accelerator = AcceleratorKind::Embree;  // small scenes would do without packets
      settings.options.filter = FilterKind::Box;
      const Scene scene = test::compiled(description, settings.options);
      const RenderResult special = test::rendered(scene, settings);
      const RenderResult general = by_general_kernel(scene, settings);
      EXPECT_EQ(special.statistics.skipped.samples > 0, distance > 3);
      EXPECT_EQ(different_pixels(special.film.to_image(true), general.film.to_image(true)), 0u)
          << distance << ", " << samples;
      expect_same_counts(special.statistics, general.statistics);
    }
  }
}

TEST(Agreement_SpecialKernelsCases, AreWhatIsThere) {
  std::vector<std::string> names;
  for (const Case& c : all_cases()) names.push_back(c.name);
  for (const char* name : {"asset_cornell_box", "asset_pbrt_media", "generated_forest"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

}  // namespace
}  // namespace candela
