// tools/bench: what can be wrong in it without anyone seeing it. Nothing here measures.
#include <gtest/gtest.h>

#include <cmath>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

constexpr const char* python = "/usr/bin/python3";  // Debian's, as in tools/bench

class Unit_Benchmarks : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(python) ||
        Program({python, "-c", "import numpy, matplotlib"}, ErrorStream::File).finish().exit_code !=
            0)
      GTEST_SKIP() << "Debian's python3-numpy and python3-matplotlib are not installed";
  }

  static Json ask(std::vector<std::string> question) {
    std::vector<std::string> words{python, "-B", CANDELA_SOURCE_DIR "/tests/tools/benchmarks.py",
                                   CANDELA_SOURCE_DIR};
    words.insert(words.end(), question.begin(), question.end());
    const ProgramResult result = Program(words, ErrorStream::File).finish();
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return result.exit_code == 0 ? Json::parse(result.output) : Json();
  }
};

// A percent sign in a line of help is enough to end in an exception.
TEST_F(Unit_Benchmarks, EveryMeasurementHasItsHelp) {
  const Json helps = ask({"helps"});
  EXPECT_EQ(helps.size(), 18u);
  const std::string command = file_text(CANDELA_SOURCE_DIR "/tools/bench");
  const std::string page = file_text(CANDELA_SOURCE_DIR "/docs/benchmarks.md");
  for (const auto& [name, text] : helps.items()) {
    EXPECT_NE(text.get<std::string>().find("--help"), std::string::npos) << name;
    if (name == "all") continue;
    EXPECT_NE(helps["all"].get<std::string>().find("\n    " + name), std::string::npos) << name;
    EXPECT_NE(command.find("tools/bench " + name + " "), std::string::npos) << name;
    EXPECT_NE(page.find("`" + name), std::string::npos) << name;
  }
}

// Costs of calls stand in the file twice: with the callee and, as a sum, after `calls=`.
TEST_F(Unit_Benchmarks, CallgrindsInstructionsAreCountedOnce) {
  const std::string file = fresh_folder("callgrind") + "/profile";
  write_text(file,
             "# callgrind format\nversion: 1\npositions: line\nevents: Ir\nsummary: 1150\n\n"
             "ob=(1) /build/candela\nfl=(1) /source/tile.h\nfn=(1) render_tile\n10 100\n+2 7\n"
             "fi=(2) /source/vec.h\n5 40\n* 3\nfe=(1)\n"
             "cob=(2) /usr/lib/libembree3.so.3.13.5\ncfi=(3) ???\ncfn=(2) 0x0001\ncalls=4 0\n"
             "-1 900\n"
             "cfn=(3) points [clone .arch_x86_64_v3]\ncalls=1 20\n12 100\n13 11\n\n"
             "ob=(2)\nfl=(3)\nfn=(2)\n0 900\n\n"
             "ob=(1)\nfl=(1)\nfn=(3)\n20 100\n\ntotals: 1150\n");
  const Json read = ask({"profile", file});
  EXPECT_EQ(read["total"], 1161);
  EXPECT_EQ(read["by_object"],
            (Json{{"/build/candela", 261}, {"/usr/lib/libembree3.so.3.13.5", 900}}));
  EXPECT_EQ(read["by_file"], (Json{{"/source/tile.h", 218}, {"/source/vec.h", 43}, {"???", 900}}));
  EXPECT_EQ(read["by_function"]["render_tile"], 161);
  EXPECT_EQ(read["embree"], 900);
  EXPECT_EQ(read["library"], "libembree3.so.3.13.5");
  EXPECT_EQ(read["vectors"], "x86-64-v3");
}

TEST_F(Unit_Benchmarks, ABudgetIsExceededAboveThreePercent) {
  EXPECT_EQ(ask({"grown", "1000", "1029.9"}), Json::array());
  EXPECT_EQ(ask({"grown", "1000", "500"}), Json::array());
  EXPECT_EQ(ask({"grown", "1000", "1031"}),
            Json{"scene: 1031.0 instructions a sample, +3.1% of the 1000.0 on record; expected at "
                 "most +3%"});
  EXPECT_EQ(ask({"grown", "0", "1"}),
            Json{"scene: no figure on record; `tools/bench budget --record` makes one"});
  EXPECT_EQ(ask({"budget_scenes"}).size(), 5u);
}

