// The files that a scene is made of: found beside it, read once each, and open one within another.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene_io/pbrt/report.h"
#include "scene_io/pbrt/token.h"

namespace candela::pbrt {

// The path that `name`, written in a file of the scene, means: relative to the scene's first file,
// as in pbrt, else to the file that names it.
[[nodiscard]] std::string resolve_file(const std::string& scene_path, const Place& place,
                                       const std::string& name, const Report& report);

// A file being read.
struct OpenFile {
  const SourceFile* file = nullptr;
  Tokenizer tokens{{}};
  bool is_import = false;
};

class SourceFiles {
 public:
  SourceFiles(const std::string& scene_path, const Report& report)
      : scene_path_(scene_path), report_(report) {}

  // The scene's first file.
  void open(const std::string& path, std::string bytes);
  // Include and Import. False: in error, said at `place`.
  bool include(const Place& place, const std::string& name, bool is_import);
  void close() { stack_.pop_back(); }

  [[nodiscard]] bool is_done() const { return stack_.empty(); }
  [[nodiscard]] OpenFile& current() { return stack_.back(); }
  // In the order of their first use.
  [[nodiscard]] std::vector<std::string> paths() const;

 private:
  const SourceFile* read(const Place& place, const std::string& path);

  const std::string& scene_path_;
  const Report& report_;
  std::vector<std::unique_ptr<SourceFile>> files_;
  std::map<std::string, const SourceFile*> file_at_;
  std::vector<OpenFile> stack_;
  std::uint64_t bytes_ = 0;
  std::size_t include_count_ = 0;
};

}  // namespace candela::pbrt
