// Where an output really goes: behind symbolic links, into which folder, and whether it can.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/diagnostic.h"

namespace candela {

struct OutputTarget {
  std::string path;        // links followed
  std::string folder;      // that holds `path`; "." where none is named
  bool is_stream = false;  // a pipe or device, which is written to and not replaced
  // Of ours, where the name leads to one (/dev/stdout, /dev/fd/3): a stream, whatever it is open
  // on.
  std::optional<int> descriptor;
  Diagnostics diagnostics;
};

// Errors: no such folder, a folder of that name, a write-protected file.
[[nodiscard]] OutputTarget find_output_target(const std::string& path);

}  // namespace candela
