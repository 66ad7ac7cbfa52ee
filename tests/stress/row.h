// The rows of the table that `tools/bench stress` prints: what a case of tests/stress measured.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace candela::test {

using Figures = std::vector<std::pair<std::string, double>>;

// A row of the running test. `name` tells the case among the test's rows ("2^-40", "bunny, robust
// off"). Written as one line of JSON to the file that the environment's CANDELA_STRESS_ROWS names,
// and nowhere without it: assertions are the test's own business.
void add_row(const std::string& name, const Figures& figures);

// More rays, more samples, more cases: CANDELA_HEAVY, which `tools/bench stress` sets.
[[nodiscard]] bool is_heavy();

}  // namespace candela::test
