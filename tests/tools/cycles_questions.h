// Asks tests/tools/cycles_comparison.py about tools/benchmarks/blender.
#pragma once

#include "tests/tools/python_questions.h"

namespace candela::cli_test {

class CyclesQuestions : public PythonQuestions {
 protected:
  void SetUp() override {
    if (!has_modules("numpy, yaml"))
      GTEST_SKIP() << "Debian's python3-numpy and python3-yaml are not installed";
  }

  static Json ask(const std::vector<std::string>& question) {
    return answer_of("cycles_comparison.py", question);
  }
};

}  // namespace candela::cli_test
