// Asks tests/tools/benchmarks.py about tools/benchmarks.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/run_program.h"

namespace candela::cli_test {

class BenchmarksQuestions : public testing::Test {
 protected:
  static constexpr const char* python = "/usr/bin/python3";  // Debian's, as in tools/bench

  void SetUp() override {
    if (!std::filesystem::exists(python) ||
        Program({python, "-c", "import numpy, matplotlib"}, ErrorStream::File).finish().exit_code !=
            0)
      GTEST_SKIP() << "Debian's python3-numpy and python3-matplotlib are not installed";
  }

  // JSON; null where the question failed, which the test is told. nan is null as well.
  static std::string answer(const std::vector<std::string>& question) {
    std::vector<std::string> words{python, "-B", CANDELA_SOURCE_DIR "/tests/tools/benchmarks.py",
                                   CANDELA_SOURCE_DIR};
    words.insert(words.end(), question.begin(), question.end());
    const ProgramResult result = Program(words, ErrorStream::File).finish();
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return result.exit_code == 0 ? result.output : "null";
  }
};

}  // namespace candela::cli_test
