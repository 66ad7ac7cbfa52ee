#include "scene_io/text/file.h"

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "renderer/base/regular_file.h"
#include "scene_io/text/source.h"

namespace candela::text {
namespace {

// Reads to the end, which may have moved since the size was asked for, but never past `max_bytes`.
Result<std::string> read_to_end(const FileDescriptor& file, const std::string& path,
                                std::size_t size, std::uint64_t max_bytes) {
  // One byte more, so that the end is met without growing.
  std::string bytes(std::min<std::uint64_t>(size + 1, max_bytes), '\0');
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size()) {
      if (filled >= max_bytes) break;
      bytes.resize(filled + std::min<std::uint64_t>(max_bytes - filled, 4096));
    }
    const ssize_t count = read_some(file, bytes.data() + filled, bytes.size() - filled);
    if (count < 0) return file_error(path, "cannot be read: " + system_message(errno));
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

Result<std::string> read_plain(const std::string& path, std::uint64_t max_bytes) {
  if (path.find('\0') != std::string::npos) return file_error(path, "is not the name of a file");
  const RegularFile file = open_regular_file(path);
  if (!file.kind.empty())
    return file_error(path, fmt::format("is {}; expected a regular file", file.kind));
  if (file.error != 0) return file_error(path, "cannot be opened: " + system_message(file.error));
  if (file.size > max_bytes)
    return file_error(path,
                      fmt::format("holds {} bytes; at most {} are read", file.size, max_bytes));
  return read_to_end(file.descriptor, path, static_cast<std::size_t>(file.size), max_bytes);
}

}  // namespace

Diagnostics file_error(const std::string& path, std::string message) {
  Diagnostics diagnostics;
  diagnostics.error({std::make_shared<const std::string>(path), 0, 0}, std::move(message));
  return diagnostics;
}

bool has_gzip_name(std::string_view path) {
  return path.size() > 3 && ends_ignoring_case(path, ".gz");
}

std::string_view without_gzip_extension(std::string_view path) {
  return has_gzip_name(path) ? path.substr(0, path.size() - 3) : path;
}

Result<std::string> read_file(const std::string& path, const FileLimits& limits) {
  Result<std::string> bytes = read_plain(path, limits.bytes);
  if (!bytes || !has_gzip_name(path)) return bytes;
  return inflate_gzip(*bytes, path, limits);
}

}  // namespace candela::text
