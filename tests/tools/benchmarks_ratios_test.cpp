// tools/bench: ratios, their noise, means over scenes, and what they are judged by.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tools/benchmarks_questions.h"

namespace candela::cli_test {
namespace {

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

class Unit_BenchmarksRatios : public BenchmarksQuestions {};

// y = 3 x^.5 exactly; and the textbook's standard error of a slope, here of (0, 0), (1, 2), (2, 2),
// (3, 4) in logarithms: slope 1.2, residuals' squares .8.
TEST_F(Unit_BenchmarksRatios, ExponentsAreThoseOfTheData) {
  const Json exact = ask({"power", "[1, 4, 16, 64]", "[3, 6, 12, 24]"});
  EXPECT_NEAR(exact["exponent"], 0.5, 1e-12);
  EXPECT_NEAR(exact["error"], 0, 1e-9);
  EXPECT_NEAR(exact["factor"], 3, 1e-9);
  const double e = std::exp(1.0);
  const std::string x = fmt::format("[1, {}, {}, {}]", e, e * e, e * e * e);
  const std::string y = fmt::format("[1, {}, {}, {}]", e * e, e * e, std::pow(e, 4));
  const Json noisy = ask({"power", x, y});
  EXPECT_NEAR(noisy["exponent"], 1.2, 1e-12);
  EXPECT_NEAR(noisy["error"], std::sqrt(0.8 / 2 / 5), 1e-12);
}

// y is flat below 10^4, and in proportion from there on.
TEST_F(Unit_BenchmarksRatios, GrowthOverTrianglesCountsFromTenThousandOn) {
  EXPECT_NEAR(ask({"growth", "[100, 1000, 9900, 100000]", "[9900, 9900, 9900, 100000]"}), 1, 1e-9);
  EXPECT_NEAR(ask({"growth", "[100, 1000, 10000]", "[1, 10, 100]"}), 1, 1e-9) << "of all";
}

// Student's t for 95 %, from tables; of so many degrees of freedom.
constexpr double t1 = 12.70620, t2 = 4.30265, t7 = 2.36462, t14 = 2.14479, t15 = 2.13145;

// The error of a geometric mean: of 1 and 4 the logarithms' deviation is log(4) / sqrt(2), their
// mean's error half of log 4.
TEST_F(Unit_BenchmarksRatios, MeansHaveFactorsByWhichTheyMayBeOff) {
  const Json two = ask({"with_factor", "[1, 4]"});
  EXPECT_NEAR(two[0], 2, 1e-12);
  EXPECT_NEAR(std::log(two[1].get<double>()), t1 * std::log(4) / 2, 1e-4);
  const Json one = ask({"with_factor", "[3]"});
  EXPECT_NEAR(one[0], 3, 1e-12);
  EXPECT_TRUE(one[1].is_null()) << "a single pair tells nothing of its error";
  EXPECT_EQ(ask({"with_factor", "[1, -2]"}), Json::parse("[null, null]"));
}

TEST_F(Unit_BenchmarksRatios, SpreadsAreMedianAndRange) {
  EXPECT_EQ(ask({"spread", "[5, 1, 2]"}), (Json{{"median", 2}, {"low", 1}, {"high", 5}}));
  EXPECT_NEAR(ask({"geometric_mean", "[2, 8]"}), 4, 1e-12);
}

// Straight in logarithms between points; nothing beyond them.
TEST_F(Unit_BenchmarksRatios, TimesToAnErrorAreInterpolatedOnly) {
  EXPECT_NEAR(ask({"x_where", "0.01", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}), 8, 1e-9);
  EXPECT_NEAR(ask({"x_where", "0.04", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}), 4, 1e-9);
  EXPECT_TRUE(ask({"x_where", "0.2", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}).is_null());
  EXPECT_TRUE(ask({"x_where", "0.002", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}).is_null());
  EXPECT_TRUE(ask({"x_where", "0.01", "[1, 4]", "[0.1, -0.001]"}).is_null());
}

// Off costs 1.5 times as much in every pair, half of the error is gone.
TEST_F(Unit_BenchmarksRatios, AnAblationsRatiosAreOffOverOn) {
  const std::string on = "[[0.2, 1, 1], [0.1, 2, 2], [0.4, 4, 4]]";
  const std::string off = "[[0.1, 1.5, 3], [0.05, 3, 6], [0.2, 8, 12]]";
  const Json row = ask({"compared", on, off, "false", "1"});
  EXPECT_NEAR(row["cpu"], 1.5, 1e-12);
  EXPECT_NEAR(row["cpu_high"], 2, 1e-12);
  EXPECT_NEAR(row["wall"], 3, 1e-12);
  EXPECT_NEAR(row["relmse"], 0.5, 1e-12);
  EXPECT_NEAR(row["time_to_error"], std::cbrt(0.75 * 0.75 * 1), 1e-12);
  // The mean's logarithm is twice its own error below 0.
  EXPECT_NEAR(std::log(row["high"].get<double>()), (1 - t2 / 2) * std::log(0.75 * 0.75) / 3, 1e-5);
  EXPECT_NEAR(row["cpu_with_making"], 4. / 3, 1e-12);  // a second more: 2.5 / 2, 4 / 3, 9 / 5
  const Json times = ask({"compared", on, off, "true", "1"});
  const double mean = std::cbrt(1.5 * 1.5 * 2);
  EXPECT_EQ(keys_of(times), keys_of(row));
  EXPECT_EQ(times["relmse"], 1);
  EXPECT_NEAR(times["time_to_error"], mean, 1e-12);
  const double factor = std::pow(2 / mean, t2 / 2);  // 2 is twice the error above the mean
  EXPECT_NEAR(times["high"], mean * factor, 1e-4);
  EXPECT_NEAR(times["low"], mean / factor, 1e-4);
  EXPECT_NEAR(ask({"compared", on, off, "false", "2"})["time_to_error"], mean * std::sqrt(0.5),
              1e-12);
  const Json lost =
      ask({"compared", on, "[[-0.1, 1, 1], [-0.1, 1, 1], [0.1, 1, 1]]", "false", "1"});
  EXPECT_TRUE(lost["relmse"].is_null());
  EXPECT_TRUE(lost["time_to_error"].is_null());
  const Json pair = ask({"compared", "[[0.2, 1, 1]]", "[[0.1, 3, 3]]", "false", "1"});
  EXPECT_NEAR(pair["time_to_error"], 1.5, 1e-12);
  EXPECT_TRUE(pair["high"].is_null());
}

// What takes twice as long and has half the error is no better where error falls faster than that.
TEST_F(Unit_BenchmarksRatios, ErrorsFallAsAPowerOfTheTime) {
  EXPECT_NEAR(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.1, 4, 4]]"}), 1.5, 1e-12);
  EXPECT_NEAR(ask({"error_rate", "[[0.6, 1, 1], [1, 1, 1]]", "[[0.4, 2, 4], [0.4, 2, 4]]"}), 1,
              1e-12);
  EXPECT_EQ(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.7, 4, 4]]"}), 1);
  EXPECT_EQ(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.9, 4, 4]]"}), 1);
  EXPECT_TRUE(ask({"error_rate", "[[0.8, 1, 1]]", "[[0, 4, 4]]"}).is_null());
  EXPECT_TRUE(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.4, 1.3, 1.3]]"}).is_null())
      << "most of the time is not that of samples";
}

