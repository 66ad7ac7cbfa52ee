// What the command line asks for, as plain structs: parse_arguments fills them, commands read them.
// An empty optional means "not said": the scene's own default counts, then the program's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "integrators/render_options.h"
#include "renderer/accel/any_accel.h"
#include "renderer/image/image_io.h"
#include "scene_io/load_options.h"
#include "tools/candela/savings.h"

namespace candela::cli {

struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

// --max-depth: `none` is said, too.
struct DepthLimit {
  std::optional<int> depth;
  friend bool operator==(const DepthLimit&, const DepthLimit&) = default;
};

// --roulette: `auto` is said, too.
struct RouletteThreshold {
  std::optional<double> threshold;
  friend bool operator==(const RouletteThreshold&, const RouletteThreshold&) = default;
};

// --reuse: none: `auto`.
struct PathSharing {
  std::optional<bool> is_on;
  friend bool operator==(const PathSharing&, const PathSharing&) = default;
};

// What every command that reads a scene takes.
struct SceneArguments {
  std::string path;
  LoadOptions load;
  bool is_strict = false;  // warnings become errors
};

struct RenderArguments {
  SceneArguments scene;
  std::vector<std::string> outputs;  // empty: SCENE-stem.exr in the current folder
  std::optional<std::string> stats_path;
  std::optional<IntegratorKind> integrator;
  std::optional<int> samples_per_pixel;
  std::optional<double> error_goal;  // rMSE
  std::optional<double> relmse_goal;
  std::optional<double> time_limit_seconds;
  std::optional<int> replicates;
  std::optional<bool> adaptive;
  std::optional<int> splitting;
  std::optional<PathSharing> reuses_paths;
  std::optional<RouletteThreshold> roulette;
  std::optional<Guiding> guiding;
  std::optional<double> clamp;
  std::optional<Size> size;
  double scale = 1.0;  // of the size
  std::size_t camera = 0;
  std::optional<PixelRect> crop;
  std::optional<DepthLimit> max_depth;
  std::optional<SamplingStrategy> sampling;
  std::optional<Heuristic> heuristic;
  std::optional<SamplerKind> sampler;
  std::optional<bool> samples_constant_sky;
  std::optional<bool> compensates_sky;
  std::optional<int> lamp_rays;
  std::optional<LightSampling> light_sampling;
  std::optional<bool> light_cells;
  std::optional<SpecularModel> specular;
  bool has_lab_normals = false;
  std::optional<double> report_p_rr;
  std::optional<std::uint64_t> seed;
  int threads = 0;  // 0: as many as there are
  AcceleratorKind accelerator = AcceleratorKind::Auto;
  EmbreeOptions embree;
  bool uses_general_kernel = false;
  SavingSet without = 0;
  std::optional<FilterKind> filter;
  std::optional<double> exposure;
  ToneMap tone_map = ToneMap::Srgb;
  AovSet aovs = 0;
  bool is_transparent = false;
  bool measures_ray_limit = false;
  bool is_quiet = false;
  std::string command_line;  // as typed, for outputs that tell how they were made
};

struct InfoArguments {
  SceneArguments scene;
  std::optional<AcceleratorKind> accelerator;  // built only when asked for
  bool as_json = false;
};

struct CheckArguments {
  SceneArguments scene;
};

struct CompareArguments {
  std::string image;
  std::string reference;
  std::optional<std::string> heatmap;
  std::optional<double> max_relmse;
  bool as_json = false;
};

struct ConvertArguments {
  SceneArguments scene;
  std::string output;  // .pbrt
  std::size_t camera = 0;
};

struct BenchArguments {
  SceneArguments scene;
  double seconds_each = 0.5;  // for each kind of rays
  int threads = 0;
  bool as_json = false;
};

using Arguments = std::variant<RenderArguments, InfoArguments, CheckArguments, CompareArguments,
                               ConvertArguments, BenchArguments>;

}  // namespace candela::cli
