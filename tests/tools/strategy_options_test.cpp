// --sampling, --heuristic and --guiding on the command line.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/tools/refusals.h"

namespace candela::cli_test {
namespace {

TEST(Errors_StrategyOptions, AreRefusedInSentences) {
  expect_refused(
      {assets + "/pbrt_materials/pbrt_materials.pbrt", "--sampling", "cosine"}, 3,
      "pbrt_materials.pbrt:42:19: error: material 'paint' is smoothly coated, and "
      "sampling by 'cosine' does not follow the coat's reflection; expected mis, bsdf or "
      "light");
  expect_refused({cornell_box, "--integrator", "whitted", "--sampling", "mis"}, 2,
                 "--sampling is for path and report, this is whitted");
  expect_refused({cornell_box, "--integrator", "report", "--sampling", "mis"}, 2,
                 "expected light, cosine or uniform");
  expect_refused({cornell_box, "--sampling", "light", "--heuristic", "balance"}, 2,
                 "--heuristic weights the strategies of path with --sampling mis");
  for (const char* option : {"--sky-samples", "--light-cells"})
    expect_refused(
        {cornell_box, "--sampling", "bsdf", option, "on"}, 2,
        fmt::format("{} is about samples of lights, of which --sampling bsdf takes none", option));
  expect_refused({cornell_box, "--sampling", "bsdf", "--light-sampling", "triangles"}, 2,
                 "--light-sampling is about samples of lights");
  expect_refused({cornell_box, "--sampling", "light", "--sky-compensation", "off"}, 2,
                 "--sky-compensation is about the strategies of path with --sampling mis");
  expect_refused({cornell_box, "--ray-limit", "--sampling", "bsdf"}, 2,
                 "not with --sampling or --heuristic");
  expect_refused({cornell_box, "--guiding", "on", "--sampling", "light"}, 2,
                 "--guiding is for --sampling mis --heuristic power");
  expect_refused({cornell_box, "--guiding", "auto", "--ray-limit"}, 2, "not with --guiding");
  expect_refused({cornell_box, "--guiding", "on", "--integrator", "report"}, 2,
                 "--guiding is for path, this is report");
  expect_refused({cornell_box, "--reuse", "on", "--integrator", "report"}, 2,
                 "--reuse is for path, this is report");
  expect_refused({cornell_box, "--reuse", "on", "--splitting", "2"}, 2,
                 "--reuse on and --splitting 2: paths are shared where one goes on from each first "
                 "hit, by its surface alone");
  expect_refused({cornell_box, "--reuse", "on", "--guiding", "auto"}, 2,
                 "--reuse on and --guiding auto");
}

nlohmann::json stats_of(std::vector<std::string> words) {
  const std::string folder = fresh_folder("strategy_stats");
  words.insert(words.begin(), {"render", cornell_box});
  if (std::find(words.begin(), words.end(), "--spp") == words.end())
    words.insert(words.end(), {"--spp", "4"});
  words.insert(words.end(),
               {"--size", "8x8", "-o", folder + "/a.exr", "--stats", folder + "/a.json"});
  const ProgramResult result = run_candela(words);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return nlohmann::json::parse(file_text(folder + "/a.json"));
}

TEST(Unit_StrategyOptions, StatsTellOfGuides) {
  EXPECT_TRUE(stats_of({})["guiding"].is_null());
  EXPECT_EQ(stats_of({"--guiding", "on"})["guiding"]["cells"], 0) << "too few samples";
  const auto guided = stats_of({"--guiding", "on", "--spp", "2000"});
  EXPECT_EQ(guided["guiding"]["training_samples"], 12800);
  EXPECT_GE(guided["guiding"]["cells"], guided["guiding"]["guided_cells"]);
  EXPECT_EQ(guided["kernel"], guided["guiding"]["cells"] > 0 ? "path/guided" : "path/lanes");
}

TEST(Unit_StrategyOptions, StatsTellTheStrategy) {
  const auto bsdf = stats_of({"--sampling", "bsdf"});
  EXPECT_EQ(bsdf["sampling"], "bsdf");
  EXPECT_EQ(bsdf["kernel"], "path/strategies");
  EXPECT_EQ(bsdf["rays"]["shadow"], 0);
  const auto balance = stats_of({"--heuristic", "balance"});
  EXPECT_EQ(balance["sampling"], "mis");
  EXPECT_EQ(balance["heuristic"], "balance");
  EXPECT_EQ(balance["kernel"], "path/strategies");
  EXPECT_EQ(stats_of({})["kernel"], "path/lanes");
  EXPECT_EQ(stats_of({})["reuse"], false);
  EXPECT_EQ(stats_of({"--reuse", "on"})["reuse"], true);
  EXPECT_EQ(stats_of({"--integrator", "report"})["sampling"], "light");
}

}  // namespace
}  // namespace candela::cli_test