// Errors of 1 and 1/4 that scatter by a tenth a seed: of 16 seeds' rate, the logarithm of their
// ratio over log 2, the deviation is .1 sqrt(2 / 16) / log 2, and by that log(4) / rate is off by
// .0177. The pairs alone would say that nothing is.
TEST_F(Unit_BenchmarksRatios, WhatATimeMayBeOffByHoldsTheRatesOwnError) {
  const Json found = ask({"noise_of_a_rate", "16", "0.1"});
  EXPECT_NEAR(found[0], t15 * 0.0177, 0.003);
  EXPECT_NEAR(found[1], 2 * 0.0177, 0.005);
}

// Half of the time and twice the error, by a rate of 2: 1 / 2 * sqrt(2); both ways of two pairs.
TEST_F(Unit_BenchmarksRatios, AdaptiveSamplingsGainIsThatOfPairs) {
  const Json row = ask({"adaptive_gain", "[[0.4, 1, 1], [0.4, 1, 1]]", "[[0.2, 2, 2], [0.2, 2, 2]]",
                        "[[0.1, 2, 2], [0.1, 2, 2]]"});
  EXPECT_NEAR(row["error_gain"], 2, 1e-12);
  EXPECT_NEAR(row["time_ratio"], 2, 1e-12);
  EXPECT_NEAR(row["rate"], 2, 1e-12);
  EXPECT_NEAR(row["efficiency"], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(row["high"], std::sqrt(0.5), 1e-12);
}

// What has no walks that choose a roulette is compared with what does not choose one either, and
// the BVH, which has the general kernel alone, with that.
TEST_F(Unit_BenchmarksRatios, AblationsCompareWithTheSameRouletteAndKernel) {
  const Json techniques = ask({"techniques"});
  EXPECT_GT(techniques.size(), 20u);
  for (const Json& technique : techniques) {
    const Json& off = technique["off"];
    const bool is_unlike = off.contains("sampling") || off.contains("heuristic") ||
                           off.contains("splitting") || off.contains("guiding");
    EXPECT_EQ(technique["both"].contains("roulette"), is_unlike) << technique["name"];
    if (off.contains("accel") && off["accel"] == "bvh") {
      EXPECT_EQ(technique["timed_on"], (Json{{"kernel", "general"}}));
    }
  }
}

// Ratio, factor by which it may be off, the reference's word, whether the scene uses it.
TEST_F(Unit_BenchmarksRatios, ATechniquePaysIfItGainsInTheMeanAndLosesNowhereBeyondNoise) {
  const auto pays = [](const std::string& rows) {
    const Json line = ask({"verdicts", rows})[0][0];
    return line["pays"].get<std::string>() + " " + line["where"].get<std::string>() + " " +
           line["loses"].get<std::string>();
  };
  EXPECT_EQ(pays(R"({"a": [1.2, 1.01, "good", null], "b": [0.98, 1.01, null, "yes"]})"), "yes b ");
  EXPECT_EQ(pays(R"({"a": [1.5, 1.01, null, null], "b": [0.95, 1.01, null, null]})"), "no b b");
  EXPECT_EQ(pays(R"({"a": [1.5, 1.01, null, null], "b": [0.95, 1.1, null, null]})"), "yes b ")
      << "a loss within noise";
  EXPECT_EQ(pays(R"({"a": [1.5, 1.01, null, null], "b": [0.95, 1.018, null, null]})"), "yes b ")
      << "a loss that one of two scenes may have by noise";
  EXPECT_EQ(pays(R"({"a": [1.04, 1.001, null, null], "b": [1.05, 1.001, null, null]})"), "no a ");
  EXPECT_EQ(pays(R"({"a": [1.1, 1.3, null, null], "b": [1.1, 1.3, null, null]})"), "no a ")
      << "a gain within noise";
}

// Of two means that may be off by factors f: by exp(sqrt(2) log(f) / 2), of twice the degrees of
// freedom.
TEST_F(Unit_BenchmarksRatios, AVerdictsMeanHasItsRange) {
  const Json line =
      ask({"verdicts", R"({"a": [2, 1.5, null, null], "b": [8, 1.5, null, null]})"})[0][0];
  EXPECT_EQ(line["scenes"], 2);
  EXPECT_NEAR(line["geometric_mean"], 4, 1e-12);
  const double factor = std::pow(1.5, std::sqrt(0.5) * t14 / t7);
  EXPECT_NEAR(line["high"], 4 * factor, 1e-4);
  EXPECT_NEAR(line["low"], 4 / factor, 1e-4);
  const Json single = ask({"verdicts", R"({"a": [2, NaN, null, null]})"})[0][0];
  EXPECT_TRUE(single["pays"].is_null()) << "nothing is known of a pair's noise";
}

TEST_F(Unit_BenchmarksRatios, AVerdictIsOfScenesThatUseItAndOfKnownErrors) {
  const Json told = ask({"verdicts", R"({"a": [2, 1.1, "good", "yes"], "b": [1, 1.1, "good", "no"],
                                         "c": [9, 1.1, "too noisy", null],
                                         "d": [NaN, NaN, "good", null]})"});
  EXPECT_EQ(told[0][0]["scenes"], 1);
  EXPECT_NEAR(told[0][0]["geometric_mean"], 2, 1e-12);
  ASSERT_EQ(told[1].size(), 3u);
  EXPECT_NE(told[1][0].get<std::string>().find("without d: an error"), std::string::npos);
  EXPECT_NE(told[1][1].get<std::string>().find("without c: the reference"), std::string::npos);
  EXPECT_NE(told[1][2].get<std::string>().find("lies above all"), std::string::npos);
}

TEST_F(Unit_BenchmarksRatios, WhetherASceneUsesATechniqueIsTold) {
  const auto used = [](const std::string& name, const std::string& stats, const std::string& info,
                       const std::string& off = "[0.1, 0.2]") {
    return ask({"used", name, stats, info, "[0.1, 0.2]", off});
  };
  EXPECT_EQ(used("lights by place", "{}", R"({"light_cells": 0})"), "no");
  EXPECT_EQ(used("lights by place", "{}", R"({"light_cells": 7})"), "yes");
  EXPECT_EQ(used("background", R"({"skipped": {"samples": 0}})", "{}"), "no");
  EXPECT_EQ(used("no light samples for a constant sky", "{}", "{}"), "no");
  EXPECT_EQ(used("no light samples for a constant sky", "{}", "{}", "[0.1, 0.3]"), "yes");
  EXPECT_TRUE(used("grids of opacity", "{}", "{}").is_null());
}

TEST_F(Unit_BenchmarksRatios, MeansCountOnlyRowsOfGoodReferences) {
  const Json told = ask({"counted", R"([{"scene": "a", "reference": "good", "x": 2},
                                        {"scene": "b", "reference": "too noisy", "x": 2},
                                        {"scene": "c", "reference": "good", "x": null},
                                        {"scene": "d", "reference": null, "x": 1},
                                        {"scene": "e", "spp": 64, "reference": "too noisy", "x": 2}])",
                         "x"});
  EXPECT_EQ(told[0], (Json{"a", "d"}));
  EXPECT_EQ(told[1],
            (Json{"the mean is without c: an error or a time is lost in noise, or most of the "
                  "time is not that of samples",
                  "the mean is without b, e at 64 spp: the reference is too noisy"}));
}

