// What is fixed about the sources, as functions of a file's path and text: which room may
// include which, who alone may include a library, how long a file may be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candela::structure {

struct SourceFile {
  std::string path;  // from the project's root, with '/'
  std::string text;
};

struct Include {
  std::string target;
  int line = 0;
  bool is_quoted = false;  // "..." and not <...>
};

[[nodiscard]] std::vector<Include> includes_of(const SourceFile& file);

// Each returns sentences "path:line: what is wrong", empty where all is well.
[[nodiscard]] std::vector<std::string> upward_includes(const SourceFile& file);
[[nodiscard]] std::vector<std::string> misplaced_libraries(const SourceFile& file);
[[nodiscard]] std::vector<std::string> broken_conventions(const SourceFile& file);

// Every .h and .cpp below the rooms of `root`, sorted by path.
[[nodiscard]] std::vector<SourceFile> read_sources(const std::string& root);

}  // namespace candela::structure
