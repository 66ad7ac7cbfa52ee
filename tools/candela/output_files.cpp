#include "tools/candela/output_files.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "renderer/description/files_read.h"
#include "renderer/image/image_io.h"
#include "renderer/image/output_target.h"

namespace candela::cli {
namespace {

// Where a link leads to nothing yet, what will be there. Absolute first: what is not there stays as
// it is written else.
std::string canonical(const std::string& path) {
  std::error_code error;
  const auto target = std::filesystem::absolute(find_output_target(path).path, error);
  const auto resolved = std::filesystem::weakly_canonical(target, error);
  return error ? path : resolved.string();
}

}  // namespace

OutputCheck check_outputs(const std::vector<std::string>& images,
                          const std::optional<std::string>& stats) {
  OutputCheck check;
  std::set<std::string> seen;
  const auto is_new = [&](const std::string& path) {
    if (seen.insert(canonical(path)).second) return true;
    check.diagnostics.error({}, fmt::format("'{}' is named twice as an output", path));
    check.exit_code = ExitCode::Usage;
    return false;
  };
  for (const std::string& path : images)
    if (is_new(path)) check.diagnostics.append(check_writable_image(path));
  if (stats && is_new(*stats)) check.diagnostics.append(check_writable_file(*stats));
  if (check.exit_code == ExitCode::Done && check.diagnostics.has_errors())
    check.exit_code = ExitCode::Output;
  return check;
}

Diagnostics check_image_sizes(const std::vector<std::string>& images, int width, int height) {
  Diagnostics diagnostics;
  for (const std::string& path : images) diagnostics.append(check_image_size(path, width, height));
  return diagnostics;
}

Diagnostics check_inputs_are_spared(const std::vector<std::string>& outputs,
                                    const std::vector<std::string>& inputs,
                                    std::string_view reader) {
  std::set<std::string> read;
  for (const std::string& path : inputs) read.insert(canonical(path));
  Diagnostics diagnostics;
  for (const std::string& path : outputs)
    if (read.count(canonical(path)) > 0)
      diagnostics.error({},
                        fmt::format("'{}' is read by {} and would be overwritten", path, reader));
  return diagnostics;
}

Diagnostics check_scene_is_spared(const std::vector<std::string>& outputs,
                                  const description::SceneDescription& description) {
  return check_inputs_are_spared(outputs, description::files_read(description), "the scene");
}

}  // namespace candela::cli