TEST_F(Unit_BenchmarksRatios, WhatAMeanIsWithoutMayLieBesideAllThatItCounts) {
  const auto last = [](const std::string& left) {
    return ask({"counted",
                R"([{"scene": "a", "reference": "good", "x": 2},
                               {"scene": "b", "reference": "good", "x": 1},
                               {"scene": "c", "reference": "too noisy", "x": )" +
                    left + "}]",
                "x"})[1]
        .back()
        .get<std::string>();
  };
  EXPECT_EQ(last("3"), "the mean may be off: what it is without lies above all that it counts");
  EXPECT_EQ(last("0.5"), "the mean may be off: what it is without lies below all that it counts");
  EXPECT_EQ(last("1.5"), "the mean is without c: the reference is too noisy");
}

// What has no walks that choose a roulette and shares no paths stands beside what does neither.
TEST_F(Unit_BenchmarksRatios, CurvesAreComparedWithOnesOfTheSameRoulette) {
  const Json beside = ask({"compared_with"});
  EXPECT_EQ(beside["path, split by four"], "path, roulette from 1/2 on, nothing shared");
  EXPECT_EQ(beside["path, guided"], "path, roulette from 1/2 on, nothing shared");
  EXPECT_EQ(beside["path, roulette from 1/2 on, nothing shared"], "path, nothing shared");
  EXPECT_EQ(beside["path, nothing shared"], "path");
  EXPECT_EQ(beside["path, not robust"], "path");
}

