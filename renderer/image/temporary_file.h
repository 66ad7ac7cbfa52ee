// A file that is filled beside its target and takes its place when it is whole.
#pragma once

#include <mutex>
#include <string>

#include "renderer/base/file_descriptor.h"

namespace candela {

// Gone when this is, unless it took the target's place. One at a time in the process: another
// thread's waits.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& folder);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  // 0 or the errno of what failed first; nothing is done after that.
  [[nodiscard]] int error() const { return error_; }
  void fill(const std::string& bytes);
  void rename_to(const std::string& target);

 private:
  std::unique_lock<std::mutex> only_one_;
  std::string path_;
  FileDescriptor file_;
  int error_;
  bool was_created_;
  bool was_renamed_ = false;
};

// Removes the one that there is just now, if any, for signal handlers that end the process:
// async-signal-safe.
void remove_temporary_file();

}  // namespace candela
