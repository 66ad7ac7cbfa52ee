#include "tools/candela/output_files.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <unistd.h>

#include "renderer/image/image_io.h"
#include "renderer/image/output_target.h"
#include "tools/candela/interrupt.h"

namespace candela::cli {
namespace {

// Each output is checked and written once, both under a temporary name of its own; twice that for
// files written later (--stats).
constexpr unsigned names_an_output = 4;

std::string canonical(const std::string& path) {
  std::error_code error;
  const auto resolved = std::filesystem::weakly_canonical(path, error);
  return error ? path : resolved.string();
}

}  // namespace

OutputCheck check_outputs(const std::vector<std::string>& images, const std::string& stats) {
  OutputCheck check;
  std::vector<std::string> paths = images;
  if (!stats.empty()) paths.push_back(stats);
  const WritingGuard guard(paths);  // a check tries to make a file
  std::set<std::string> seen;
  const auto is_new = [&](const std::string& path) {
    if (seen.insert(canonical(path)).second) return true;
    check.diagnostics.error({}, fmt::format("'{}' is named twice as an output", path));
    check.exit_code = ExitCode::Usage;
    return false;
  };
  for (const std::string& path : images)
    if (is_new(path)) check.diagnostics.append(check_writable_image(path));
  if (!stats.empty() && is_new(stats)) check.diagnostics.append(check_writable_file(stats));
  if (check.exit_code == ExitCode::Done && check.diagnostics.has_errors())
    check.exit_code = ExitCode::Output;
  return check;
}

Diagnostics check_scene_is_spared(const std::vector<std::string>& outputs,
                                  const description::SceneDescription& description) {
  std::set<std::string> inputs;
  for (const std::string& path : description.files) inputs.insert(canonical(path));
  for (const description::Image& image : description.images) inputs.insert(canonical(image.path));
  Diagnostics diagnostics;
  for (const std::string& path : outputs)
    if (inputs.count(canonical(path)) > 0)
      diagnostics.error({},
                        fmt::format("'{}' is read by the scene and would be overwritten", path));
  return diagnostics;
}

WritingGuard::WritingGuard(const std::vector<std::string>& outputs) {
  std::set<std::string> folders;
  for (const std::string& path : outputs) folders.insert(find_output_target(path).folder);
  const auto count = static_cast<unsigned>(outputs.size()) * names_an_output;
  std::vector<std::string> names;
  for (const std::string& folder : folders)
    for (unsigned i = 0; i < count; ++i)
      names.push_back(folder + "/" + temporary_file_name(::getpid(), i));
  set_temporary_files(names);
  set_interrupt_mode(InterruptMode::Finish);
}

WritingGuard::~WritingGuard() {
  set_interrupt_mode(InterruptMode::EndAtOnce);
  set_temporary_files({});
}

std::string temporary_file_name(int process, unsigned count) {
  return fmt::format(".candela-{}-{}.tmp", process, count);
}

}  // namespace candela::cli
