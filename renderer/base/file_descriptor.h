// An open file of the system that closes itself, and the system's words for its errors.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace candela {

class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor(FileDescriptor&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FileDescriptor() { close(); }

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int get() const { return descriptor_; }
  // Whether closing succeeded: network file systems tell of a full disk only here.
  bool close() {
    const int closing = descriptor_;
    descriptor_ = -1;
    return closing < 0 || ::close(closing) == 0;
  }

 private:
  int descriptor_;
};

// 0 or the errno of the first write that failed. A short write is tried again: the next call tells
// why.
[[nodiscard]] inline int write_all(int descriptor, std::string_view bytes) {
  std::size_t count = 0;
  while (count < bytes.size()) {
    const ssize_t put = ::write(descriptor, bytes.data() + count, bytes.size() - count);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0 && errno == EAGAIN) {  // a pipe whose other owner does not want to wait
      pollfd until{descriptor, POLLOUT, 0};
      ::poll(&until, 1, -1);
      continue;
    }
    if (put < 0) return errno;
    if (put == 0) return EIO;
    count += static_cast<std::size_t>(put);
  }
  return 0;
}

// The sentence for an errno, such as "No space left on device".
[[nodiscard]] inline std::string system_message(int error) {
  return std::generic_category().message(error);
}

}  // namespace candela
