// --integrator report and --rr on the command line.
#include <nlohmann/json.hpp>

#include "tests/tools/refusals.h"

namespace candela::cli_test {
namespace {

TEST(Errors_ReportOptions, AreRefusedInSentences) {
  for (const std::string p : {"0", "1.5", "-1", "nan", "1e-60", "half"})
    expect_refused({cornell_box, "--integrator", "report", "--rr", p}, 2,
                   "--rr: expected a number above 0 and up to 1, found '" + p + "'");
  expect_refused({cornell_box, "--rr", "0.5"}, 2,
                 "--rr is an option of the report integrator, this is path");
  expect_refused({assets + "/glass_and_metal/glass_and_metal.yaml", "--integrator", "report"}, 3,
                 "glass_and_metal.yaml:28:5: error: material 'glass' is a dielectric");
}

TEST(Unit_ReportOptions, StatsTellTheProbabilityToGoOn) {
  const std::string folder = fresh_folder("report_stats");
  const ProgramResult result =
      run_candela({"render", cornell_box, "--integrator", "report", "--rr", "0.5", "--size", "8x8",
                   "--spp", "64", "-o", folder + "/a.exr", "--stats", folder + "/a.json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto stats = nlohmann::json::parse(file_text(folder + "/a.json"));
  EXPECT_EQ(stats["integrator"], "report");
  EXPECT_EQ(stats["kernel"], "report");
  EXPECT_EQ(stats["rr"], 0.5);
  // At most 1 / (1 - P) calls a path, and not many fewer in a box with one open side.
  const double calls =
      1 + stats["rays"]["indirect"].get<double>() / stats["rays"]["camera"].get<double>();
  EXPECT_LT(calls, 2.05);
  EXPECT_GT(calls, 1.5);
}

}  // namespace
}  // namespace candela::cli_test
