// Asks tests/tools/benchmarks.py about tools/benchmarks.
#pragma once

#include "tests/tools/python_questions.h"

namespace candela::cli_test {

class BenchmarksQuestions : public PythonQuestions {
 protected:
  void SetUp() override {
    if (!has_modules("numpy, matplotlib"))
      GTEST_SKIP() << "Debian's python3-numpy and python3-matplotlib are not installed";
  }

  // nan is null as well.
  static Json ask(const std::vector<std::string>& question) {
    return answer_of("benchmarks.py", question);
  }
};

}  // namespace candela::cli_test
