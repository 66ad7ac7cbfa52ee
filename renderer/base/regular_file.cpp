#include "renderer/base/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace candela {
namespace {

std::string_view kind_of(mode_t mode) {
  if (S_ISREG(mode)) return "";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISSOCK(mode)) return "a socket";
  return "something else";
}

}  // namespace

RegularFile open_regular_file(const std::string& path) {
  RegularFile file;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {.error = errno};
  if (!kind_of(status.st_mode).empty()) return {.kind = kind_of(status.st_mode)};
  // The file may have been exchanged since: opened without waiting, and looked at again.
  file.descriptor =
      FileDescriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file.descriptor.is_open() || ::fstat(file.descriptor.get(), &status) != 0)
    return {.error = errno};
  if (!kind_of(status.st_mode).empty()) return {.kind = kind_of(status.st_mode)};
  file.size = static_cast<std::uint64_t>(status.st_size);
  return file;
}

ssize_t read_some(const FileDescriptor& file, void* to, std::size_t count) {
  while (true) {
    const ssize_t got = ::read(file.get(), to, count);
    if (got >= 0 || errno != EINTR) return got;
  }
}

}  // namespace candela
