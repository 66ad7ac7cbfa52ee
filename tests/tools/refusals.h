// Renders that must be refused, and the assets that tests of options use.
#pragma once

#include <gtest/gtest.h>

#include "tests/tools/run_program.h"

namespace candela::cli_test {

inline const std::string assets = std::string(CANDELA_SOURCE_DIR) + "/assets";
inline const std::string cornell_box = assets + "/cornell_box/cornell_box.yaml";

// `candela render` with these words; the folder is the test's own.
inline void expect_refused(std::vector<std::string> words, int exit_code,
                           const std::string& sentence) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string image =
      fresh_folder(std::string(test->test_suite_name()) + test->name()) + "/a.exr";
  words.insert(words.begin(), "render");
  words.insert(words.end(), {"-o", image});
  const ProgramResult result = run_candela(words);
  EXPECT_EQ(result.exit_code, exit_code) << result.error;
  EXPECT_NE(result.error.find(sentence), std::string::npos) << result.error;
}

}  // namespace candela::cli_test
