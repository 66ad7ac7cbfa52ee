// What all parts of the lab3 reader share: the text, the scene that grows, and the way to say what
// is wrong at a place of the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "scene_io/image_index.h"
#include "scene_io/load_options.h"
#include "scene_io/text/line_begins.h"
#include "scene_io/text/source.h"

namespace candela::lab3 {

class Reader {
 public:
  Reader(const std::string& path, std::string_view text, const LoadOptions& load_options,
         description::SceneDescription& target, Diagnostics& found);

  const LoadOptions& options;
  description::SceneDescription& scene;
  Diagnostics& diagnostics;
  text::Source source;

  // Found on the way, needed further on.
  std::unordered_map<std::string, description::MaterialHandle> materials_by_name;
  bool lacks_material_names = false;  // some could not be read, or there are none: it was said
  ImageIndex images;
  bool has_ambient = false;      // the file gives it
  bool has_environment = false;  // a skybox or an Environment
  bool is_extended = false;      // the file uses a key that lab3 does not have: its ambient is 0
  double z_far = 100;            // of camera 0

  void error(std::size_t offset, std::string message);
  void warning(std::size_t offset, std::string message);
  // About the file as a whole.
  void note(std::string message);
  // Line and column of a byte, by a table: cheap also where every value of a long file keeps one.
  [[nodiscard]] SourceSpan span(std::size_t offset) const;
  // Enough is wrong: no need to look further.
  [[nodiscard]] bool is_full() const { return diagnostics.is_full(); }
  // False: further ones are only counted, so their sentences need not be made.
  [[nodiscard]] bool wants_errors() const { return text::is_kept(diagnostics, Severity::Error); }
  [[nodiscard]] bool wants_warnings() const {
    return text::is_kept(diagnostics, Severity::Warning);
  }

 private:
  void add(Severity severity, std::size_t offset, std::string message);

  text::LineBegins lines_;
};

}  // namespace candela::lab3
