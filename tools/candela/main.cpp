// The way of the data: load, compile, build, render, write.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "integrators/render.h"
#include "renderer/accel/any_accel.h"
#include "renderer/base/large_pages.h"
#include "renderer/base/parallel.h"
#include "renderer/image/image_io.h"
#include "renderer/scene/compile.h"
#include "scene_io/load.h"
#include "tools/candela/commands.h"
#include "tools/candela/console.h"
#include "tools/candela/guarded.h"
#include "tools/candela/interrupt.h"
#include "tools/candela/parse_arguments.h"
#include "tools/candela/render_run.h"
#include "tools/candela/render_settings.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace candela::cli {
namespace {

// The allocator keeps what reading has freed for itself, and building the accelerator, the peak of
// most renders, asks the system for more.
void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

ExitCode render_scene(const RenderArguments& arguments) {
  RenderRun run(arguments);
  if (!run.outputs_are_writable()) return run.exit_code();

  auto description = run.timed(&StageSeconds::load,
                               [&] { return load(arguments.scene.path, arguments.scene.load); });
  if (!run.accepts(description) || !run.settles(*description)) return run.exit_code();

  const auto scene = run.timed(&StageSeconds::compile, [&] {
    return compile(*description, compile_options(run.options()));
  });
  if (!run.accepts(scene) || !run.accepts_scene(*scene)) return run.exit_code();
  description.value.reset();  // its meshes in double are not needed any more
  give_back_freed_memory();

  std::optional<AnyAccelerator> accelerator = run.timed(&StageSeconds::build, [&] {
    return build_accelerator(*scene, arguments.accelerator,
                             embree_options_without(arguments.without, arguments.embree));
  });

  ProgressSink* const progress = run.start_rendering(*scene);
  const double decoding_before = scene->textures.decoding_seconds();
  const RenderResult result = run.timed(&StageSeconds::render, [&] {
    return render(*scene, *accelerator, run.options(), progress, &cancel_flag());
  });
  run.rendered(*scene, result, scene->textures.decoding_seconds() - decoding_before);
  if (!arguments.measures_ray_limit) accelerator.reset();  // room for the encoders
  set_interrupt_mode(InterruptMode::Finish);
  {
    const Image image = result.film.to_image(arguments.is_transparent);
    for (const std::string& path : run.outputs())
      run.wrote(path, run.timed(&StageSeconds::write,
                                [&] { return write_image(path, image, run.write_options()); }));
  }
  return run.finish(*scene, accelerator);
}

ExitCode run_command(const RenderArguments& arguments) {
  ExitCode code = ExitCode::Bug;
  if (has(arguments.without, Saving::LargePages)) forbid_large_pages();
  const bool flushes = !has(arguments.without, Saving::FlushedDenormals);
  with_threads(
      arguments.threads, [&] { code = render_scene(arguments); },
      flushes ? Denormals::Flushed : Denormals::Kept);
  return code;
}
ExitCode run_command(const InfoArguments& arguments) {
  ExitCode code = ExitCode::Bug;
  with_threads(0, [&] { code = run_info(arguments); });  // compiles as render does
  return code;
}
ExitCode run_command(const CheckArguments& arguments) {
  require_threads(available_threads());
  return run_check(arguments);
}
ExitCode run_command(const CompareArguments& arguments) {
  return run_compare(arguments);
}
ExitCode run_command(const ConvertArguments& arguments) {
  require_threads(available_threads());
  return run_convert(arguments);
}
ExitCode run_command(const BenchArguments& arguments) {
  ExitCode code = ExitCode::Bug;
  with_threads(arguments.threads, [&] { code = run_bench(arguments); });
  return code;
}

ExitCode run(const std::vector<std::string>& words) {
  Console console(false);
  const ParsedArguments parsed = parse_arguments(words);
  if (!parsed.error.empty()) std::fputs(parsed.error.c_str(), stderr);
  if (!parsed.arguments) {
    const ExitCode printed = print_result(parsed.output, console);
    return parsed.exit_code == ExitCode::Done ? printed : parsed.exit_code;
  }
  return std::visit([](const auto& arguments) { return run_command(arguments); },
                    *parsed.arguments);
}

// Where standard streams are closed, no file that is opened shall take their places: messages would
// be written into pictures. What is written to them fails, as it does to closed ones.
void take_places_of_closed_streams() {
  int descriptor = -1;
  do {
    descriptor = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  ::close(descriptor);
}

}  // namespace
}  // namespace candela::cli

int main(int count, char** words) {
  candela::cli::take_places_of_closed_streams();
  candela::cli::install_signal_handlers();
  return static_cast<int>(candela::cli::guarded([&] {
    return candela::cli::run({words + std::min(count, 1), words + count});
  }));
}
