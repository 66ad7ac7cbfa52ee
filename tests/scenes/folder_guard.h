// A folder that goes when the program ends.
#pragma once

#include <filesystem>
#include <string>

namespace candela::test {

struct FolderGuard {
  std::string path;
  ~FolderGuard() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace candela::test
