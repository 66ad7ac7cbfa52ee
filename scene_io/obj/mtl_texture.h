// The arguments of a map statement: options, then a file name that may hold spaces.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "renderer/base/diagnostic.h"
#include "scene_io/obj/mtl_statements.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/path.h"

namespace candela::obj {

// The files that names mean, each looked for once.
class TextureNames {
 public:
  explicit TextureNames(const std::string& mtl_path) : mtl_path_(mtl_path) {}
  // Sets `is_new` for a name not asked for before.
  [[nodiscard]] const text::ResolvedPath& find(std::string_view name, bool& is_new);

 private:
  const std::string& mtl_path_;
  std::unordered_map<std::string_view, text::ResolvedPath> known_;  // views of the MTL's text
};

struct TextureContext {
  TextureNames& names;
  text::SpanFinder& span_at;
  bool warns_of_options = false;  // of those that change nothing here
  Diagnostics& diagnostics;
};

// Nothing, after an error, where an option is malformed or no file is named. Notes where a file was
// found by another letter case.
[[nodiscard]] std::optional<MtlTexture> parse_texture(const text::Source& source,
                                                      text::Cursor arguments,
                                                      const TextureContext& context);

}  // namespace candela::obj
