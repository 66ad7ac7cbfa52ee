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
