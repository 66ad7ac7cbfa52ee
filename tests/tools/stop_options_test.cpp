// --error, --relmse, --time, --replicates and --clamp on the command line.
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/refusals.h"

namespace candela::cli_test {
namespace {

TEST(Errors_StopOptions, AreRefusedInSentences) {
  expect_refused({cornell_box, "--error", "0%"}, 2, "expected an error above 0 such as 1% or 0.01");
  expect_refused({cornell_box, "--error", "%"}, 2, "found '%'");
  for (const char* extreme : {"1e-200", "1e200"})
    expect_refused({cornell_box, "--error", extreme}, 2,
                   "expected an error of which the square is a number");
  expect_refused({cornell_box, "--time", "5x"}, 2, "expected a time above 0 such as 60s");
  expect_refused({cornell_box, "--replicates", "0"}, 2, "expected a whole number from 1");
  for (const char* number : {"-1", "1e39", "1e-39"})
    expect_refused({cornell_box, "--clamp", number}, 2, "expected a number from 1.2e-38 to 3.4e38");
  expect_refused({cornell_box, "--relmse", "1e-320"}, 2, "expected a number above 0");
  expect_refused({cornell_box, "--integrator", "report", "--rr", "1e-40"}, 2,
                 "expected a number above 0 and up to 1");
  expect_refused({cornell_box, "--error", "1%", "--replicates", "1"}, 2,
                 "--error needs an error to go by, and --replicates 1 states none");
  expect_refused({cornell_box, "--relmse", "1e-3", "--integrator", "whitted"}, 2,
                 "--relmse is for path and report, this is whitted");
  expect_refused({cornell_box, "--without", "opacity-grids", "--integrator", "raster"}, 2,
                 "--without opacity-grids is for path and report, this is raster");
  expect_refused({cornell_box, "--time", "1s", "--ray-limit"}, 2, "--ray-limit needs --spp");
}

TEST(Errors_StopOptions, ATimeForNoSampleIsToldAndNothingIsWritten) {
  const std::string folder = fresh_folder("no_time");
  const ProgramResult result =
      run_candela({"render", cornell_box, "--size", "16x16", "--time", "1e-9s", "-o",
                   folder + "/a.exr", "--stats", folder + "/a.json"});
  EXPECT_EQ(result.exit_code, 5) << result.error;
  EXPECT_NE(result.error.find("the time did not suffice for a single sample; nothing was written"),
            std::string::npos)
      << result.error;
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

struct StopRun {
  nlohmann::json stats;
  std::string exr;
  std::string messages;
};

StopRun run_of(std::vector<std::string> words) {
  const std::string folder = fresh_folder("stop_options");
  words.insert(words.begin(), {"render", cornell_box, "--size", "16x16"});
  words.insert(words.end(), {"-o", folder + "/a.exr", "--stats", folder + "/a.json"});
  const ProgramResult result = run_candela(words);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return {nlohmann::json::parse(file_text(folder + "/a.json")), file_text(folder + "/a.exr"),
          result.error};
}

TEST(Unit_StopOptions, AnErrorIsReachedAndToldEverywhere) {
  const StopRun run = run_of({"--error", "30%"});
  EXPECT_EQ(run.stats["stop"]["by"], "error");
  EXPECT_NEAR(run.stats["stop"]["target_relmse"].get<double>(), 0.09, 1e-12);
  EXPECT_TRUE(run.stats["spp"].is_null());
  const auto& error = run.stats["error"];
  EXPECT_LE(error["relmse"], 0.09);
  EXPECT_NEAR(error["rmse"].get<double>(), std::sqrt(error["relmse"].get<double>()), 1e-12);
  EXPECT_LT(error["interval95"][0], error["relmse"]);
  EXPECT_GT(error["interval95"][1], error["relmse"]);
  EXPECT_NE(run.messages.find("stopped by --error at "), std::string::npos) << run.messages;
  for (const char* name : {"candela:stop", "candela:relmse", "candela:rmse", "candela:relmse_low",
                           "candela:relmse_high", "candela:heavy_tails"})
    EXPECT_NE(run.exr.find(name), std::string::npos) << name;
}

TEST(Unit_StopOptions, TheScenesOwnSamplesCountOnlyWithoutARule) {
  const StopRun easy = run_of({"--relmse", "1e9"});
  EXPECT_EQ(easy.stats["max_samples"], 16);
  EXPECT_NE(easy.messages.find("stopped by --relmse at 16 spp, error "), std::string::npos)
      << easy.messages;
  const StopRun both = run_of({"--relmse", "1e-9", "--spp", "17"});
  EXPECT_EQ(both.stats["max_samples"], 17);
  EXPECT_EQ(both.stats["stop"]["by"], "spp");
  EXPECT_EQ(both.stats["spp"], 17);
  EXPECT_NE(both.messages.find("; all of 17 spp, error "), std::string::npos) << both.messages;
  const StopRun timed = run_of({"--time", "3s"});
  EXPECT_EQ(timed.stats["stop"]["by"], "time");
  EXPECT_NE(timed.messages.find("stopped by --time at "), std::string::npos) << timed.messages;
}

TEST(Unit_StopOptions, OneReplicateAdaptsWhereThatIsAskedFor) {
  const StopRun plain = run_of({"--spp", "64", "--replicates", "1"});
  EXPECT_EQ(plain.stats["min_samples"], 64);
  EXPECT_EQ(plain.stats["max_samples"], 64);
  const StopRun adaptive = run_of({"--spp", "64", "--replicates", "1", "--adaptive", "on"});
  EXPECT_LT(adaptive.stats["min_samples"], 64);
  EXPECT_GT(adaptive.stats["max_samples"], 64);
  EXPECT_NEAR(adaptive.stats["mean_samples"].get<double>(), 64, 3);
  EXPECT_TRUE(adaptive.stats["error"].is_null());
}

// Lamps that are met by chance alone: most of the light is in few samples.
TEST(Unit_StopOptions, ErrorsThatCannotBeTrustedAreWarnedOf) {
  const char* const warning = "rare strong samples hold most of the light";
  const StopRun rare = run_of({"--spp", "16", "--sampling", "bsdf"});
  EXPECT_GT(rare.stats["error"]["heavy_tails"], 0.5);
  EXPECT_NE(rare.messages.find(warning), std::string::npos) << rare.messages;
  const StopRun even = run_of({"--spp", "64"});
  EXPECT_EQ(even.stats["error"]["heavy_tails"], 0);
  EXPECT_EQ(even.messages.find(warning), std::string::npos) << even.messages;
}

TEST(Unit_StopOptions, TheErrorOfTwoSamplesIsWarnedOf) {
  const char* const warning = "two samples a pixel know little of their error";
  const StopRun two = run_of({"--spp", "2"});
  EXPECT_GT(two.stats["error"]["relmse"], 0);
  EXPECT_NE(two.messages.find(warning), std::string::npos) << two.messages;
  for (const char* spp : {"1", "3"}) {
    const StopRun run = run_of({"--spp", spp});
    EXPECT_EQ(run.messages.find(warning), std::string::npos) << run.messages;
  }
}

// Lamps of which no path gets to know: bounces are forbidden, and the camera looks elsewhere.
TEST(Unit_StopOptions, APictureWithoutAnyLightTellsThatItKnowsNothing) {
  const StopRun run =
      run_of({"--error", "1%", "--spp", "64", "--max-depth", "0", "--crop", "0,12,4,16"});
  EXPECT_EQ(run.stats["stop"]["by"], "spp");
  EXPECT_TRUE(run.stats["error"].is_null());
  EXPECT_NE(run.messages.find("no sample has met light, though the scene has some"),
            std::string::npos)
      << run.messages;
  EXPECT_EQ(run.exr.find("candela:rmse"), std::string::npos);
}

// Where only an error ends the render, that is while it goes on, which may be for ever.
TEST(Unit_StopOptions, APictureWithoutAnyLightTellsThatWhileItGoesOn) {
  const std::string folder = fresh_folder("no_light");
  Program program(candela_words({"render", cornell_box, "--size", "16x16", "--max-depth", "0",
                                 "--crop", "0,12,4,16", "--error", "1%", "-o", folder + "/a.exr"}),
                  ErrorStream::Terminal);
  EXPECT_TRUE(program.wait_for_error_text(", no light met yet"));
  program.send(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
}

TEST(Unit_StopOptions, ReplicatesAndClampAreTold) {
  const StopRun plain = run_of({"--spp", "8"});
  EXPECT_EQ(plain.stats["replicates"], 4);
  EXPECT_EQ(plain.stats["biased"], nlohmann::json::array());
  EXPECT_EQ(plain.exr.find("candela:biased"), std::string::npos);
  const StopRun one = run_of({"--spp", "8", "--replicates", "1"});
  EXPECT_EQ(one.stats["replicates"], 1);
  EXPECT_TRUE(one.stats["error"].is_null());
  const StopRun clamped = run_of({"--spp", "8", "--clamp", "10", "--max-depth", "3"});
  EXPECT_EQ(clamped.stats["biased"], (nlohmann::json{"clamp 10", "max depth 3"}));
  EXPECT_NE(clamped.exr.find("candela:biased"), std::string::npos);
  EXPECT_NE(clamped.messages.find("biased"), std::string::npos);
}

}  // namespace
}  // namespace candela::cli_test