// One pair. candela's first point is below the other's first error; to that of .01 candela's line
// comes after 2 seconds; from its last, .005, on to .0025 it would take twice the time.
TEST_F(Unit_BenchmarksRatios, PeersRatiosAreTheirsOverOurs) {
  const Json rows =
      ask({"ratios_of", "[[[[0.02, 1, 1], [0.005, 4, 4]], [[0.04, 1, 2], [0.0025, 16, 32]]]]",
           "[4, 16]"});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0]["by"], "time to 0.01");
  EXPECT_NEAR(rows[0]["cpu_ratio"], 2, 1e-9);
  EXPECT_NEAR(rows[0]["wall_ratio"], 4, 1e-9);
  EXPECT_EQ(rows[1]["by"], "4 spp");
  EXPECT_NEAR(rows[1]["cpu_ratio"], 1, 1e-12);
  EXPECT_NEAR(rows[1]["wall_ratio"], 2, 1e-12);
  EXPECT_NEAR(rows[2]["cpu_ratio"], 2, 1e-12);
  EXPECT_NEAR(rows[2]["relmse_ratio"], 0.5, 1e-12);
  for (const Json& row : rows) EXPECT_EQ(keys_of(row), keys_of(rows[0]));  // one table's
  const Json between =
      ask({"ratios_of", "[[[[0.02, 1, 1], [0.005, 4, 4]], [[0.04, 1, 2], [0.01, 16, 32]]]]",
           "[4, 16]"});
  EXPECT_NEAR(between[2]["cpu_ratio"], 8, 1e-9);
}

