// An open file of the system that closes itself, and the system's words for its errors.
#pragma once

#include <unistd.h>

#include <string>
#include <system_error>

namespace candela {

class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
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

// The sentence for an errno, such as "No space left on device".
[[nodiscard]] inline std::string system_message(int error) {
  return std::generic_category().message(error);
}

}  // namespace candela
