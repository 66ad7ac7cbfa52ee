// tools/bench: what can be wrong in it without anyone seeing it. Nothing here measures. Ratios:
// benchmarks_ratios_test.cpp.
#include <gtest/gtest.h>

#include "tests/tools/benchmarks_questions.h"

namespace candela::cli_test {
namespace {

class Unit_Benchmarks : public BenchmarksQuestions {};

// A percent sign in a line of help is enough to end in an exception.
TEST_F(Unit_Benchmarks, EveryMeasurementHasItsHelp) {
  const Json helps = ask({"helps"});
  EXPECT_EQ(helps.size(), 17u);
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

// Ratios count from 16 samples on, pixels' intervals from 64 on, closer ones where truth is known.
TEST_F(Unit_Benchmarks, CalibrationTellsWhichGoalsItMisses) {
  const auto misses = [](const std::string& rows, const std::string& stops) {
    return ask({"calibration_misses", rows, stops})[0].size();
  };
  EXPECT_EQ(misses("[[true, 64, 1, 0.95, 0], [false, 64, 1, 0.91, 0], [false, 64, 0.81, null, 0]]",
                   "[[0.95, 1]]"),
            0u);
  EXPECT_EQ(
      misses("[[false, 4, 3, 0.5, 0], [false, 16, 1, 0.5, 0], [false, 64, 1, 0.95, 0]]", "[]"), 0u);
  EXPECT_EQ(
      misses("[[false, 16, 1.26, 0.95, 0], [false, 64, 1, 0.95, 0], [false, 64, 1, 0.9, 0]]", "[]"),
      1u);
  EXPECT_EQ(misses("[[true, 64, 1, 0.92, 0]]", "[]"), 1u);
  EXPECT_EQ(misses("[[false, 64, 1, 0.89, 0]]", "[]"), 1u);
  EXPECT_EQ(misses("[[false, 64, 1.06, 0.95, 0]]", "[]"), 1u) << "the median";
  EXPECT_EQ(misses("[[false, 4, 0.9, 0.95, 0], [false, 4, 1.1, 0.95, 0]]", "[]"), 0u)
      << "of two the mean";
  EXPECT_EQ(misses("[[false, 16, null, 0.95, 0]]", "[]"), 2u) << "the ratio, and the median";
  EXPECT_EQ(misses("[]", "[[0.94, 0.94]]"), 2u);
}

TEST_F(Unit_Benchmarks, CalibrationDoesNotJudgeByAnUnsureReference) {
  const Json told = ask({"calibration_misses", "[[false, 64, 3, 0.1, 0.06]]", "[]"});
  EXPECT_EQ(told[0], Json::array());
  ASSERT_EQ(told[1].size(), 1u);
  EXPECT_NE(told[1][0].get<std::string>().find("s at 64 samples is not judged"), std::string::npos);
}

// Of the ratio of means; where one picture has all of the error nothing is known of its own.
TEST_F(Unit_Benchmarks, CalibrationsRatioMayHaveNoError) {
  EXPECT_EQ(ask({"jackknife", "[[1, 0], [1, 4]]"}), Json::parse("[0.5, null]"));
  EXPECT_NEAR(ask({"jackknife", "[[1, 2], [3, 6]]"})[1], 0, 1e-12);
}

TEST_F(Unit_Benchmarks, DecodingImagesIsNoRendering) {
  EXPECT_NEAR(ask({"rendering_cpu_seconds", R"({"render": 3, "decoding": 1, "load": 9})"}), 2,
              1e-12);
  EXPECT_NEAR(ask({"rendering_cpu_seconds", R"({"render": 3})"}), 3, 1e-12) << "an earlier build";
}

TEST_F(Unit_Benchmarks, GeneratedScenesAreMadeOnce) {
  EXPECT_EQ(ask({"generated_once", fresh_folder("generated")}), (Json{true, false, true, true}));
}

TEST_F(Unit_Benchmarks, AStoppedReferenceIsNotTakenForAnother) {
  EXPECT_EQ(ask({"vouches_after_a_stop", fresh_folder("stopped")}), false);
}

TEST_F(Unit_Benchmarks, WhereAProgramFailsTheRestGoesOn) {
  EXPECT_EQ(ask({"attempted", fresh_folder("attempted")}), "<p>box is left out: out of memory</p>");
}

// Else how they ended is; where they write a log, where that is.
TEST_F(Unit_Benchmarks, ProgramsThatFailAreToldInTheirOwnWords) {
  const std::string folder = fresh_folder("script");
  const auto told = [&](const std::string& script) {
    return ask({"told_of_script", folder, script});
  };
  EXPECT_EQ(told("echo in vain >&2; exit 3"), "in vain");
  EXPECT_EQ(told("exit 3"), "a script ended with 3");
  EXPECT_EQ(told("echo 'a: warning: w' >&2; echo 'a: error: e' >&2; exit 3"), "a: error: e");
  EXPECT_EQ(told("echo 'a: warning: w' >&2; kill -9 $$"), "a script ended with -9\na: warning: w");
  EXPECT_EQ(told("exit 0"), "a script ended with 0") << "without the file that it is to write";
  EXPECT_EQ(ask({"told_of_script", folder, "echo in vain; exit 3", "log"}),
            "a script ended with 3; see " + folder + "/log");
  EXPECT_EQ(file_text(folder + "/log"), "in vain\n");
  EXPECT_EQ(told("touch made; echo done"), "done\n");
}

TEST_F(Unit_Benchmarks, CountsHaveLowerBounds) {
  EXPECT_EQ(ask({"is_allowed", "2", "2"}), 2);
  EXPECT_EQ(ask({"is_allowed", "2", "1"}), "1 is no number of at least 2");
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