// Two pairs of the same times: in the first candela has Cycles' error of .01 after 2 seconds, in
// the second after 4. An error that is lost in a reference's noise tells nothing.
TEST_F(Unit_BenchmarksRatios, PeersRatiosAreThoseOfPairs) {
  const auto last = [](const std::string& their_error) {
    return ask({"ratios_of",
                "[[[[0.02, 1, 1], [0.005, 4, 4]], [[0.04, 1, 2], [0.01, 16, 32]]],"
                " [[[0.04, 1, 1], [0.01, 4, 4]], [[0.04, 1, 2], [" +
                    their_error + ", 16, 32]]]]",
                "[4, 16]"})
        .back();
  };
  const Json row = last("0.01");
  EXPECT_NEAR(row["cpu_low"], 4, 1e-9);
  EXPECT_NEAR(row["cpu_ratio"], 6, 1e-9);
  EXPECT_NEAR(row["cpu_high"], 8, 1e-9);
  EXPECT_NEAR(row["cpu_mean"], std::sqrt(32), 1e-9);
  EXPECT_NEAR(row["cpu_plus_minus"], t1 * std::log(2) / 2, 1e-4);
  EXPECT_NEAR(row["relmse_ratio"], 1.5, 1e-9);
  EXPECT_NEAR(row["relmse_candela"], 0.0075, 1e-12);
  EXPECT_NEAR(row["relmse_Cycles"], 0.01, 1e-12);
  EXPECT_NEAR(row["relmse_cpu_s_candela"], 0.03, 1e-12);
  EXPECT_NEAR(row["relmse_cpu_s_Cycles"], 0.16, 1e-12);
  EXPECT_TRUE(last("-0.01")["cpu_ratio"].is_null());
}

