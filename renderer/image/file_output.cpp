// Bytes to a file, all or nothing: written beside the target, fsync, rename.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include <fmt/format.h>

#include "renderer/base/file_descriptor.h"
#include "renderer/image/blocked_signals.h"
#include "renderer/image/image_io.h"
#include "renderer/image/output_target.h"
#include "renderer/image/temporary_file.h"

namespace candela {
namespace {

Diagnostics cannot_write(const std::string& path, int error) {
  return failure(fmt::format("'{}' cannot be written: {}", path, system_message(error)));
}

// So that the new name survives a crash too. What fails here leaves the file whole.
void flush_folder(const std::string& folder) {
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) ::fsync(opened.get());
}

// A descriptor is doubled and not opened anew: its place in a file, and whether it appends, hold.
int open_stream(const OutputTarget& target) {
  if (target.descriptor) return ::fcntl(*target.descriptor, F_DUPFD_CLOEXEC, 0);
  const int opened = ::open(target.path.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (opened >= 0) ::fcntl(opened, F_SETFL, ::fcntl(opened, F_GETFL) & ~O_NONBLOCK);
  return opened;
}

// Pipes and devices such as /dev/stdout have no partial state to hide.
Diagnostics write_to_stream(const OutputTarget& target, const std::string& bytes) {
  FileDescriptor stream(open_stream(target));
  if (!stream.is_open()) return cannot_write(target.path, errno);
  int error = write_all(stream.get(), bytes);
  if (!stream.close() && error == 0) error = errno;
  return error == 0 ? Diagnostics{} : cannot_write(target.path, error);
}

}  // namespace

Diagnostics write_file_atomically(const std::string& path, const std::string& bytes) {
  const BlockedWriteSignals blocked;
  const OutputTarget target = find_output_target(path);
  if (target.diagnostics.has_errors()) return target.diagnostics;
  if (target.is_stream) return write_to_stream(target, bytes);
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
