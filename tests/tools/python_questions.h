// Asks scripts of tests/tools about the Python code of tools.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/tools/run_program.h"

namespace candela::cli_test {

using Json = nlohmann::json;

class PythonQuestions : public testing::Test {
 protected:
  static constexpr const char* python = "/usr/bin/python3";  // Debian's, as in tools/bench

  // `modules`: "numpy, yaml", of Debian's packages python3-numpy and python3-yaml.
  static bool has_modules(const std::string& modules) {
    return std::filesystem::exists(python) &&
           Program({python, "-c", "import " + modules}, ErrorStream::File).finish().exit_code == 0;
  }

  // What tests/tools/`script` prints; null where the question failed, which the test is told.
  static Json answer_of(const std::string& script, const std::vector<std::string>& question) {
    std::vector<std::string> words{python, "-B", CANDELA_SOURCE_DIR "/tests/tools/" + script,
                                   CANDELA_SOURCE_DIR};
    words.insert(words.end(), question.begin(), question.end());
    const ProgramResult result = Program(words, ErrorStream::File).finish();
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return Json::parse(result.exit_code == 0 ? result.output : "null");
  }
};

}  // namespace candela::cli_test