// Else those pairs would tell the time that happen to have the smaller errors.
TEST_F(Unit_BenchmarksRatios, PeersTimeToAnErrorIsToldWhereAllPairsGetThere) {
  const auto first = [](const std::string& their_error) {
    return ask({"ratios_of",
                "[[[[0.02, 1, 1], [0.005, 4, 4]], [[0.04, 1, 2], [0.005, 16, 32]]],"
                " [[[0.04, 1, 1], [0.005, 4, 4]], [[0.04, 1, 2], [" +
                    their_error + ", 16, 32]]]]",
                "[4, 16]"})[0]["by"];
  };
  EXPECT_EQ(first("0.005"), "time to 0.01");
  EXPECT_EQ(first("0.011"), "4 spp");
}

TEST_F(Unit_BenchmarksRatios, CyclesTimeMayBeLostInWhatAPictureCostsOnce) {
  EXPECT_NEAR(ask({"their_cpu_seconds", "2", "0.5"}), 2, 1e-12);
  EXPECT_TRUE(ask({"their_cpu_seconds", "0.5", "0.5"}).is_null());
}

TEST_F(Unit_BenchmarksRatios, AReferencesNoiseMayBeATwentiethOfTheSmallestError) {
  EXPECT_EQ(ask({"judged", "0.001", "[[0.03], [0.5, 0.021, 0.01]]"}), "good");
  EXPECT_EQ(ask({"judged", "0.001", "[[0.03], [0.5, 0.019, 0.01]]"}), "too noisy");
  EXPECT_EQ(ask({"judged", "0", "[[0], [0]]"}), "good") << "nothing is random";
}

// Against Cycles each renderer has a reference of its own: candela's smaller error asks nothing of
// Cycles'.
TEST_F(Unit_BenchmarksRatios, EachOfTwoReferencesIsHeldAgainstItsOwnRenderersError) {
  EXPECT_EQ(ask({"judged_apart", "0.001", "0.003", "0.021", "0.061"}), "good");
  EXPECT_EQ(ask({"judged_apart", "0.001", "0.003", "0.019", "0.061"}), "too noisy");
  EXPECT_EQ(ask({"judged_apart", "0.001", "0.003", "0.021", "0.059"}), "too noisy");
}

TEST_F(Unit_BenchmarksRatios, EarlierBuildsAreHeldAgainstThisOne) {
  const Json row =
      ask({"before_and_now",
           "[[[0.2, 3, 2], [0.1, 1, 1]], [[0.4, 6, 4], [0.1, 2, 4]], [[0.4, 8, 8], [0.1, 2, 2]]]",
           "[[[0.1, 1, 1], [0.1, 2, 2], [0.1, 2, 2]], [[0.1, 2, 2], [0.1, 4, 8], [0.1, 4, 4]]]"});
  EXPECT_NEAR(row["relmse_ratio"], 4, 1e-12);
  EXPECT_NEAR(row["cpu_low"], 6, 1e-12);
  EXPECT_NEAR(row["cpu_ratio"], 12, 1e-12);
  EXPECT_NEAR(row["cpu_high"], 16, 1e-12);
  EXPECT_NEAR(row["cpu_mean"], std::cbrt(6 * 12 * 16), 1e-9);
  EXPECT_NEAR(row["wall_low"], 4, 1e-12);
}

TEST_F(Unit_BenchmarksRatios, TimesOfEarlierBuildsArePaired) {
  const Json row = ask({"times", "[[2, 1], [4, 4], [8, 6]]"});
  EXPECT_NEAR(row["cpu_ratio"], 0.75, 1e-12);
  EXPECT_NEAR(row["low"], 0.5, 1e-12);
  EXPECT_NEAR(row["high"], 1, 1e-12);
  EXPECT_NEAR(row["seconds"], 4, 1e-12);
}

