// The texts of option values -> values. A failure is half a sentence that follows "--option: ".
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "renderer/base/result.h"
#include "tools/candela/arguments.h"

namespace candela::cli {

// A name that users write and what it stands for.
template <class T>
struct Choice {
  std::string_view name;
  T value;
};

[[nodiscard]] std::span<const Choice<IntegratorKind>> integrator_choices();
[[nodiscard]] std::string_view integrator_name(const RenderOptions& options);
[[nodiscard]] std::span<const Choice<SpecularModel>> specular_choices();
[[nodiscard]] std::span<const Choice<SamplingStrategy>> sampling_choices();
[[nodiscard]] std::span<const Choice<Heuristic>> heuristic_choices();
[[nodiscard]] std::span<const Choice<SamplerKind>> sampler_choices();
[[nodiscard]] std::span<const Choice<Guiding>> guiding_choices();
[[nodiscard]] std::span<const Choice<LightSampling>> light_sampling_choices();
[[nodiscard]] std::span<const Choice<description::FresnelModel>> fresnel_choices();
[[nodiscard]] std::span<const Choice<description::GeometryModel>> geometry_choices();
[[nodiscard]] std::span<const Choice<FilterKind>> filter_choices();
[[nodiscard]] std::span<const Choice<AcceleratorKind>> accelerator_choices();
[[nodiscard]] std::span<const Choice<bool>> kernel_choices();  // is it the general one?
[[nodiscard]] std::span<const Choice<ToneMap>> tone_map_choices();
[[nodiscard]] std::span<const Choice<Aov>> aov_choices();
[[nodiscard]] std::span<const Choice<Saving>> saving_choices();

// The parts between separators, one at least.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

// "unknown integrator 'pth', did you mean 'path'? Known: path".
[[nodiscard]] std::string unknown_choice(std::string_view kind, std::string_view word,
                                         const std::vector<std::string_view>& known);

template <class T>
[[nodiscard]] Result<T> choose(std::string_view kind, std::string_view word,
                               std::span<const Choice<T>> choices) {
  std::vector<std::string_view> known;
  for (const Choice<T>& choice : choices) {
    if (choice.name == word) return T(choice.value);
    known.push_back(choice.name);
  }
  return failure(unknown_choice(kind, word, known));
}

template <class T>
[[nodiscard]] std::string_view name_of(T value, std::span<const Choice<T>> choices) {
  for (const Choice<T>& choice : choices)
    if (choice.value == value) return choice.name;
  return "";
}

// "albedo,normal": the bits of the named values, bit_of(value) each.
template <class T>
[[nodiscard]] Result<std::uint32_t> choose_set(std::string_view kind, std::string_view text,
                                               std::span<const Choice<T>> choices, auto bit_of) {
  std::uint32_t set = 0;
  for (const std::string_view name : split(text, ',')) {
    const Result<T> value = choose(kind, name, choices);
    if (!value) return Diagnostics(value.diagnostics);
    set |= bit_of(*value);
  }
  return std::uint32_t(set);
}

// A whole number within [low, high].
[[nodiscard]] Result<std::int64_t> parse_integer(std::string_view text, std::int64_t low,
                                                 std::int64_t high);
[[nodiscard]] Result<std::uint64_t> parse_seed(std::string_view text);
// A finite number.
[[nodiscard]] Result<double> parse_number(std::string_view text);
[[nodiscard]] Result<double> parse_non_negative_number(std::string_view text);
[[nodiscard]] Result<double> parse_positive_number(std::string_view text);
// That a float can hold.
[[nodiscard]] Result<double> parse_positive_float(std::string_view text);
// Above 0 and up to 1.
[[nodiscard]] Result<double> parse_probability(std::string_view text);
// "1%" or "0.01".
[[nodiscard]] Result<double> parse_error_goal(std::string_view text);
// "90", "90s", "1.5m", "1h": seconds.
[[nodiscard]] Result<double> parse_duration(std::string_view text);
// "640x480", each side 1..max_side.
[[nodiscard]] Result<Size> parse_size(std::string_view text);
// "X0,Y0,X1,Y1", half-open, not empty, not negative.
[[nodiscard]] Result<PixelRect> parse_crop(std::string_view text);
// "5" or "none".
[[nodiscard]] Result<DepthLimit> parse_depth_limit(std::string_view text);
[[nodiscard]] Result<RouletteThreshold> parse_roulette(std::string_view text);
[[nodiscard]] Result<PathSharing> parse_path_sharing(std::string_view text);
// "R,G,B", non-negative.
[[nodiscard]] Result<Vec3d> parse_rgb(std::string_view text);
// "albedo,normal".
[[nodiscard]] Result<AovSet> parse_aovs(std::string_view text);
// "packets,convoys".
[[nodiscard]] Result<SavingSet> parse_savings(std::string_view text);
// "on" or "off".
[[nodiscard]] Result<bool> parse_switch(std::string_view text);

inline constexpr double min_roulette_threshold = 1e-6;

}  // namespace candela::cli
