// What is said of files whose decoder complains: sentences without the file's name.
#pragma once

#include <string_view>

#include <fmt/format.h>

#include "renderer/base/result.h"

namespace candela {

[[nodiscard]] inline Diagnostics is_damaged(std::string_view complaint) {
  return failure(fmt::format("is damaged: {}", complaint));
}

// Nothing where there is no complaint.
[[nodiscard]] inline Diagnostics is_damaged_but_readable(std::string_view complaint) {
  Diagnostics found;
  if (!complaint.empty()) found.warning({}, fmt::format("is damaged but readable: {}", complaint));
  return found;
}

}  // namespace candela