// candela's error falls as time^-2: to .04 it takes 1 second, to .01 2, to .0025 4. So 8 seconds to
// .01 are 4 times as long and 12 seconds to .0025 only 3 times; 2.5 seconds to .04 are 2.5 times,
// whatever relMSE times seconds says (.1 against .03).
TEST_F(Unit_BenchmarksRatios, CyclesBetterSettingIsTheOneThatIsWorseForCandela) {
  const auto better = [](const std::string& ladders) {
    return ask({"better_settings", R"({"o": [[0.04, 1, 1], [0.0025, 4, 4]]})", ladders})[1];
  };
  EXPECT_EQ(better(R"({"a": [[0.01, 8, 8]], "b": [[0.0025, 12, 12]]})"), "b");
  EXPECT_EQ(better(R"({"a": [[0.04, 2.5, 3]], "b": [[0.0025, 12, 12]]})"), "a");
  EXPECT_EQ(better(R"({"a": [[0.01, 8, 8]], "b": [[-0.01, 99, 99]]})"), "b") << "nothing is told";
}

// "q" takes a third less time to any error than "o".
TEST_F(Unit_BenchmarksRatios, CandelasBetterSettingIsHeldAgainstCyclesBetterOne) {
  const std::string ours =
      R"({"o": [[0.04, 1, 1], [0.0025, 4, 4]], "q": [[0.04, 0.67, 1], [0.0025, 2.7, 4]]})";
  EXPECT_EQ(ask({"better_settings", ours, R"({"a": [[0.01, 8, 8]], "b": [[0.0025, 12, 12]]})"}),
            (Json{"q", "b"}));
}

TEST_F(Unit_BenchmarksRatios, GoalsThatAreMissedEndWithSix) {
  EXPECT_EQ(ask({"exit_status", R"(["yes", "reached", "met", "-", "too small to tell"])"}), 0);
  for (const char* word : {R"(["yes", "no"])", R"(["exceeded", "reached"])", R"(["missed"])", "[]"})
    EXPECT_EQ(ask({"exit_status", word}), 6) << word;
}

// Threads, then for soup and terrain [exponent, its error] of a ray over its bare call, of four
// sizes: two degrees of freedom.
TEST_F(Unit_BenchmarksRatios, ARayMayGrowNoFasterThanItsBareCall) {
  const auto verdicts = [](const std::string& threads, const std::string& exponents) {
    return ask({"scaling_verdicts", threads, exponents});
  };
  EXPECT_EQ(verdicts("[[1, 1], [2, 1.95]]", "[[0.12, 0.03], [0.13, 0.03]]"),
            (Json{"met", "met", "missed"}));
  EXPECT_EQ(verdicts("[[1, 1], [2, 1.94], [4, 4]]", "[[0.1, NaN], [-0.1, 0.01]]"),
            (Json{"missed", "-", "met"}));
}

// relMSE is the picture's own, without the reference's noise. Its standard error over 64 x 64 x 3
// values of variance v: (v + r) sqrt(2 / 12288) / v with r of the reference: 1.6 % here.
TEST_F(Unit_BenchmarksRatios, TheReferencesNoiseIsTakenOff) {
  const Json found = ask({"errors", "[64, 64]", "0.1", "0.2"});
  EXPECT_NEAR(found["relmse"].get<double>() / found["expected"].get<double>(), 1, 0.064);
  EXPECT_NEAR(found["own"], 1, 0.01);
  EXPECT_GT(found["firefly"], 0.15);  // 100^2 / 4.04 / 12288 = .2
  EXPECT_NEAR(found["trimmed"].get<double>() / found["expected"].get<double>(), 1, 0.064);
}

TEST_F(Unit_BenchmarksRatios, APictureOfOnePixelKeepsIt) {
  const Json found = ask({"errors", "[1, 1]", "0.1", "0.2"});
  EXPECT_EQ(found["trimmed"], found["firefly"]);
}

}  // namespace
}  // namespace candela::cli_test
