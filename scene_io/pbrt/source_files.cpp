#include "scene_io/pbrt/source_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene_io/text/file.h"
#include "scene_io/text/path.h"
#include "scene_io/text/plain_text.h"

namespace candela::pbrt {
namespace {

// pbrt has none of these limits. They stand far above scenes that people made, and end those that
// include themselves, or two files each of which includes two others, within a second.
constexpr std::size_t deepest = 64;
constexpr std::size_t most_includes = 65536;
constexpr std::uint64_t most_bytes = std::uint64_t{4} << 30;  // counted at every include

}  // namespace

std::string resolve_file(const std::string& scene_path, const Place& place, const std::string& name,
                         const Report& report) {
  text::ResolvedPath found = text::resolve_path(scene_path, name);
  if (!found.is_found && place.file) {
    const text::ResolvedPath beside = text::resolve_path(place.file->path(), name);
    if (beside.is_found) found = beside;
  }
  if (found.is_substitute()) report.warning(place, text::describe_substitute(found, name));
  return found.path;
}

void SourceFiles::open(const std::string& path, std::string bytes) {
  bytes_ += bytes.size();
  files_.push_back(std::make_unique<SourceFile>(path, std::move(bytes)));
  const SourceFile* file = files_.back().get();
  file_at_[path] = file;
  stack_.push_back({file, Tokenizer(file->source().text), false});
}

const SourceFile* SourceFiles::read(const Place& place, const std::string& path) {
  const auto known = file_at_.find(path);
  if (known != file_at_.end()) return known->second;
  Result<std::string> bytes = text::read_file(path);
  if (!bytes) {
    for (const Diagnostic& reason : bytes.diagnostics.list())
      report_.error(place, fmt::format("{} {}", text::quoted_path(path), reason.message));
    return nullptr;
  }
  if (text::is_utf16(*bytes)) {
    report_.error(place, fmt::format("{} is in UTF-16, expected UTF-8", text::quoted_path(path)));
    return nullptr;
  }
  text::drop_byte_order_mark(*bytes);
  files_.push_back(std::make_unique<SourceFile>(path, std::move(*bytes)));
  return file_at_[path] = files_.back().get();
}

bool SourceFiles::include(const Place& place, const std::string& name, bool is_import) {
  const std::string path = resolve_file(scene_path_, place, name, report_);
  const auto is_open = [&](const OpenFile& open) { return open.file->path() == path; };
  if (std::any_of(stack_.begin(), stack_.end(), is_open)) {
    report_.error(place, fmt::format("{} includes itself", text::quoted_path(path)));
    return false;
  }
  if (stack_.size() >= deepest) {
    report_.error(place, fmt::format("files include each other more than {} deep", deepest));
    return false;
  }
  const SourceFile* file = read(place, path);
  if (!file) return false;
  bytes_ += file->source().text.size();
  if (++include_count_ > most_includes || bytes_ > most_bytes) {
    report_.error(place, fmt::format("more than {} files or {} bytes are included", most_includes,
                                     most_bytes));
    return false;
  }
  stack_.push_back({file, Tokenizer(file->source().text), is_import});
  return true;
}

std::vector<std::string> SourceFiles::paths() const {
  std::vector<std::string> paths;
  for (const auto& file : files_) paths.push_back(file->path());
  return paths;
}

}  // namespace candela::pbrt
