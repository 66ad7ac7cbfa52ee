#include "renderer/image/output_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/file_descriptor.h"
#include "renderer/base/result.h"

namespace candela {
namespace {

// As many as Linux follows.
constexpr int max_links = 40;

std::optional<int> whole_number(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

std::optional<int> descriptor_in(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  if (folder != "/dev/fd" && folder != "/proc/self/fd" &&
      folder != fmt::format("/proc/{}/fd", ::getpid()))
    return std::nullopt;
  return whole_number(path.filename().string());
}

struct LinksEnd {
  std::string path;
  std::optional<int> descriptor;
};

// Replacing a link by a file would surprise: what it points to is written instead. A path whose end
// does not exist yet comes back as it is. What /dev/stdout is open on may be a file that others
// write to, or one without a name: no further than to the descriptor.
LinksEnd follow_links(const std::string& path) {
  std::filesystem::path current(path);
  for (int i = 0; i < max_links; ++i) {
    if (const auto descriptor = descriptor_in(current)) return {current.string(), descriptor};
    std::error_code error;
    const std::filesystem::path next = std::filesystem::read_symlink(current, error);
    if (error) break;
    current = next.is_absolute() ? next : current.parent_path() / next;
  }
  return {current.string(), std::nullopt};
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

Diagnostics check_folder(const std::string& path, const std::string& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) {
    const std::string reason = errno == ENOENT ? "does not exist" : system_message(errno);
    return failure(fmt::format("'{}' cannot be written: folder '{}': {}", path, folder, reason));
  }
  if (S_ISDIR(status.st_mode)) return {};
  return failure(fmt::format("'{}' cannot be written: '{}' is not a folder", path, folder));
}

Diagnostics check_descriptor(const std::string& path, int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) != O_RDONLY) return {};
  return failure(fmt::format("'{}' cannot be written: {}", path,
                             flags < 0 ? system_message(errno) : "it is not open for writing"));
}

// A pipe or device.
bool is_stream(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace

OutputTarget find_output_target(const std::string& path) {
  OutputTarget target;
  if (path.empty() || path.back() == '/') {
    target.diagnostics = failure(fmt::format("'{}' cannot be written: it names no file", path));
    return target;
  }
  const LinksEnd end = follow_links(path);
  target.descriptor = end.descriptor;
  if (target.descriptor) {
    target.path = path;
    target.is_stream = true;
    target.diagnostics = check_descriptor(path, *target.descriptor);
    return target;
  }
  target.is_stream = is_stream(path);
  target.path = target.is_stream ? path : end.path;
  target.folder = folder_of(target.path);
  target.diagnostics = check_folder(path, target.folder);
  if (target.diagnostics.has_errors()) return target;
  struct stat status {};
  if (::stat(target.path.c_str(), &status) != 0) {
    if (errno != ENOENT)
      target.diagnostics =
          failure(fmt::format("'{}' cannot be written: {}", path, system_message(errno)));
    return target;
  }
  if (S_ISDIR(status.st_mode))
    target.diagnostics = failure(fmt::format("'{}' cannot be written: it is a folder", path));
  else if (::access(target.path.c_str(), W_OK) != 0)
    target.diagnostics =
        failure(fmt::format("'{}' cannot be written: {}", path, system_message(errno)));
  return target;
}

}  // namespace candela
