#include "tools/candela/parse_arguments.h"

#include <algorithm>

#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "renderer/base/printable.h"
#include "tools/candela/option_values.h"
#include "tools/candela/quoted_command_line.h"

namespace candela::cli {
namespace {

std::string joined_names(const auto& choices) {
  std::string text;
  for (const auto& choice : choices) text += (text.empty() ? "" : "|") + std::string(choice.name);
  return text;
}

// An option with a value that `parse` turns into a Result; the last one given counts.
template <class Target, class Parse>
void add_value(CLI::App& command, const std::string& names, const std::string& type, Target& target,
               Parse parse, const std::string& help) {
  const std::string name = names.substr(names.find("--"));
  command
      .add_option_function<std::string>(
          names,
          [name, &target, parse](const std::string& text) {
            auto value = parse(text);
            if (!value) throw CLI::ValidationError(name, value.diagnostics.list()[0].message);
            target = static_cast<Target>(*value);
          },
          help)
      ->type_name(type)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

template <class Target, class T>
void add_choice(CLI::App& command, const std::string& names, const std::string& kind,
                Target& target, std::span<const Choice<T>> choices, const std::string& help) {
  add_value(
      command, names, joined_names(choices), target,
      [kind, choices](const std::string& text) { return choose(kind, text, choices); }, help);
}

// On where it is given; takes no value.
void add_flag(CLI::App& command, const std::string& names, bool& target, const std::string& help) {
  command.add_flag(names, target, help)->disable_flag_override();
}

auto integer_between(std::int64_t low, std::int64_t high) {
  return [low, high](const std::string& text) { return parse_integer(text, low, high); };
}

void add_scene(CLI::App& command, SceneArguments& scene) {
  command.add_option("SCENE", scene.path, "The scene file")->required()->type_name("");
}

// A file's name; the last one counts.
void add_path(CLI::App& command, const std::string& name, const std::string& type,
              std::optional<std::string>& path, const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&path](const std::string& given) { path = given; }, help)
      ->type_name(type)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void add_camera(CLI::App& command, std::size_t& camera) {
  add_value(command, "--camera", "N", camera, integer_between(0, 1'000'000),
            "The scene's N-th camera, from 0 [0]");
}

void add_reading(CLI::App& command, SceneArguments& scene) {
  add_value(
      command, "--materials", "lab|mtl", scene.load.use_mtl_materials,
      [](const std::string& text) {
        static constexpr Choice<bool> kinds[] = {{"lab", false}, {"mtl", true}};
        return choose("kind of materials", text, std::span<const Choice<bool>>(kinds));
      },
      "What of an OBJ's MTL file counts: what the lab reads, or all of it [lab]");
  add_path(command, "--lab3-ground", "IMAGE", scene.load.lab3_ground,
           "Add the textured ground plane that the lab adds to sports_car and white_oak");
  add_value(command, "--ambient", "R,G,B", scene.load.ambient, parse_rgb,
            "Radiance of the constant environment in place of the scene's AmbientIntensity");
  add_flag(command, "--strict", scene.is_strict, "Treat warnings as errors (exit 3)");
}

void add_threads(CLI::App& command, int& threads) {
  add_value(command, "-t,--threads", "N", threads, integer_between(1, 4096),
            "Threads to use [all processors]");
}

void add_json(CLI::App& command, bool& as_json) {
  add_flag(command, "--json", as_json, "Print JSON");
}

void add_render_outputs(CLI::App& command, RenderArguments& render) {
  command
      .add_option("-o,--output", render.outputs,
                  "Image to write, by extension: exr png jpg hdr tif; may be given several "
                  "times [SCENE-stem.exr in the current folder]")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_path(command, "--stats", "FILE.json", render.stats_path,
           "Write what was done, how long it took and what it cost as JSON");
  add_value(command, "--exposure", "STOPS", render.exposure, parse_number,
            "Multiply by 2^STOPS in 8-bit outputs [the scene's, else 0]");
  add_choice(command, "--tonemap", "tone map", render.tone_map, tone_map_choices(),
             "How radiance becomes 8 bits [srgb]");
  add_value(command, "--aov", "LIST", render.aovs, parse_aovs,
            "Further EXR layers, by comma: " + joined_names(aov_choices()));
  add_flag(command, "--transparent", render.is_transparent, "Alpha in place of the background");
  add_flag(command, "-q,--quiet", render.is_quiet, "Print warnings and errors only");
}

// When a render stops, and how samples are dealt out.
void add_render_samples(CLI::App& command, RenderArguments& render) {
  add_choice(command, "--integrator", "integrator", render.integrator, integrator_choices(),
             "How light is followed [the scene's, else path]");
  add_value(command, "--spp", "N", render.samples_per_pixel,
            integer_between(1, max_samples_per_pixel),
            "Stop at so many samples a pixel; a square number for whitted and raster [the scene's, "
            "else 64, or 16 for whitted and raster; no limit where another rule is given]");
  add_value(command, "--error", "E", render.error_goal, parse_error_goal,
            "Stop when the stated rMSE is safely below E, such as 1%");
  add_value(command, "--relmse", "E", render.relmse_goal, parse_positive_number,
            "Stop when the stated relMSE is safely below E, such as 1e-4");
  add_value(command, "--time", "T", render.time_limit_seconds, parse_duration,
            "Stop rendering after this time, such as 60s, 5m or 1h");
  add_value(command, "--replicates", "R", render.replicates, integer_between(1, max_replicates),
            "Independent sequences a pixel, from which the error is stated; 1 states none [4]");
  add_value(command, "--adaptive", "on|off", render.adaptive, parse_switch,
            "Deal out samples by a pilot: --spp is then the mean [on; off with --replicates 1]");
}

void add_render_paths(CLI::App& command, RenderArguments& render) {
  add_value(command, "--splitting", "N", render.splitting,
            integer_between(1, static_cast<int>(max_splitting)),
            "Paths that go on from the first hit of a camera ray [1]");
  add_value(command, "--reuse", "on|off|auto", render.reuses_paths, parse_path_sharing,
            "Pixels share what their paths find behind first hits: less noise of indirect light, "
            "which then is not independent from pixel to pixel; auto: where a trial says that it "
            "pays [auto]");
  add_value(
      command, "--roulette", "X|auto", render.roulette, parse_roulette,
      "Throughput from which on no path is ended at random; auto: what some paths tell [auto]");
  add_choice(command, "--guiding", "guiding", render.guiding, guiding_choices(),
             "Whether paths follow what others learned of the light; auto: where a trial says that "
             "it pays [off]");
  add_value(command, "--clamp", "X", render.clamp, parse_positive_float,
            "Dim samples to X in their largest channel: less noise, less light (biased)");
}

void add_render_view(CLI::App& command, RenderArguments& render) {
  add_value(command, "--size", "WxH", render.size, parse_size,
            "Pixels [the scene's, else 512x512]");
  add_value(command, "--scale", "F", render.scale, parse_positive_number, "Multiply the size by F");
  add_camera(command, render.camera);
  add_value(command, "--crop", "X0,Y0,X1,Y1", render.crop, parse_crop,
            "Render these pixels only, the same bits as in the whole picture");
  add_value(command, "--max-depth", "N|none", render.max_depth, parse_depth_limit,
            "Longest path in bounces: 0 sees lights only, 1 direct light [the scene's, else none]; "
            "for whitted surfaces that a ray may meet [the scene's, else 5]");
}

void add_render_sampling(CLI::App& command, RenderArguments& render) {
  add_choice(command, "--sampling", "strategy", render.sampling, sampling_choices(),
             "How path finds light, for comparisons: light samples and directions weighted (mis), "
             "one of them alone, or light samples with plain directions; report takes light, "
             "cosine, uniform [mis; report: light]");
  add_choice(command, "--heuristic", "heuristic", render.heuristic, heuristic_choices(),
             "How mis weights [power]");
  add_choice(
      command, "--sampler", "sampler", render.sampler, sampler_choices(),
      "Scrambled Sobol points or, for comparisons, such whose pairs are shuffled each by itself "
      "(padded), or plain random numbers (independent) [sobol]");
  add_value(command, "--sky-samples", "on|off", render.samples_constant_sky, parse_switch,
            "Light samples for a constant environment, which BSDF samples find as well [off]");
  add_value(command, "--sky-compensation", "on|off", render.compensates_sky, parse_switch,
            "With mis: light samples leave to BSDF samples the dim parts of an environment [on]");
  add_value(command, "--lamp-rays", "N", render.lamp_rays, integer_between(0, max_lamp_rays),
            "Camera rays a sample that look for lamps alone in pixels that lamps cover in part, at "
            "most [8]");
  add_choice(command, "--light-sampling", "light sampling", render.light_sampling,
             light_sampling_choices(),
             "Where on lamps: triangles apart by area, two that are one parallelogram as a quad, "
             "near lamps by solid angle [area]");
  add_value(command, "--light-cells", "on|off", render.light_cells, parse_switch,
            "Picks among many lights by where it is asked for one, not by power alone [on]");
}

void add_render_shading(CLI::App& command, RenderArguments& render) {
  add_choice(command, "--fresnel", "Fresnel term", render.scene.load.fresnel, fresnel_choices(),
             "Of all cook_torrance materials [the scene's]");
  add_choice(command, "--geometry", "geometry term", render.scene.load.geometry, geometry_choices(),
             "Of all cook_torrance materials [the scene's]");
  add_choice(command, "--specular", "highlight", render.specular, specular_choices(),
             "How whitted and raster shade highlights [blinn]");
  add_flag(command, "--lab-normals", render.has_lab_normals,
           "whitted and raster: normals as the lab interpolates them, neither made unit "
           "nor turned to the viewer");
  add_value(command, "--rr", "P", render.report_p_rr, parse_probability,
            "With the report integrator: the probability to go on, above 0 up to 1 [0.8]");
  add_choice(command, "--filter", "filter", render.filter, filter_choices(),
             "Pixel filter [the scene's, else blackman_harris; whitted and raster: box]");
  add_value(command, "--seed", "N", render.seed, parse_seed,
            "Another seed, another noise [the scene's, else 0]");
}

void add_render_machinery(CLI::App& command, RenderArguments& render) {
  add_threads(command, render.threads);
  add_choice(
      command, "--accel", "accelerator", render.accelerator, accelerator_choices(),
      "Who traces rays: Embree, in scenes of few triangles mostly a list of their faces; Embree "
      "alone; the reference BVH [auto]");
  add_value(command, "--robust", "on|off", render.embree.robust, parse_switch,
            "Embree's robust mode: watertight, a little slower [on]");
  add_choice(
      command, "--kernel", "kernel", render.uses_general_kernel, kernel_choices(),
      "With path: the instance for what the scene needs, or the one for all scenes: the same "
      "bits [special]");
  add_value(command, "--without", "LIST", render.without, parse_savings,
            "Savings taken away, for comparisons, by comma: " + joined_names(saving_choices()));
  add_flag(command, "--ray-limit", render.measures_ray_limit,
           "Also measure CPU time over that of the rays alone");
}

struct CommandLine {
  RenderArguments render;
  InfoArguments info;
  CheckArguments check;
  CompareArguments compare;
  ConvertArguments convert;
  BenchArguments bench;
  CLI::App app{"candela renders scenes by path tracing.", "candela"};

