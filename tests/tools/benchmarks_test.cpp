// tools/bench: what can be wrong in it without anyone seeing it. Nothing here measures.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

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

// Costs of calls stand in the file twice: with the callee and, as a sum, after `calls=`.
TEST_F(Unit_Benchmarks, CallgrindsInstructionsAreCountedOnce) {
  const std::string file = fresh_folder("callgrind") + "/profile";
  write_text(file,
             "# callgrind format\nversion: 1\npositions: line\nevents: Ir\nsummary: 1150\n\n"
             "ob=(1) /build/candela\nfl=(1) /source/tile.h\nfn=(1) render_tile\n10 100\n+2 7\n"
             "fi=(2) /source/vec.h\n5 40\n* 3\nfe=(1)\n"
             "cob=(2) /usr/lib/libembree3.so.3.13.5\ncfi=(3) ???\ncfn=(2) 0x0001\ncalls=4 0\n"
             "-1 900\n"
             "cfn=(3) points [clone .arch_x86_64_v3]\ncalls=1 20\n12 100\n\n"
             "ob=(2)\nfl=(3)\nfn=(2)\n0 900\n\n"
             "ob=(1)\nfl=(1)\nfn=(3)\n20 100\n\ntotals: 1150\n");
  const Json read = ask({"profile", file});
  EXPECT_EQ(read["total"], 1150);
  EXPECT_EQ(read["by_object"],
            (Json{{"/build/candela", 250}, {"/usr/lib/libembree3.so.3.13.5", 900}}));
  EXPECT_EQ(read["by_file"], (Json{{"/source/tile.h", 207}, {"/source/vec.h", 43}, {"???", 900}}));
  EXPECT_EQ(read["by_function"]["render_tile"], 150);
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

}  // namespace
}  // namespace candela::cli_test