// y = 3 x^.5 exactly; and the textbook's standard error of a slope, here of (0, 0), (1, 2), (2, 2),
// (3, 4) in logarithms: slope 1.2, residuals' squares .8.
TEST_F(Unit_Benchmarks, ExponentsAreThoseOfTheData) {
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

TEST_F(Unit_Benchmarks, SpreadsAreMedianAndRange) {
  EXPECT_EQ(ask({"spread", "[5, 1, 2]"}), (Json{{"median", 2}, {"low", 1}, {"high", 5}}));
  EXPECT_NEAR(ask({"geometric_mean", "[2, 8]"}), 4, 1e-12);
}

// Ratios count from 16 samples on, pixels' intervals from 64 on, closer ones where truth is known.
TEST_F(Unit_Benchmarks, CalibrationTellsWhichGoalsItMisses) {
  const auto misses = [](const std::string& rows, const std::string& stops) {
    return ask({"calibration_misses", rows, stops}).size();
  };
  EXPECT_EQ(
      misses("[[true, 64, 1, 0.95], [false, 64, 1, 0.91], [false, 64, 0.81, null]]", "[[0.95, 1]]"),
      0u);
  EXPECT_EQ(misses("[[false, 4, 3, 0.5], [false, 16, 1, 0.5], [false, 64, 1, 0.95]]", "[]"), 0u);
  EXPECT_EQ(misses("[[false, 16, 1.26, 0.95], [false, 64, 1, 0.95], [false, 64, 1, 0.9]]", "[]"),
            1u);
  EXPECT_EQ(misses("[[true, 64, 1, 0.92]]", "[]"), 1u);
  EXPECT_EQ(misses("[[false, 64, 1, 0.89]]", "[]"), 1u);
  EXPECT_EQ(misses("[[false, 64, 1.06, 0.95]]", "[]"), 1u) << "the median";
  EXPECT_EQ(misses("[]", "[[0.94, 0.94]]"), 2u);
}

// Straight in logarithms between points; nothing beyond them.
TEST_F(Unit_Benchmarks, TimesToAnErrorAreInterpolatedOnly) {
  EXPECT_NEAR(ask({"x_where", "0.01", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}), 8, 1e-9);
  EXPECT_NEAR(ask({"x_where", "0.04", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}), 4, 1e-9);
  EXPECT_TRUE(ask({"x_where", "0.2", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}).is_null());
  EXPECT_TRUE(ask({"x_where", "0.002", "[1, 4, 16]", "[0.1, 0.04, 0.0025]"}).is_null());
  EXPECT_TRUE(ask({"x_where", "0.01", "[1, 4]", "[0.1, -0.001]"}).is_null());
}

// Off costs 1.5 times as much in every pair, half of the error is gone.
TEST_F(Unit_Benchmarks, AnAblationsRatiosAreOffOverOn) {
  const std::string on = "[[0.2, 1, 1], [0.1, 2, 2], [0.4, 4, 4]]";
  const std::string off = "[[0.1, 1.5, 3], [0.05, 3, 6], [0.2, 8, 12]]";
  const Json row = ask({"compared", on, off, "false", "1"});
  EXPECT_NEAR(row["cpu"], 1.5, 1e-12);
  EXPECT_NEAR(row["cpu_high"], 2, 1e-12);
  EXPECT_NEAR(row["wall"], 3, 1e-12);
  EXPECT_NEAR(row["relmse"], 0.5, 1e-12);
  EXPECT_NEAR(row["time_to_error"], std::cbrt(0.75 * 0.75 * 1), 1e-12);
  EXPECT_NEAR(row["high"], 1, 1e-12);  // the mean's logarithm is twice its own error below 0
  EXPECT_NEAR(ask({"compared", on, off, "true", "1"})["time_to_error"], 1.5, 1e-12);
  EXPECT_NEAR(ask({"compared", on, off, "false", "2"})["time_to_error"],
              std::cbrt(1.5 * 1.5 * 2) * std::sqrt(0.5), 1e-12);
}

// What takes twice as long and has half the error is no better where error falls faster than that.
TEST_F(Unit_Benchmarks, ErrorsFallAsAPowerOfTheTime) {
  EXPECT_NEAR(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.1, 4, 4]]"}), 1.5, 1e-12);
  EXPECT_NEAR(ask({"error_rate", "[[0.6, 1, 1], [1, 1, 1]]", "[[0.4, 2, 4], [0.4, 2, 4]]"}), 1,
              1e-12);
  EXPECT_EQ(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.7, 4, 4]]"}), 1);
  EXPECT_EQ(ask({"error_rate", "[[0.8, 1, 1]]", "[[0.9, 4, 4]]"}), 1);
}

