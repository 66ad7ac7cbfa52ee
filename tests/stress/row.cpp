#include "tests/stress/row.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace candela::test {

void add_row(const std::string& name, const Figures& figures) {
  const char* const path = std::getenv("CANDELA_STRESS_ROWS");
  if (path == nullptr) return;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  nlohmann::ordered_json row = {
      {"suite", test.test_suite_name()}, {"test", test.name()}, {"case", name}};
  for (const auto& [figure, value] : figures) row["figures"][figure] = value;
  std::ofstream(path, std::ios::app) << row.dump() << '\n';
}

bool is_heavy() {
  return std::getenv("CANDELA_HEAVY") != nullptr;
}

}  // namespace candela::test
