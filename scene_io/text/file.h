// Whole files into memory: regular files only, within limits, gzip'ed where the name ends in .gz.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "renderer/base/result.h"

namespace candela::text {

struct FileLimits {
  std::uint64_t bytes = std::uint64_t{8} << 30;           // of the file itself
  std::uint64_t inflated_bytes = std::uint64_t{2} << 30;  // of what a .gz holds
  // What is read of a .gz may be inflated so many times, and to `small_bytes` in any case: scenes
  // come to 15 times, bombs to 1000.
  std::uint64_t inflation = 100;
  std::uint64_t small_bytes = std::uint64_t{1} << 26;
};

// The bytes of `path`. One error where it is missing, unreadable, no regular file (a FIFO or a
// device is never waited for), too large, or a broken gzip file.
[[nodiscard]] Result<std::string> read_file(const std::string& path, const FileLimits& limits = {});

// One error, of a file as a whole.
[[nodiscard]] Diagnostics file_error(const std::string& path, std::string message);

// The bytes that a gzip file in memory holds. A bomb is known by its beginning, however large.
[[nodiscard]] Result<std::string> inflate_gzip(std::string_view bytes, const std::string& name,
                                               const FileLimits& limits);

// `path` ends in .gz, in any letter case.
[[nodiscard]] bool has_gzip_name(std::string_view path);

// `path`, or what stands before its .gz.
[[nodiscard]] std::string_view without_gzip_extension(std::string_view path);

}  // namespace candela::text