  CommandLine() {
    app.require_subcommand(1);
    app.set_version_flag("--version", "candela " CANDELA_VERSION, "Print the version and exit");
    app.footer("candela COMMAND --help lists the options of a command.");
    add_render();
    add_info();
    add_check();
    add_compare();
    add_convert();
    add_bench();
    for (CLI::App* command : app.get_subcommands({}))
      command->set_version_flag("--version", "candela " CANDELA_VERSION,
                                "Print the version and exit");
  }

  void add_render() {
    CLI::App& command = *app.add_subcommand("render", "Render a scene to image files");
    add_scene(command, render.scene);
    add_render_outputs(command, render);
    add_render_samples(command, render);
    add_render_paths(command, render);
    add_render_view(command, render);
    add_render_sampling(command, render);
    add_render_shading(command, render);
    add_render_machinery(command, render);
    add_reading(command, render.scene);
  }

  void add_info() {
    CLI::App& command = *app.add_subcommand("info", "Tell what is in a scene");
    add_scene(command, info.scene);
    add_choice(command, "--accel", "accelerator", info.accelerator, accelerator_choices(),
               "Also build this accelerator and tell its memory");
    add_json(command, info.as_json);
    add_reading(command, info.scene);
  }

  void add_check() {
    CLI::App& command = *app.add_subcommand("check", "Find all problems of a scene at once");
    add_scene(command, check.scene);
    add_reading(command, check.scene);
  }

