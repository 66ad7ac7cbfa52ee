// Gzip'ed bytes for tests.
#pragma once

#include <string>

namespace candela {

[[nodiscard]] std::string gzip(std::string text);

}  // namespace candela