// What has no walks that choose a roulette is compared with what does not choose one either, and
// the BVH, which has the general kernel alone, with that.
TEST_F(Unit_Benchmarks, AblationsCompareWithTheSameRouletteAndKernel) {
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

TEST_F(Unit_Benchmarks, ATechniquePaysIfItGainsInTheMeanAndLosesNowhere) {
  const auto pays = [](const std::string& ratios) {
    const Json line = ask({"verdicts", ratios})[0];
    return line["pays"].get<std::string>() + " " + line["where"].get<std::string>();
  };
  EXPECT_EQ(pays(R"({"a": 1.2, "b": 0.98})"), "yes b");
  EXPECT_EQ(pays(R"({"a": 1.5, "b": 0.96})"), "no b");
  EXPECT_EQ(pays(R"({"a": 1.04, "b": 1.05})"), "no a");
}

// One pair. candela's first point is below the other's first error; to that of .01 candela's line
// comes after 2 seconds; from its last, .005, on to .0025 it would take twice the time.
TEST_F(Unit_Benchmarks, PeersRatiosAreTheirsOverOurs) {
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
TEST_F(Unit_Benchmarks, PeersRatiosAreThoseOfPairs) {
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
  EXPECT_NEAR(row["cpu_plus_minus"], std::log(2), 1e-9);
  EXPECT_NEAR(row["relmse_ratio"], 1.5, 1e-9);
  EXPECT_NEAR(row["relmse"], 0.0075, 1e-12);
  EXPECT_NEAR(row["relmse_cpu_s_candela"], 0.03, 1e-12);
  EXPECT_NEAR(row["relmse_cpu_s_Cycles"], 0.16, 1e-12);
  EXPECT_TRUE(last("-0.01")["cpu_ratio"].is_null());
}

// Over aligned blocks of samples Cycles spreads them evenly; sample 0 goes through the centre.
TEST_F(Unit_Benchmarks, PeersPicturesFillBlocksOfCyclesSamples) {
  for (const char* counts : {"[4, 16]", "[4, 16, 64]", "[4, 16, 64, 256]"}) {
    const Json asked = ask({"asked_of_cycles", fresh_folder("asked_of_cycles"), counts});
    for (const Json& jobs : asked) {
      EXPECT_GE(jobs.size(), 6u);
      for (const Json& job : jobs)
        EXPECT_EQ(job[1].get<int>() % job[0].get<int>(), 0) << counts << ": " << job;
    }
    for (const Json& job : asked[1]) EXPECT_GT(job[1], 0);
  }
}

TEST_F(Unit_Benchmarks, AReferencesNoiseMayBeATwentiethOfTheSmallestError) {
  EXPECT_EQ(ask({"judged", "0.001", "[[0.03], [0.5, 0.021, 0.01]]"}), "good");
  EXPECT_EQ(ask({"judged", "0.001", "[[0.03], [0.5, 0.019, 0.01]]"}), "too noisy");
}

TEST_F(Unit_Benchmarks, EarlierBuildsAreHeldAgainstThisOne) {
  const Json row =
      ask({"before_and_now",
           "[[[0.2, 3, 2], [0.1, 1, 1]], [[0.4, 6, 4], [0.1, 2, 4]], [[0.4, 8, 8], [0.1, 2, 2]]]",
           "1"});
  EXPECT_NEAR(row["relmse_ratio"], 4, 1e-12);
  EXPECT_NEAR(row["cpu_low"], 6, 1e-12);
  EXPECT_NEAR(row["cpu_ratio"], 12, 1e-12);
  EXPECT_NEAR(row["cpu_high"], 16, 1e-12);
  EXPECT_NEAR(row["cpu_mean"], std::cbrt(6 * 12 * 16), 1e-9);
  EXPECT_NEAR(row["wall_low"], 4, 1e-12);
}

TEST_F(Unit_Benchmarks, TimesOfEarlierBuildsArePaired) {
  const Json row = ask({"times", "[[2, 1], [4, 4], [8, 6]]"});
  EXPECT_NEAR(row["cpu_ratio"], 0.75, 1e-12);
  EXPECT_NEAR(row["low"], 0.5, 1e-12);
  EXPECT_NEAR(row["high"], 1, 1e-12);
  EXPECT_NEAR(row["seconds"], 4, 1e-12);
}

TEST_F(Unit_Benchmarks, TheBetterSettingIsThatOfTheLeastMedian) {
  EXPECT_EQ(ask({"better_setting", R"({"a": [1, 5, 9], "b": [4, 4, 90]})"}), "b");
  EXPECT_EQ(ask({"better_setting", R"({"a": [1, 3, 9], "b": [4, 4, 90]})"}), "a");
}

// A scene that cannot be compared is left out; the others go on.
TEST_F(Unit_Benchmarks, ScenesThatCyclesCannotHaveAreLeftOut) {
  if (Program({python, "-c", "import yaml"}, ErrorStream::File).finish().exit_code != 0)
    GTEST_SKIP() << "Debian's python3-yaml is not installed";
  const Json files{
      {"metal", CANDELA_SOURCE_DIR "/assets/cornell_box/cornell_box.yaml"},
      {"sun", CANDELA_SOURCE_DIR "/tools/benchmarks/blender/scenes/sun_lit.yaml"},
  };
  EXPECT_EQ(ask({"compared_with_cycles", files.dump()}), Json{"sun"});
}

// Scene by scene; none is told where all is exact.
TEST_F(Unit_Benchmarks, WhatIsOnlyNearInCyclesIsTold) {
  const std::string folder = fresh_folder("approximated");
  const std::string exact = R"("box": {"approximated": []})";
  EXPECT_EQ(ask({"approximated", folder, "{" + exact + "}"}), Json::array());
  EXPECT_EQ(ask({"approximated", folder, "{" + exact + R"(, "room": {"approximated": [
      {"what": "metal", "in_Cycles": "Schlick's", "names": ["gold", "tin"]}]}})"}),
            Json{"approximated.csv"});
  EXPECT_EQ(file_text(folder + "/approximated.csv"),
            "scene,what,names,in_Cycles\r\nroom,metal,\"gold, tin\",Schlick's\r\n");
}

