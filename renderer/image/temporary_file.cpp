#include "renderer/image/temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>

#include <fmt/format.h>

namespace candela {
namespace {

// The one that there is; a signal handler can reach nothing but the process's own.
struct Current {
  std::mutex mutex;
  std::array<char, PATH_MAX> path{};
  std::atomic<bool> is_there{false};
};
static_assert(std::atomic<bool>::is_always_lock_free);

Current current;

// A longer path cannot be opened.
void set_current(const std::string& path) {
  if (path.size() >= current.path.size()) return;
  std::memcpy(current.path.data(), path.c_str(), path.size() + 1);
  current.is_there.store(true);
}

// Short whatever the target's name, which may be as long as names can be.
std::string unused_name(const std::string& folder) {
  static std::atomic<unsigned> count{0};
  return fmt::format("{}/.candela-{}-{}.tmp", folder, ::getpid(), count.fetch_add(1));
}

// Some file systems have nothing to flush and say so.
int flush_to_disk(int descriptor) {
  if (::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS) return 0;
  return errno;
}

// A killed process of the same number, as containers have, may have left a file of such a name:
// then another one.
int create(const std::string& folder, std::string& path) {
  constexpr int most_tries = 1000;
  for (int i = 0; i < most_tries; ++i) {
    path = unused_name(folder);
    set_current(path);  // before it is there, so that no signal comes between
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
    current.is_there.store(false);
  }
  return -1;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& folder)
    : only_one_(current.mutex),
      file_(create(folder, path_)),
      error_(file_.is_open() ? 0 : errno),
      was_created_(error_ == 0) {
  if (!was_created_) current.is_there.store(false);
}

TemporaryFile::~TemporaryFile() {
  if (was_created_ && !was_renamed_) ::unlink(path_.c_str());
  current.is_there.store(false);
}

void TemporaryFile::fill(const std::string& bytes) {
  if (error_ == 0) error_ = write_all(file_.get(), bytes);
  if (error_ == 0) error_ = flush_to_disk(file_.get());
  if (!file_.close() && error_ == 0) error_ = errno;
}

void TemporaryFile::rename_to(const std::string& target) {
  if (error_ != 0) return;
  if (struct stat old{}; ::stat(target.c_str(), &old) == 0)
    ::chmod(path_.c_str(), old.st_mode & 07777);
  if (::rename(path_.c_str(), target.c_str()) != 0)
    error_ = errno;
  else
    was_renamed_ = true;
}

void remove_temporary_file() {
  if (current.is_there.load()) ::unlink(current.path.data());
}

}  // namespace candela
