// Bytes to a file, all or nothing: written beside the target, fsync, rename (invariant 8).
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "renderer/image/blocked_signals.h"
#include "renderer/image/file_descriptor.h"
#include "renderer/image/image_io.h"
#include "renderer/image/output_target.h"

namespace candela {
namespace {

Diagnostics cannot_write(const std::string& path, int error) {
  return failure(fmt::format("'{}' cannot be written: {}", path, system_message(error)));
}

// 0 or the errno of the first write that failed. A short write is tried again: the next call tells
// why.
int write_all(int descriptor, const std::string& bytes) {
  std::size_t count = 0;
  while (count < bytes.size()) {
    const ssize_t put = ::write(descriptor, bytes.data() + count, bytes.size() - count);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return errno;
    if (put == 0) return EIO;
    count += static_cast<std::size_t>(put);
  }
  return 0;
}

// Some file systems have nothing to flush and say so.
int flush_to_disk(int descriptor) {
  if (::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS) return 0;
  return errno;
}

// A file beside the target that is gone when this is, unless it took the target's place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& folder)
      : path_(unused_name(folder)),
        file_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)),
        error_(file_.is_open() ? 0 : errno) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (is_present()) ::unlink(path_.c_str());
  }

  [[nodiscard]] int error() const { return error_; }

  void fill(const std::string& bytes) {
    if (error_ == 0) error_ = write_all(file_.get(), bytes);
    if (error_ == 0) error_ = flush_to_disk(file_.get());
    if (!file_.close() && error_ == 0) error_ = errno;
  }

  void rename_to(const std::string& target) {
    if (error_ != 0) return;
    if (struct stat old{}; ::stat(target.c_str(), &old) == 0)
      ::chmod(path_.c_str(), old.st_mode & 07777);
    if (::rename(path_.c_str(), target.c_str()) != 0)
      error_ = errno;
    else
      was_renamed_ = true;
  }

 private:
  // Short whatever the target's name, which may be as long as names can be.
  static std::string unused_name(const std::string& folder) {
    static std::atomic<unsigned> count{0};
    return fmt::format("{}/.candela-{}-{}.tmp", folder, ::getpid(), count.fetch_add(1));
  }
  [[nodiscard]] bool is_present() const { return !was_renamed_ && was_created_; }

  std::string path_;
  FileDescriptor file_;
  int error_;
  bool was_created_ = error_ == 0;
  bool was_renamed_ = false;
};

// So that the new name survives a crash too. What fails here leaves the file whole.
void flush_folder(const std::string& folder) {
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) ::fsync(opened.get());
}

// Pipes and devices such as /dev/stdout have no partial state to hide.
Diagnostics write_to_stream(const std::string& path, const std::string& bytes) {
  FileDescriptor stream(::open(path.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!stream.is_open()) return cannot_write(path, errno);
  ::fcntl(stream.get(), F_SETFL, ::fcntl(stream.get(), F_GETFL) & ~O_NONBLOCK);
  int error = write_all(stream.get(), bytes);
  if (!stream.close() && error == 0) error = errno;
  return error == 0 ? Diagnostics{} : cannot_write(path, error);
}

}  // namespace

Diagnostics write_file_atomically(const std::string& path, const std::string& bytes) {
  const BlockedWriteSignals blocked;
  const OutputTarget target = find_output_target(path);
  if (target.diagnostics.has_errors()) return target.diagnostics;
  if (target.is_stream) return write_to_stream(target.path, bytes);
  TemporaryFile temporary(target.folder);
  temporary.fill(bytes);
  temporary.rename_to(target.path);
  if (temporary.error() != 0) return cannot_write(path, temporary.error());
  flush_folder(target.folder);
  return {};
}

Diagnostics check_writable_file(const std::string& path) {
  const OutputTarget target = find_output_target(path);
  if (target.diagnostics.has_errors() || target.is_stream) return target.diagnostics;
  const TemporaryFile trial(target.folder);
  if (trial.error() == 0) return {};
  return failure(fmt::format("'{}' cannot be written: folder '{}': {}", path, target.folder,
                             system_message(trial.error())));
}

}  // namespace candela
