// What a render was asked, did and cost: the source of --stats and of the images' metadata.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/ray_limit/ray_limit.h"
#include "integrators/render_options.h"
#include "integrators/render_statistics.h"
#include "renderer/accel/any_accel.h"
#include "renderer/film/error_estimate.h"
#include "renderer/image/image_io.h"
#include "tools/candela/arguments.h"
#include "tools/candela/option_values.h"

namespace candela::cli {

struct StageSeconds {
  double load = 0;
  double compile = 0;
  double build = 0;
  double render = 0;
  double write = 0;
};

struct RenderReport {
  std::string command;  // the command line
  std::string scene;    // path, as given
  std::string scene_hash;
  RenderOptions options;
  AcceleratorKind accelerator = AcceleratorKind::Auto;
  bool is_robust = false;
  SavingSet without = 0;
  DisplayTransform display;
  int threads = 0;
  std::uint32_t min_samples = 0;  // a pixel; less than asked where the render was interrupted
  std::uint32_t max_samples = 0;
  double mean_samples = 0;
  std::uint32_t replicates = 1;  // that samples were dealt out to
  std::optional<ErrorEstimate> error;
  StageSeconds seconds;
  StageSeconds cpu_seconds;         // of all threads
  double decoding_cpu_seconds = 0;  // of images that rendering met first
  RenderStatistics statistics;
  std::size_t skipped_textures = 0;  // never decoded since no ray touched them
  std::uint64_t triangles = 0;
  std::uint64_t peak_memory_bytes = 0;
  std::vector<std::string> warnings;
  std::vector<std::string> outputs;
  std::optional<RayLimit> ray_limit;

  [[nodiscard]] PixelRect rect() const { return rendered_rect(options); }
  [[nodiscard]] bool is_interrupted() const { return statistics.stop == StopReason::Cancelled; }
  // --error or --time alone: as many as they need.
  [[nodiscard]] bool has_sample_limit() const {
    return options.samples_per_pixel < max_samples_per_pixel || !may_end_early(options);
  }
};

// The report integrator's own way is called light: its lamps are sampled, never met.
[[nodiscard]] std::string_view sampling_name(const RenderOptions& options);

// Which rule ended the render: "spp", "error", "time", or "interrupted".
[[nodiscard]] std::string_view stop_name(StopReason stop);

// What makes the picture's expectation differ from the scene's own answer, such as "clamp 10".
[[nodiscard]] std::vector<std::string> biases_of(const RenderOptions& options);
// And that it ended as soon as its own samples said so: such a picture has met less rare light than
// one whose samples are counted beforehand (docs/accuracy.md).
[[nodiscard]] std::vector<std::string> biases_of(const RenderReport& report);

// The process's largest resident memory so far (VmHWM); 0 where the system does not tell.
[[nodiscard]] std::uint64_t peak_memory_bytes();

// For image files: all but what is known only after they are written.
[[nodiscard]] Metadata metadata_of(const RenderReport& report);

}  // namespace candela::cli
