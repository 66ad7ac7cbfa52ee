// A validator for the part of JSON Schema (2020-12) that docs/*.schema.json use: type, required,
// properties, additionalProperties (false), items, minItems, maxItems, minimum, enum, pattern.
// Any other keyword that constrains is itself reported, so that no schema promises more than is
// looked at.
#pragma once

#include <string>
#include <vector>

namespace candela::cli_test {

// Both are JSON texts. One line a violation, with the JSON pointer of where it is. Empty: valid.
[[nodiscard]] std::vector<std::string> schema_violations(const std::string& schema,
                                                         const std::string& value);

}  // namespace candela::cli_test
