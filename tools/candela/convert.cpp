// candela convert SCENE OUT.pbrt: the scene for pbrt-v4, with its meshes and images in a folder
// beside it. The scene's own file is written last, so that it never names a file that is not there.
#include <filesystem>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "renderer/film/filter.h"
#include "renderer/image/image_io.h"
#include "renderer/image/output_target.h"
#include "scene_io/pbrt/write/write_pbrt.h"
#include "tools/candela/commands.h"
#include "tools/candela/console.h"
#include "tools/candela/convert_images.h"
#include "tools/candela/interrupt.h"
#include "tools/candela/option_values.h"
#include "tools/candela/output_files.h"
#include "tools/candela/read_scene.h"
#include "tools/candela/render_settings.h"

namespace candela::cli {
namespace {

namespace fs = std::filesystem;

// What candela would do where the scene says nothing: pbrt's own defaults are others.
void fill_defaults(const RenderOptions& options, description::RenderDefaults& defaults) {
  defaults.width = options.width;
  defaults.height = options.height;
  defaults.samples_per_pixel = options.samples_per_pixel;
  defaults.max_depth = options.max_depth;
  defaults.integrator = std::string(integrator_name(options));
  defaults.filter = std::string(name_of(options.filter, filter_choices()));
  defaults.filter_radius = options.filter_radius.value_or(default_radius(options.filter));
}

// A file of the conversion and what makes its bytes.
struct Output {
  std::string path;
  std::function<Result<std::string>()> bytes;
};

class Conversion {
 public:
  explicit Conversion(const ConvertArguments& arguments) : arguments_(arguments) {}

  ExitCode run() {
    if (fs::path(arguments_.output).extension() != ".pbrt")
      return fail(ExitCode::Usage,
                  fmt::format("'{}': expected a name and .pbrt behind it", arguments_.output));
    const Diagnostics unwritable = check_writable_file(arguments_.output);
    console_.print(unwritable);
    if (unwritable.has_errors()) return ExitCode::Output;
    target_ = find_output_target(arguments_.output).path;
    ReadScene read = read_scene(arguments_.scene, console_);
    if (!read.is_usable()) return ExitCode::Scene;
    RenderArguments wishes = as_the_scene_asks(arguments_.scene);
    wishes.camera = arguments_.camera;
    const SettledSettings settled = settle_settings(wishes, *read.description, MemoryNeed::Ignored);
    if (!settled.settings) return fail(settled.exit_code, settled.error);
    fill_defaults(settled.settings->options, read.description->defaults);
    return convert(*read.description);
  }

 private:
  ExitCode fail(ExitCode code, const std::string& sentence) {
    console_.error(sentence);
    return code;
  }

  [[nodiscard]] std::string beside(const std::string& name) const {
    return (target_.parent_path() / name).string();
  }

  ExitCode convert(const description::SceneDescription& description) {
    const std::string stem = target_.stem().string();
    const Result<pbrt::WrittenScene> written = pbrt::write_pbrt(
        description, {stem + "_files", stem + ".exr", arguments_.camera, image_facts});
    console_.print(written.diagnostics);
    if (!written) return ExitCode::Scene;
    if (arguments_.scene.is_strict && written.diagnostics.warning_count() > 0) {
      console_.strict_error(written.diagnostics.warning_count(), arguments_.scene.path);
      return ExitCode::Scene;
    }
    const std::vector<Output> outputs = outputs_of(*written, description);
    std::vector<std::string> paths;
    for (const Output& output : outputs) paths.push_back(output.path);
    const Diagnostics overwritten = check_scene_is_spared(paths, description);
    console_.print(overwritten);
    if (overwritten.has_errors()) return ExitCode::Output;
    return write(outputs, beside(stem + "_files"));
  }

  [[nodiscard]] std::vector<Output> outputs_of(
      const pbrt::WrittenScene& written, const description::SceneDescription& description) const {
    std::vector<Output> outputs;
    for (const pbrt::WrittenFile& mesh : written.meshes)
      outputs.push_back({beside(mesh.name), [&] { return mesh.bytes; }});
    for (const pbrt::WrittenImage& image : written.images)
      outputs.push_back({beside(image.name), [&] { return make_image(image); }});
    for (const pbrt::WrittenSky& sky : written.skies)
      outputs.push_back({beside(sky.name), [&] { return make_sky(sky, description); }});
    outputs.push_back({arguments_.output, [&] { return written.text; }});
    return outputs;
  }

  // Under --strict a warning about any file is told before the first one is written.
  ExitCode write(const std::vector<Output>& outputs, const std::string& folder) {
    if (arguments_.scene.is_strict)
      for (const Output& output : outputs)
        if (const auto problem = problem_of(output.bytes())) return *problem;
    std::error_code failed;
    if (outputs.size() > 1) fs::create_directories(folder, failed);
    if (failed)
      return fail(ExitCode::Output,
                  fmt::format("the folder '{}' cannot be made: {}", folder, failed.message()));
    set_interrupt_mode(InterruptMode::Finish);
    for (const Output& output : outputs) {
      if (was_interrupted())
        return fail(ExitCode::Interrupted,
                    fmt::format("interrupted; '{}' was not written", arguments_.output));
      const Result<std::string> bytes = output.bytes();
      if (const auto problem = problem_of(bytes)) return *problem;
      const Diagnostics problems = write_file_atomically(output.path, *bytes);
      console_.print(problems);
      if (problems.has_errors()) return ExitCode::Output;
    }
    console_.note(fmt::format("wrote {} and {} beside it", target_.string(),
                              counted(outputs.size() - 1, "file")));
    return ExitCode::Done;
  }

  // Tells what was met, and how the program is to end by it.
  std::optional<ExitCode> problem_of(const Result<std::string>& bytes) {
    console_.print(bytes.diagnostics);
    if (!bytes) return ExitCode::Scene;
    const std::size_t warnings = bytes.diagnostics.warning_count();
    if (!arguments_.scene.is_strict || warnings == 0) return std::nullopt;
    console_.strict_error(warnings, arguments_.scene.path);
    return ExitCode::Scene;
  }

  const ConvertArguments& arguments_;
  fs::path target_;
  Console console_{false};
};

}  // namespace

ExitCode run_convert(const ConvertArguments& arguments) {
  return Conversion(arguments).run();
}

}  // namespace candela::cli