  void add_compare() {
    CLI::App& command = *app.add_subcommand("compare", "Measure an image against a reference");
    command.add_option("IMAGE", compare.image, "The image")->required()->type_name("");
    command.add_option("REFERENCE", compare.reference, "What it should be")
        ->required()
        ->type_name("");
    add_path(command, "--heatmap", "FILE.png", compare.heatmap,
             "Write a picture of where the error is");
    add_value(command, "--max-relmse", "X", compare.max_relmse, parse_non_negative_number,
              "Exit with 6 where relMSE is above X");
    add_json(command, compare.as_json);
  }

  void add_convert() {
    CLI::App& command = *app.add_subcommand("convert", "Write a scene as a pbrt-v4 file");
    add_scene(command, convert.scene);
    command.add_option("OUT", convert.output, "The file to write, with the ending .pbrt")
        ->required()
        ->type_name("");
    add_camera(command, convert.camera);
    add_reading(command, convert.scene);
  }

  void add_bench() {
    CLI::App& command = *app.add_subcommand(
        "bench", "Measure Embree against the reference BVH on a scene, and random numbers");
    add_scene(command, bench.scene);
    add_threads(command, bench.threads);
    add_value(command, "--seconds", "S", bench.seconds_each, parse_positive_number,
              "Measure each kind of rays for so long [0.5]");
    add_json(command, bench.as_json);
    add_reading(command, bench.scene);
  }

