#include "scene_io/lab3/assets.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "scene_io/text/path.h"

namespace candela::lab3 {
namespace {

using description::Encoding;
using description::ImageHandle;
using description::Wrap;

// The regular file beside `path` whose name is nearest to its own.
std::string suggest_file(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr std::size_t most = 1000;
  const fs::path wanted(path);
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end && names.size() < most;
       at.increment(failed))
    names.push_back(at->path().filename().string());
  std::sort(names.begin(), names.end());
  return did_you_mean(wanted.filename().string(), {names.begin(), names.end()});
}

std::string file_name_of(Reader& reader, const Entry& entry) {
  const Node& node = *entry.value;
  if (node.is_scalar() && !node.text.empty()) return node.text;
  const std::string key = entry.key.empty() ? "" : entry.key + ": ";
  reader.error(node.offset,
               fmt::format("{}found {}, expected the name of a file", key, describe(node)));
  return "";
}

}  // namespace

std::string problem_of_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code failed;
  switch (fs::status(path, failed).type()) {
    case fs::file_type::regular:
      return "";
    case fs::file_type::none:
    case fs::file_type::not_found:
      return "no such file";
    case fs::file_type::directory:
      return "this is a folder";
    case fs::file_type::fifo:
      return "this is a FIFO";
    case fs::file_type::socket:
      return "this is a socket";
    case fs::file_type::block:
    case fs::file_type::character:
      return "this is a device";
    default:
      return "this is no regular file";
  }
}

std::string resolved(Reader& reader, std::size_t offset, const std::string& name) {
  const text::ResolvedPath found = text::resolve_path(reader.scene.path, name);
  if (found.is_substitute()) reader.warning(offset, text::describe_substitute(found, name));
  return found.path;
}

std::string required_file(Reader& reader, const Entry& entry, std::string_view what) {
  const std::string name = file_name_of(reader, entry);
  if (name.empty()) return "";
  const std::string path = resolved(reader, entry.value->offset, name);
  const std::string problem = problem_of_file(path);
  if (problem.empty()) return path;
  const bool is_missing = problem == "no such file";
  const std::string suggestion = is_missing && reader.wants_errors() ? suggest_file(path) : "";
  reader.error(entry.value->offset,
               fmt::format("{}: {} {}{}", text::quoted(name), problem,
                           is_missing ? fmt::format("for {}", what)
                                      : fmt::format("where {} was expected", what),
                           suggestion));
  return "";
}

ImageHandle read_image(Reader& reader, const Entry* entry, Encoding encoding, Wrap wrap) {
  if (!entry) return {};
  const std::string name = file_name_of(reader, *entry);
  if (name.empty()) return {};
  const std::string path = resolved(reader, entry->value->offset, name);
  const std::string problem = problem_of_file(path);
  if (!problem.empty() && problem != "no such file") {
    reader.error(entry->value->offset,
                 fmt::format("{}: {} where an image was expected", text::quoted(name), problem));
    return {};
  }
  return reader.images.add({path, encoding, wrap, reader.span(entry->value->offset)}, reader.scene);
}

ImageHandle read_image_over(Reader& reader, const Entry* factor, const Entry* map,
                            Encoding encoding) {
  const ImageHandle image = read_image(reader, map, encoding, Wrap::Repeat);
  if (image && factor)
    reader.warning(factor->key_offset,
                   fmt::format("{} is not used: {} replaces it", factor->key, map->key));
  return image;
}

ImageHandle read_required_image(Reader& reader, const Entry& entry, Encoding encoding, Wrap wrap) {
  const std::string path = required_file(reader, entry, "an image");
  if (path.empty()) return {};
  return reader.images.add({path, encoding, wrap, reader.span(entry.value->offset)}, reader.scene);
}

}  // namespace candela::lab3
