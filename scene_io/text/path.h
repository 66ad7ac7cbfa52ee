// Names of files inside files: relative to the folder of the file that names them, written on
// another system.
#pragma once

#include <string>
#include <string_view>

namespace candela::text {

struct ResolvedPath {
  std::string path;             // '/' between parts; where nothing was found, where it was expected
  bool is_found = false;        // something exists there
  bool has_other_case = false;  // found only with letter case ignored
  bool is_elsewhere = false;    // found by the last part of an absolute name that does not exist

  [[nodiscard]] bool is_substitute() const { return has_other_case || is_elsewhere; }
};

// The file that `name`, written in the file `referrer`, means: back-slashes separate folders, an
// absolute name that does not exist here is looked for by its last part beside `referrer`, and
// where letter case alone keeps a part from being found the first such entry (by name) is taken.
[[nodiscard]] ResolvedPath resolve_path(const std::string& referrer, std::string_view name);

// "file 'Brick.png' is taken for 'brick.png': letter case differs", and its like.
[[nodiscard]] std::string describe_substitute(const ResolvedPath& found, std::string_view name);

// The folder of a file with its last '/', or "".
[[nodiscard]] std::string folder_of(std::string_view path);

}  // namespace candela::text
