#include "scene_io/text/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/text/source.h"

namespace candela::text {
namespace {

class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

std::string system_message() {
  return std::generic_category().message(errno);
}

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISSOCK(mode)) return "a socket";
  return "something else";
}

Diagnostics not_regular(const std::string& path, mode_t mode) {
  return file_error(path, fmt::format("is {}; expected a regular file", kind_of(mode)));
}

// Reads to the end, which may have moved since the size was asked for, but never past `max_bytes`.
Result<std::string> read_descriptor(int descriptor, const std::string& path, std::size_t size,
                                    std::uint64_t max_bytes) {
  // One byte more, so that the end is met without growing.
  std::string bytes(std::min<std::uint64_t>(size + 1, max_bytes), '\0');
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size()) {
      if (filled >= max_bytes) break;
      bytes.resize(filled + std::min<std::uint64_t>(max_bytes - filled, 4096));
    }
    const ssize_t count = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return file_error(path, fmt::format("cannot be read: {}", system_message()));
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

Result<std::string> read_plain(const std::string& path, std::uint64_t max_bytes) {
  if (path.find('\0') != std::string::npos) return file_error(path, "is not the name of a file");
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return file_error(path, fmt::format("cannot be opened: {}", system_message()));
  }
  if (!S_ISREG(status.st_mode)) return not_regular(path, status.st_mode);
  // The file may have been exchanged since: opened without waiting, and looked at again.
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) {
    return file_error(path, fmt::format("cannot be opened: {}", system_message()));
  }
  if (!S_ISREG(status.st_mode)) return not_regular(path, status.st_mode);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes) {
    return file_error(path, fmt::format("holds {} bytes; at most {} are read", size, max_bytes));
  }
  return read_descriptor(file.number(), path, static_cast<std::size_t>(size), max_bytes);
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
