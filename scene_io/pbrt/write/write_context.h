// What the steps of write_pbrt() share.
#pragma once

#include <map>
#include <set>
#include <string>

#include "scene_io/pbrt/write/write_pbrt.h"

namespace candela::pbrt {

struct WriteContext {
  const description::SceneDescription& scene;
  const WriteOptions& options;
  WrittenScene& written;
  Diagnostics& diagnostics;
  std::set<std::string> names = {};  // of files and of things in the text that must differ
  std::map<std::string, int> next_numbers = {};  // of wishes that were taken

  void warn(const SourceSpan& span, std::string sentence) {
    diagnostics.warning(span, std::move(sentence));
  }
  // `wish`, or with a number behind its stem where that is taken. `kind` keeps names apart that may
  // be alike, such as those of a texture and a material.
  std::string unique_name(const std::string& kind, const std::string& wish);
};

// The last part of a path without its extension; letters, digits, '-' and '_' only.
[[nodiscard]] std::string stem_of(std::string_view path);
// ".png" of "a/b.PNG".
[[nodiscard]] std::string lower_extension_of(std::string_view path);

}  // namespace candela::pbrt
