// tools/bench: what is measured, with which settings, and what is said of what is not.
#include <gtest/gtest.h>

#include "tests/tools/benchmarks_questions.h"

namespace candela::cli_test {
namespace {

class Unit_BenchmarksInputs : public BenchmarksQuestions {
 protected:
  static Json ask(const std::vector<std::string>& question) {
    return answer_of("benchmarks_inputs.py", question);
  }
};

bool contains(const Json& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// What is wrong with sharing, walks' roulette or a kernel would else be in picture and truth alike.
TEST_F(Unit_BenchmarksInputs, ReferencesAreMadeInThePlainestWay) {
  const Json options = ask({"reference_options"});
  EXPECT_EQ(options["integrator"], "path");
  EXPECT_EQ(options["adaptive"], "off");
  EXPECT_EQ(options["reuse"], "off");
  EXPECT_EQ(options["roulette"], 0.5);
  EXPECT_EQ(options["lamp_rays"], 0);
  EXPECT_EQ(options["kernel"], "general");
}

TEST_F(Unit_BenchmarksInputs, ReferencesAreRemadeByAnotherProgram) {
  EXPECT_EQ(ask({"remade", fresh_folder("another_program"), "candela=another"}), "r||r|");
  EXPECT_EQ(ask({"remade", fresh_folder("other_codecs"), "candela_codecs.so=another"}), "r||r|");
}

TEST_F(Unit_BenchmarksInputs, ReferencesAreRemadeWhereTheyAreDamaged) {
  EXPECT_EQ(ask({"remade", fresh_folder("damaged"), "r.exr=cut", "r.json={"}), "r||r|r|");
}

// One replicate by itself does not adapt, and trials to share paths ask for many samples.
TEST_F(Unit_BenchmarksInputs, NothingElseIsMixedIntoWhatIsCompared) {
  EXPECT_EQ(ask({"replicates_options"})["adaptive"], "off");
  const Json sampler = ask({"sampler_options"});
  EXPECT_EQ(sampler["adaptive"], "off");
  EXPECT_EQ(sampler["reuse"], "off");
  EXPECT_EQ(sampler["roulette"], 0.5);
}

// Adaptive sampling begins at 64 samples: from 32 to 64 error would seem to fall the faster.
TEST_F(Unit_BenchmarksInputs, RatesAreThoseWithoutAdaptiveSampling) {
  for (const char* name : {"adaptive sampling", "no splitting (off: by two)"}) {
    const Json found = ask({"rate_options", name});
    EXPECT_EQ(found[1]["adaptive"], "off") << name;
    EXPECT_EQ(found[1]["spp"], 64) << name;
    for (const auto& [key, value] : found[0].items()) EXPECT_EQ(found[1][key], value) << name;
  }
}

// A scene of one triangle peaks when its picture is written, a large one before there is a picture.
TEST_F(Unit_BenchmarksInputs, PeaksAreThoseOfSmallPictures) {
  EXPECT_EQ(ask({"memory_sizes", fresh_folder("memory")}), (Json{"64x64", "64x64"}));
}

TEST_F(Unit_BenchmarksInputs, ShippedPbrtScenesCanBeNamedAndAreNoDefaults) {
  const Json names = ask({"scene_names"});
  EXPECT_TRUE(contains(names[0], "cutouts"));
  for (const char* name : {"pbrt_lights", "pbrt_media", "sun_lit"}) {
    EXPECT_FALSE(contains(names[0], name)) << name;
    EXPECT_TRUE(contains(names[1], name)) << name;
  }
  EXPECT_EQ(ask({"told_of_absent", R"(["pbrt_lights"])"}), Json::array());
}

TEST_F(Unit_BenchmarksInputs, ScenesThatAreNotThereAreNamed) {
  const char* kept = std::getenv("CANDELA_SCENES");
  const std::string before = kept ? kept : "", folder = fresh_folder("no_scenes");
  setenv("CANDELA_SCENES", folder.c_str(), 1);
  const Json told = ask({"told_of_absent", "[]"});
  kept ? setenv("CANDELA_SCENES", before.c_str(), 1) : unsetenv("CANDELA_SCENES");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(told[0].get<std::string>().starts_with("not in " + folder +
                                                     ", and left out: "
                                                     "lab3/breakfast_room, "))
      << told;
}

TEST_F(Unit_BenchmarksInputs, WhereBlenderFailsTheRestGoesOn) {
  EXPECT_EQ(ask({"ended_by_cycles", fresh_folder("ended_by_cycles")}),
            "<p>box is left out: Blender ended with 11</p>");
}

TEST_F(Unit_BenchmarksInputs, AStressFilterThatMatchesNothingFails) {
  const std::string folder = fresh_folder("stress");
  EXPECT_EQ(ask({"stress_status", folder, R"({"testsuites": []})"}), 6);
  EXPECT_EQ(ask({"stress_status", folder, R"({"testsuites": [{"name": "X", "testsuite": [
                {"name": "A", "status": "RUN", "result": "COMPLETED"}]}]})"}),
            0);
}

