// What surrounds the five verbs of `candela render`: times, messages, interruption, reports.
// main.cpp calls its members in the order in which they stand here.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "integrators/render.h"
#include "renderer/base/result.h"
#include "renderer/base/thread_clock.h"
#include "renderer/description/scene_description.h"
#include "renderer/scene/scene.h"
#include "tools/candela/arguments.h"
#include "tools/candela/console.h"
#include "tools/candela/exit_code.h"
#include "tools/candela/progress_report.h"
#include "tools/candela/render_report.h"

namespace candela::cli {

class RenderRun {
 public:
  explicit RenderRun(const RenderArguments& arguments);

  // Adds the seconds that `verb` takes to a stage's.
  template <class Verb>
  auto timed(double StageSeconds::*stage, Verb verb) {
    const Stopwatch stopwatch{report_.seconds.*stage, report_.cpu_seconds.*stage};
    return verb();
  }

  // Whether to go on; exit_code() otherwise.
  [[nodiscard]] bool outputs_are_writable();
  template <class T>
  [[nodiscard]] bool accepts(const Result<T>& result) {
    return accepts(result.diagnostics, result.value.has_value());
  }
  [[nodiscard]] bool settles(const description::SceneDescription& description);
  [[nodiscard]] bool accepts_scene(const Scene& scene);

  [[nodiscard]] const RenderOptions& options() const { return report_.options; }
  // From here on a signal stops the render and not the process.
  [[nodiscard]] ProgressSink* start_rendering(const Scene& scene);
  // `decoding`: the CPU seconds of it that went into images.
  void rendered(const Scene& scene, const RenderResult& result, double decoding);

  // The files to write; none where not one sample was taken.
  [[nodiscard]] std::vector<std::string> outputs() const;
  [[nodiscard]] WriteOptions write_options() const;
  void wrote(const std::string& path, const Diagnostics& problems);

  // Says how it went, writes --stats.
  [[nodiscard]] ExitCode finish(const Scene& scene,
                                const std::optional<AnyAccelerator>& accelerator);
  [[nodiscard]] ExitCode exit_code() const { return exit_code_; }

 private:
  struct Stopwatch {
    double& seconds;
    double& cpu_seconds;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    double cpu_start = process_cpu_seconds();
    ~Stopwatch() {
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      cpu_seconds += process_cpu_seconds() - cpu_start;
    }
  };

  [[nodiscard]] bool accepts(const Diagnostics& diagnostics, bool has_value);
  // Whether so many warnings, of what is known before rendering, let it go on.
  [[nodiscard]] bool allows(std::size_t warnings);
  [[nodiscard]] bool stop(ExitCode code);
  void fail(ExitCode code);
  void warn(const std::string& sentence);
  void record(const Diagnostics& diagnostics);
  // Of those that do nothing, or harm.
  [[nodiscard]] std::vector<std::string> warnings_of_options(
      const description::SceneDescription& description) const;
  void report_invalid_samples();
  void report_reliability();
  void report_samples();
  void measure_ray_limit(const Scene& scene, const AnyAccelerator& accelerator);
  [[nodiscard]] std::vector<std::string> all_paths() const;
  void write_stats();

  const RenderArguments& arguments_;
  Console console_;
  RenderReport report_;
  std::unique_ptr<ProgressReport> progress_;
  ExitCode exit_code_ = ExitCode::Done;
};

}  // namespace candela::cli