  [[nodiscard]] Arguments chosen() const {
    if (app.got_subcommand("render")) return render;
    if (app.got_subcommand("info")) return info;
    if (app.got_subcommand("check")) return check;
    if (app.got_subcommand("compare")) return compare;
    if (app.got_subcommand("convert")) return convert;
    return bench;
  }
};

const CLI::App& selected(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

// The words of the command line that nobody took, as one sentence about the first of them.
std::string unexpected_word(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  const std::string word = words.empty() ? "" : words.front();
  if (!word.starts_with('-')) return fmt::format("unexpected '{}'", word);
  const std::string name = word.substr(0, word.find('='));
  if (selected(app).get_option_no_throw(name) != nullptr)
    return fmt::format("'{}' stands before the command; its options come behind it", name);
  std::vector<std::string> names;
  for (const CLI::Option* option : selected(app).get_options())
    for (const std::string& long_name : option->get_lnames()) names.push_back("--" + long_name);
  return fmt::format("unknown option '{}'{}", name,
                     did_you_mean(name, {names.begin(), names.end()}));
}

std::string sentence_of(const CLI::ParseError& error, const CLI::App& app) {
  const std::string text = error.what();
  // Before what is missing: a misspelt option is why.
  if (app.remaining_size(true) > 0) return unexpected_word(app);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    const std::size_t colon = text.find(':');  // behind the name, but not of a flag with a value
    if (colon == std::string::npos)
      return fmt::format("--{} takes no value", text.substr(0, text.find(' ')));
    return text.substr(0, colon) + " needs a value";
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) && app.get_subcommands().empty())
    return fmt::format("expected a command: {}", fmt::join(command_names(), ", "));
  if (dynamic_cast<const CLI::RequiredError*>(&error))
    return text.substr(0, text.find(' ')) + " is missing";
  return text;
}

ParsedArguments usage_error(const std::string& command, const std::string& sentence) {
  const std::string program = command.empty() ? "candela" : "candela " + command;
  return {{},
          "",
          fmt::format("{}: {}\n'{} --help' lists what it takes.\n", program, printable(sentence),
                      program),
          ExitCode::Usage};
}

}  // namespace

std::vector<std::string_view> command_names() {
  return {"render", "info", "check", "compare", "convert", "bench"};
}

ParsedArguments parse_arguments(const std::vector<std::string>& words) {
  if (!words.empty() && !words[0].starts_with('-')) {
    const auto names = command_names();
    if (std::find(names.begin(), names.end(), words[0]) == names.end())
      return usage_error("", unknown_choice("command", words[0], names));
  }
  CommandLine line;
  try {
    line.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return {{}, line.app.help(), "", ExitCode::Done};
  } catch (const CLI::CallForVersion& version) {
    return {{}, std::string(version.what()) + "\n", "", ExitCode::Done};
  } catch (const CLI::ParseError& error) {
    const CLI::App& command = selected(line.app);
    return usage_error(&command == &line.app ? "" : command.get_name(),
                       sentence_of(error, line.app));
  }
  line.render.command_line = quoted_command_line(words);
  return {line.chosen(), "", "", ExitCode::Done};
}

}  // namespace candela::cli
