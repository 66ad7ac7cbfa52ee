#include "renderer/image/file_input.h"

#include <cerrno>

#include <fmt/format.h>

#include "renderer/base/regular_file.h"

namespace candela {
namespace {

Diagnostics cannot_read(const std::string& path, int error) {
  if (error == ENOENT || error == ENOTDIR) return failure(fmt::format("'{}' does not exist", path));
  return failure(fmt::format("'{}' cannot be read: {}", path, system_message(error)));
}

// As many bytes as the file system claims, or what is left of them.
Result<Bytes> read_all(const std::string& path, const FileDescriptor& file, std::size_t size) {
  Bytes bytes(size);
  std::size_t count = 0;
  while (count < size) {
    const ssize_t got = read_some(file, bytes.data() + count, size - count);
    if (got < 0) return cannot_read(path, errno);
    if (got == 0) break;
    count += static_cast<std::size_t>(got);
  }
  bytes.resize(count);
  return bytes;
}

}  // namespace

Result<Bytes> read_regular_file(const std::string& path, std::size_t max_bytes) {
  const RegularFile file = open_regular_file(path);
  if (!file.kind.empty())
    return failure(fmt::format("'{}' is {}, not a regular file", path, file.kind));
  if (file.error != 0) return cannot_read(path, file.error);
  if (file.size > max_bytes)
    return failure(
        fmt::format("'{}' has {} bytes; at most {} are read", path, file.size, max_bytes));
  return read_all(path, file.descriptor, static_cast<std::size_t>(file.size));
}

}  // namespace candela
