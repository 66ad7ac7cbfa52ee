// --sampling, --heuristic, --fresnel and --geometry on the command line.
#include <nlohmann/json.hpp>

#include "tests/tools/refusals.h"

namespace candela::cli_test {
namespace {

TEST(Errors_StrategyOptions, AreRefusedInSentences) {
  expect_refused({assets + "/glass_and_metal/glass_and_metal.yaml", "--sampling", "light"}, 3,
                 "glass_and_metal.yaml:28:5: error: material 'glass' is a smooth dielectric, in "
                 "which sampling by 'light' cannot see lights; expected mis or bsdf");
  expect_refused({cornell_box, "--integrator", "whitted", "--sampling", "mis"}, 2,
                 "--sampling is for path and report, this is whitted");
  expect_refused({cornell_box, "--integrator", "report", "--sampling", "mis"}, 2,
                 "expected light, cosine or uniform");
  expect_refused({cornell_box, "--sampling", "light", "--heuristic", "balance"}, 2,
                 "--heuristic weights the strategies of path with --sampling mis");
  expect_refused({cornell_box, "--ray-limit", "--sampling", "bsdf"}, 2,
                 "not with --sampling or --heuristic");
}

nlohmann::json stats_of(std::vector<std::string> words) {
  const std::string folder = fresh_folder("strategy_stats");
  words.insert(words.begin(), {"render", cornell_box});
  words.insert(words.end(), {"--size", "8x8", "--spp", "4", "-o", folder + "/a.exr", "--stats",
                             folder + "/a.json"});
  const ProgramResult result = run_candela(words);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return nlohmann::json::parse(file_text(folder + "/a.json"));
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
  EXPECT_EQ(stats_of({})["kernel"], "path/plain");
  EXPECT_EQ(stats_of({"--integrator", "report"})["sampling"], "light");
}

}  // namespace
}  // namespace candela::cli_test
