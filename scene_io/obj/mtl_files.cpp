#include "scene_io/obj/mtl_files.h"

#include <filesystem>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene_io/obj/map_images.h"
#include "scene_io/obj/read_mtl.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/file.h"
#include "scene_io/text/path.h"
#include "scene_io/text/plain_text.h"

namespace candela::obj {
namespace {

using text::ResolvedPath;
using text::Source;

// MTLs are small; what is larger is something else.
constexpr text::FileLimits limits{std::uint64_t{256} << 20, std::uint64_t{256} << 20};

void say(const Source& source, std::string_view name, Severity severity, std::string message,
         Diagnostics& diagnostics) {
  const auto offset = static_cast<std::size_t>(name.data() - source.text.data());
  text::report(diagnostics, source, offset, severity, std::move(message));
}

void add_library(MtlLibrary&& library, ObjModel& model) {
  const std::size_t first_image = model.images.size();
  for (description::Material& material : library.materials) {
    for_each_image(material, [&](description::ImageHandle& image) {
      if (image) image = description::ImageHandle(image.index + first_image);
    });
  }
  std::move(library.materials.begin(), library.materials.end(),
            std::back_inserter(model.materials));
  std::move(library.images.begin(), library.images.end(), std::back_inserter(model.images));
}

std::string normal(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

// Whether what a 'mtllib' names could be read.
bool read_library(const Source& source, std::string_view name, const ResolvedPath& resolved,
                  MtlUse use, ObjModel& model, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string_view reason) {
    say(source, name, Severity::Warning,
        fmt::format("MTL file {} {}; faces that use its materials have none",
                    text::quoted_path(resolved.path), reason),
        diagnostics);
    return false;
  };
  Result<std::string> text = text::read_file(resolved.path, limits);
  if (!text)
    return refuse(text.diagnostics.list().empty() ? "" : text.diagnostics.list().front().message);
  if (text::is_utf16(*text)) return refuse("is in UTF-16, expected ASCII or UTF-8");
  text::drop_byte_order_mark(*text);
  text::use_line_feeds(*text);
  if (resolved.is_substitute())
    say(source, name, Severity::Note, text::describe_substitute(resolved, name), diagnostics);
  model.files.push_back(resolved.path);
  add_library(parse_mtl(resolved.path, *text, use, diagnostics), model);
  return true;
}

// The files that one 'mtllib' names: one with blanks in its name, or several. Of what is nowhere
// the whole.
std::vector<std::pair<std::string_view, ResolvedPath>> files_of(const std::string& referrer,
                                                                std::string_view listed) {
  ResolvedPath whole = text::resolve_path(referrer, listed);
  if (!whole.is_found) {
    listed = text::without_comment(listed);
    whole = text::resolve_path(referrer, listed);
  }
  if (listed.empty()) return {};
  const bool is_one_word = listed.find_first_of(" \t") == std::string_view::npos;
  if (whole.is_found || is_one_word) return {{listed, whole}};
  std::vector<std::pair<std::string_view, ResolvedPath>> parts;
  bool is_any_found = false;
  text::Cursor names(listed);
  for (std::string_view name = names.next_word(); !name.empty() && name[0] != '#';
       name = names.next_word()) {
    parts.emplace_back(name, text::resolve_path(referrer, name));
    is_any_found = is_any_found || parts.back().second.is_found;
  }
  if (!is_any_found) return {{listed, whole}};
  return parts;
}

}  // namespace

bool read_libraries(const std::string& path, const Source& source, const ObjData& data, MtlUse use,
                    ObjModel& model, Diagnostics& diagnostics) {
  bool all_are_there = true;
  std::set<std::string_view> seen;  // some exporters repeat the line for each object
  std::set<std::string> asked{normal(path)};
  for (const Chunk& chunk : data.chunks) {
    for (const MtlReference& reference : chunk.libraries) {
      if (!seen.insert(reference.names).second) continue;
      const auto files = files_of(path, reference.names);
      if (files.empty())
        text::report(diagnostics, source, reference.offset, Severity::Warning,
                     "no file is named; expected the name of an MTL file");
      for (const auto& [name, resolved] : files)
        if (asked.insert(normal(resolved.path)).second)
          all_are_there &= read_library(source, name, resolved, use, model, diagnostics);
    }
  }
  return all_are_there;
}

}  // namespace candela::obj