// relMSE is the picture's own, without the reference's noise. Its standard error over 64 x 64 x 3
// values of variance v: (v + r) sqrt(2 / 12288) / v with r of the reference: 1.6 % here.
TEST_F(Unit_Benchmarks, TheReferencesNoiseIsTakenOff) {
  const Json found = ask({"errors", "[64, 64]", "0.1", "0.2"});
  EXPECT_NEAR(found["relmse"].get<double>() / found["expected"].get<double>(), 1, 0.064);
  EXPECT_NEAR(found["own"], 1, 0.01);
  EXPECT_GT(found["firefly"], 0.15);  // 100^2 / 4.04 / 12288 = .2
  EXPECT_LT(found["trimmed"], 0.016);
}

TEST_F(Unit_Benchmarks, PerfsLinesAreRead) {
  EXPECT_EQ(ask({"perf",
                 "# Overhead;Shared Object;Symbol\n"
                 "    37.68%;libembree3.so.3.13.5          ;[.] 0x0000000001bd0640  ;-      -\n"
                 "    20.00%;candela   ;[.] candela::(anonymous namespace)::f<int, A<1> >(int)   \n"
                 "     1.25%;[kernel.kallsyms]  ;[k] clear_page_erms\n"
                 "     1.00%;libc.so.6;[.] _int_malloc\n"}),
            Json::parse(R"([[37.68, "Embree", "0x0000000001bd0640"],
                            [20.0, "candela", "candela::f<...>"],
                            [1.25, "kernel", "clear_page_erms"],
                            [1.0, "other libraries", "_int_malloc"]])"));
}

TEST_F(Unit_Benchmarks, NumbersStandInTheCsvAndOnThePage) {
  const std::string folder = fresh_folder("page");
  EXPECT_EQ(ask({"page", folder, R"([{"scene": "a, b", "seconds": 0.123456789, "runs": 3},
                                     {"scene": "<c>", "seconds": NaN, "runs": null}])"}),
            (Json{"index.html", "rows.csv"}));
  EXPECT_EQ(file_text(folder + "/rows.csv"),
            "scene,seconds,runs\r\n\"a, b\",0.123457,3\r\n<c>,,\r\n");
  const std::string page = file_text(folder + "/index.html");
  for (const char* part : {"<td>a, b</td><td>0.1235</td><td>3</td>", "<td>&lt;c&gt;</td>",
                           "Rows &amp; more", "A note.", "1.2.3", "A &lt;title&gt;"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace candela::cli_test