// Half of them tell the rate, and one sample's time is taken off.
TEST_F(Unit_BenchmarksInputs, EarlierBuildsAreComparedByFourSamplesAtLeast) {
  EXPECT_TRUE(ask({"before_allows", "3"}).is_null());
  EXPECT_EQ(ask({"before_allows", "4"}), 4);
}

// The trials that choose paths begin at some number of samples, where another estimator begins.
TEST_F(Unit_BenchmarksInputs, RatesAreThoseOfOneEstimator) {
  EXPECT_EQ(ask({"rungs", R"({"32": [], "64": [], "128": ["reuse_samples"]})"}), (Json{32, 64}));
  EXPECT_EQ(ask({"rungs", R"({"32": [], "64": ["reuse_samples"], "128": ["reuse_samples"]})"}),
            (Json{64, 128}));
  const Json told = ask({"rungs", R"({"32": [], "64": ["roulette_samples"],
                                             "128": ["roulette_samples", "reuse_samples"]})"});
  EXPECT_NE(told.get<std::string>().find("expected more --spp"), std::string::npos) << told;
}

TEST_F(Unit_BenchmarksInputs, ReferencesGrowUntilTheyAreGood) {
  EXPECT_EQ(ask({"lengths_made", "1"}), Json{1});
  EXPECT_EQ(ask({"lengths_made", "3"}), (Json{1, 4}));
  EXPECT_EQ(ask({"lengths_made", "99"}), (Json{1, 4, 16}));
}

// What is another picture would count as an error.
TEST_F(Unit_BenchmarksInputs, EarlierBuildsMeansAreOfTheSamePictures) {
  const Json told =
      ask({"means_before_and_now", R"({"a": [2, 1], "b": [9, 0.5], "c": [8, 1.01]})"});
  ASSERT_EQ(told.size(), 2u);
  EXPECT_TRUE(told[0].get<std::string>().starts_with("b: the earlier pictures' mean is 0.500"));
  EXPECT_TRUE(told[1].get<std::string>().starts_with("geometric mean of 2 scenes: 4.00 by CPU"));
}

// Over aligned blocks of samples Cycles spreads them evenly; sample 0 goes through the centre.
TEST_F(Unit_BenchmarksInputs, PeersPicturesFillBlocksOfCyclesSamples) {
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

// At first, again, of other files' content, again; after the kept one was cut short, again.
TEST_F(Unit_BenchmarksInputs, CyclesReferencesAreKeptAsLongAsTheyAreWholeAndOfTheScene) {
  EXPECT_EQ(ask({"cycles_reference_is_made", fresh_folder("cycles_reference")}),
            (Json{true, false, true, false, true, false}));
}

// And nothing of someone else's.
TEST_F(Unit_BenchmarksInputs, WhatAnEarlierRunLeftGoes) {
  const Json left = ask({"left_by_two_runs", fresh_folder("two_runs")});
  EXPECT_EQ(left[0], Json{"own.csv"});
  EXPECT_EQ(left[1], (Json{"index.html", "own.csv", "second.csv"}));
  EXPECT_EQ(left[2], true) << "what is there of a table that was stopped";
}

TEST_F(Unit_BenchmarksInputs, AFolderIsOneRuns) {
  EXPECT_EQ(ask({"locks", fresh_folder("locks")}), (Json{false, true}));
}

TEST_F(Unit_BenchmarksInputs, OptionsMayStandBeforeScenes) {
  EXPECT_EQ(ask({"options_between", R"(["before", "PROGRAM", "--size", "8", "box"])"}),
            Json::parse(R"([["box"], 8])"));
}

// What the lists of packages are, asked together or apart.
TEST(Unit_Setup, ListsThePackagesOfAllSetsThatAreAskedFor) {
  const auto listed = [](std::vector<std::string> words) {
    words.insert(words.begin(), {CANDELA_SOURCE_DIR "/tools/setup", "--list"});
    return Program(words, ErrorStream::File).finish().output;
  };
  for (const auto& words : {std::vector<std::string>{"--figures", "--fuzz"},
                            std::vector<std::string>{"--fuzz", "--figures"}}) {
    const std::string names = listed(words);
    for (const char* name : {"g++\n", "clang\n", "python3-numpy\n"})
      EXPECT_NE(names.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace candela::cli_test
