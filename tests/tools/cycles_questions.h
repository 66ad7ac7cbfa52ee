// Asks tests/tools/cycles_comparison.py about tools/benchmarks/blender.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/run_program.h"

namespace candela::cli_test {

class CyclesQuestions : public testing::Test {
 protected:
  static constexpr const char* python = "/usr/bin/python3";  // Debian's, as in tools/bench

  void SetUp() override {
    if (!std::filesystem::exists(python) ||
        Program({python, "-c", "import numpy, yaml"}, ErrorStream::File).finish().exit_code != 0)
      GTEST_SKIP() << "Debian's python3-numpy and python3-yaml are not installed";
  }

  static nlohmann::json ask(std::vector<std::string> question) {
    std::vector<std::string> words{
        python, "-B", CANDELA_SOURCE_DIR "/tests/tools/cycles_comparison.py", CANDELA_SOURCE_DIR};
    words.insert(words.end(), question.begin(), question.end());
    const ProgramResult result = Program(words, ErrorStream::File).finish();
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return result.exit_code == 0 ? nlohmann::json::parse(result.output) : nlohmann::json();
  }
};

}  // namespace candela::cli_test
