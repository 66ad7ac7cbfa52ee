// Files opened for reading: regular ones alone. Opening a device can act on it, and a FIFO waits
// for whoever writes into it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "renderer/base/file_descriptor.h"

namespace candela {

// Open, or with one of `error` and `kind`.
struct RegularFile {
  FileDescriptor descriptor{-1};
  std::uint64_t size = 0;      // bytes, as the file system claims
  int error = 0;               // the errno of what failed
  std::string_view kind = {};  // of what is no regular file: "a folder", "a FIFO", "a device", ...
};

// Links are followed.
[[nodiscard]] RegularFile open_regular_file(const std::string& path);

// Bytes read: at most `count`, 0 at the end, -1 (and errno) where reading fails.
[[nodiscard]] ssize_t read_some(const FileDescriptor& file, void* to, std::size_t count);

}  // namespace candela
