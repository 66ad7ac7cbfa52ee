#include "renderer/image/file_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include <fmt/format.h>

#include "renderer/image/file_descriptor.h"

namespace candela {
namespace {

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

Diagnostics cannot_read(const std::string& path, int error) {
  if (error == ENOENT || error == ENOTDIR) return failure(fmt::format("'{}' does not exist", path));
  return failure(fmt::format("'{}' cannot be read: {}", path, system_message(error)));
}

// Looks before opening, since opening alone can act on a device.
Diagnostics check_is_regular(const std::string& path, const struct stat& status) {
  if (S_ISREG(status.st_mode)) return {};
  return failure(fmt::format("'{}' is {}, not a regular file", path, kind_of(status.st_mode)));
}

// As many bytes as the file system claims, or what is left of them.
Result<Bytes> read_all(const std::string& path, int descriptor, std::size_t size) {
  Bytes bytes(size);
  std::size_t count = 0;
  while (count < size) {
    const ssize_t got = ::read(descriptor, bytes.data() + count, size - count);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannot_read(path, errno);
    if (got == 0) break;
    count += static_cast<std::size_t>(got);
  }
  bytes.resize(count);
  return bytes;
}

}  // namespace

Result<Bytes> read_regular_file(const std::string& path, std::size_t max_bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return cannot_read(path, errno);
  if (Diagnostics found = check_is_regular(path, status); found.has_errors()) return found;
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file.is_open()) return cannot_read(path, errno);
  if (::fstat(file.get(), &status) != 0) return cannot_read(path, errno);
  if (Diagnostics found = check_is_regular(path, status); found.has_errors()) return found;
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > max_bytes)
    return failure(fmt::format("'{}' has {} bytes; at most {} are read", path, size, max_bytes));
  return read_all(path, file.get(), size);
}

}  // namespace candela
