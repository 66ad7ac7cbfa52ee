#include "tools/candela/option_values.h"

#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/description/validate.h"

namespace candela::cli {
namespace {

using description::FresnelModel;
using description::GeometryModel;

constexpr Choice<IntegratorKind> integrators[] = {{"path", IntegratorKind::Path},
                                                  {"whitted", IntegratorKind::Whitted},
                                                  {"raster", IntegratorKind::Raster},
                                                  {"report", IntegratorKind::Report}};
constexpr Choice<SpecularModel> speculars[] = {{"blinn", SpecularModel::Blinn},
                                               {"phong", SpecularModel::Phong}};
constexpr Choice<SamplingStrategy> samplings[] = {
    {name_of(SamplingStrategy::Uniform), SamplingStrategy::Uniform},
    {name_of(SamplingStrategy::Cosine), SamplingStrategy::Cosine},
    {name_of(SamplingStrategy::Bsdf), SamplingStrategy::Bsdf},
    {name_of(SamplingStrategy::Light), SamplingStrategy::Light},
    {name_of(SamplingStrategy::Mis), SamplingStrategy::Mis}};
constexpr Choice<Heuristic> heuristics[] = {{"balance", Heuristic::Balance},
                                            {"power", Heuristic::Power}};
constexpr Choice<Guiding> guidings[] = {
    {"off", Guiding::Off}, {"auto", Guiding::Auto}, {"on", Guiding::On}};
constexpr Choice<SamplerKind> samplers[] = {{"sobol", SamplerKind::Sobol},
                                            {"padded", SamplerKind::Padded},
                                            {"independent", SamplerKind::Independent}};
constexpr Choice<LightSampling> light_samplings[] = {{"triangles", LightSampling::Triangles},
                                                     {"area", LightSampling::Area},
                                                     {"solid_angle", LightSampling::SolidAngle}};
constexpr Choice<FresnelModel> fresnels[] = {{"schlick", FresnelModel::Schlick},
                                             {"exact", FresnelModel::Exact}};
constexpr Choice<GeometryModel> geometries[] = {{"schlick_ggx", GeometryModel::SchlickGgx},
                                                {"smith", GeometryModel::Smith}};
constexpr Choice<FilterKind> filters[] = {{"box", FilterKind::Box},
                                          {"gaussian", FilterKind::Gaussian},
                                          {"blackman_harris", FilterKind::BlackmanHarris},
                                          {"triangle", FilterKind::Triangle},
                                          {"mitchell", FilterKind::Mitchell},
                                          {"sinc", FilterKind::Sinc}};
constexpr Choice<AcceleratorKind> accelerators[] = {{"auto", AcceleratorKind::Auto},
                                                    {"embree", AcceleratorKind::Embree},
                                                    {"bvh", AcceleratorKind::Bvh}};
constexpr Choice<ToneMap> tone_maps[] = {
    {"srgb", ToneMap::Srgb}, {"aces", ToneMap::Aces}, {"lab3", ToneMap::Lab3}};
constexpr Choice<Aov> aovs[] = {
    {"albedo", Aov::Albedo},     {"normal", Aov::Normal},          {"depth", Aov::Depth},
    {"position", Aov::Position}, {"material_id", Aov::MaterialId}, {"samples", Aov::Samples},
    {"variance", Aov::Variance}, {"interval", Aov::Interval},      {"heavy_tail", Aov::HeavyTail}};
constexpr Choice<Saving> savings[] = {{"packets", Saving::Packets},
                                      {"high-quality", Saving::HighQuality},
                                      {"flushing", Saving::FlushedDenormals},
                                      {"large-pages", Saving::LargePages},
                                      {"shared-blocks", Saving::SharedBlocks},
                                      {"convoys", Saving::Convoys},
                                      {"background", Saving::Background},
                                      {"opacity-grids", Saving::OpacityGrids}};
constexpr Choice<bool> switches[] = {{"on", true}, {"off", false}};
constexpr Choice<bool> kernels[] = {{"special", false}, {"general", true}};

template <class T>
std::optional<T> whole(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> finite(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::optional<double> value = whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool is_positive(double value) {
  return value > 0 && std::isnormal(value);
}

// The number that `number`, a part of `text`, is, in its unit; else what was expected of the text.
Result<double> number_in(std::string_view text, std::string_view number, bool (*is_good)(double),
                         std::string_view wanted, double unit = 1) {
  const std::optional<double> value = finite(number);
  if (!value || !is_good(*value) || !std::isfinite(*value * unit))
    return failure(fmt::format("expected {}, found '{}'", wanted, text));
  return *value * unit;
}

}  // namespace

std::span<const Choice<IntegratorKind>> integrator_choices() {
  return integrators;
}

std::string_view integrator_name(const RenderOptions& options) {
  return name_of(options.integrator, integrator_choices());
}
std::span<const Choice<SpecularModel>> specular_choices() {
  return speculars;
}
std::span<const Choice<SamplingStrategy>> sampling_choices() {
  return samplings;
}
std::span<const Choice<Heuristic>> heuristic_choices() {
  return heuristics;
}
std::span<const Choice<SamplerKind>> sampler_choices() {
  return samplers;
}
std::span<const Choice<Guiding>> guiding_choices() {
  return guidings;
}
std::span<const Choice<LightSampling>> light_sampling_choices() {
  return light_samplings;
}
std::span<const Choice<FresnelModel>> fresnel_choices() {
  return fresnels;
}
std::span<const Choice<GeometryModel>> geometry_choices() {
  return geometries;
}
std::span<const Choice<FilterKind>> filter_choices() {
  return filters;
}
std::span<const Choice<AcceleratorKind>> accelerator_choices() {
  return accelerators;
}
std::span<const Choice<bool>> kernel_choices() {
  return kernels;
}
std::span<const Choice<ToneMap>> tone_map_choices() {
  return tone_maps;
}
std::span<const Choice<Aov>> aov_choices() {
  return aovs;
}
std::span<const Choice<Saving>> saving_choices() {
  return savings;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string unknown_choice(std::string_view kind, std::string_view word,
                           const std::vector<std::string_view>& known) {
  const std::string guess = did_you_mean(word, known);
  return fmt::format("unknown {} '{}'{} Known: {}", kind, word, guess.empty() ? "." : guess,
                     fmt::join(known, ", "));
}

Result<std::int64_t> parse_integer(std::string_view text, std::int64_t low, std::int64_t high) {
  const std::optional<std::int64_t> value = whole<std::int64_t>(text);
  if (!value || *value < low || *value > high)
    return failure(
        fmt::format("expected a whole number from {} to {}, found '{}'", low, high, text));
  return std::int64_t(*value);
}

Result<std::uint64_t> parse_seed(std::string_view text) {
  const std::optional<std::uint64_t> value = whole<std::uint64_t>(text);
  if (!value)
    return failure(fmt::format("expected a whole number from 0 to 2^64-1, found '{}'", text));
  return std::uint64_t(*value);
}

Result<double> parse_number(std::string_view text) {
  return number_in(
      text, text, [](double) { return true; }, "a number");
}

Result<double> parse_non_negative_number(std::string_view text) {
  return number_in(
      text, text, [](double value) { return value >= 0; }, "a number of at least 0");
}

Result<double> parse_positive_number(std::string_view text) {
  return number_in(text, text, is_positive, "a number above 0");
}

Result<double> parse_positive_float(std::string_view text) {
  const auto is_float = [](double value) {
    return value > 0 && std::isnormal(static_cast<float>(value));
  };
  return number_in(text, text, is_float, "a number from 1.2e-38 to 3.4e38");
}

Result<double> parse_probability(std::string_view text) {
  const auto is_probability = [](double value) {
    return value > 0 && value <= 1 && std::isnormal(static_cast<float>(value));
  };
  return number_in(text, text, is_probability, "a number above 0 and up to 1");
}

Result<double> parse_error_goal(std::string_view text) {
  const bool is_percentage = text.ends_with('%');
  const Result<double> goal =
      number_in(text, text.substr(0, text.size() - (is_percentage ? 1 : 0)), is_positive,
                "an error above 0 such as 1% or 0.01", is_percentage ? 0.01 : 1);
  if (goal && !std::isnormal(*goal * *goal))
    return failure(
        fmt::format("expected an error of which the square is a number, found '{}'", text));
  return goal;
}

Result<double> parse_duration(std::string_view text) {
  double unit = 1;
  std::string_view number = text;
  for (const auto& [letter, seconds] : {std::pair{'s', 1.0}, {'m', 60.0}, {'h', 3600.0}})
    if (text.ends_with(letter)) {
      unit = seconds;
      number.remove_suffix(1);
    }
  return number_in(text, number, is_positive, "a time above 0 such as 60s, 5m or 1h", unit);
}

Result<Size> parse_size(std::string_view text) {
  const auto parts = split(text, 'x');
  const auto width = whole<int>(parts[0]);
  const auto height = whole<int>(parts.size() == 2 ? parts[1] : std::string_view());
  if (!width || !height)
    return failure(fmt::format("expected WIDTHxHEIGHT such as 640x480, found '{}'", text));
  if (*width < 1 || *height < 1 || *width > max_side || *height > max_side)
    return failure(fmt::format("each side must be 1 to {} pixels, found '{}'", max_side, text));
  return Size{*width, *height};
}

Result<PixelRect> parse_crop(std::string_view text) {
  const auto parts = split(text, ',');
  std::array<int, 4> edges{};
  bool is_whole = parts.size() == 4;
  for (std::size_t i = 0; is_whole && i < 4; ++i) {
    const auto edge = whole<int>(parts[i]);
    is_whole = edge.has_value();
    edges[i] = edge.value_or(0);
  }
  if (!is_whole)
    return failure(
        fmt::format("expected X0,Y0,X1,Y1 in pixels such as 0,0,64,64, found '{}'", text));
  const PixelRect crop{edges[0], edges[1], edges[2], edges[3]};
  if (crop.x0 < 0 || crop.y0 < 0 || crop.is_empty())
    return failure(fmt::format("expected 0 <= X0 < X1 and 0 <= Y0 < Y1, found '{}'", text));
  return PixelRect(crop);
}

Result<DepthLimit> parse_depth_limit(std::string_view text) {
  if (text == "none") return DepthLimit{};
  const auto depth = whole<int>(text);
  if (!depth || *depth < 0)
    return failure(fmt::format("expected a whole number from 0 to {} or 'none', found '{}'",
                               std::numeric_limits<int>::max(), text));
  return DepthLimit{depth};
}

Result<RouletteThreshold> parse_roulette(std::string_view text) {
  if (text == "auto") return RouletteThreshold{};
  const Result<double> threshold = parse_probability(text);
  if (!threshold || *threshold < min_roulette_threshold)
    return failure(fmt::format("expected a number from {} to 1 or 'auto', found '{}'",
                               min_roulette_threshold, text));
  return RouletteThreshold{*threshold};
}

Result<PathSharing> parse_path_sharing(std::string_view text) {
  if (text == "auto") return PathSharing{};
  const Result<bool> is_on = parse_switch(text);
  if (!is_on) return failure(fmt::format("expected 'on', 'off' or 'auto', found '{}'", text));
  return PathSharing{*is_on};
}

Result<Vec3d> parse_rgb(std::string_view text) {
  const auto parts = split(text, ',');
  Vec3d colour{0.0};
  bool is_colour = parts.size() == 3;
  for (std::size_t i = 0; is_colour && i < 3; ++i) {
    const auto value = finite(parts[i]);
    is_colour = value && *value >= 0 && *value <= description::largest_radiance;
    colour[static_cast<int>(i)] = value.value_or(0);
  }
  if (!is_colour)
    return failure(fmt::format(
        "expected three numbers R,G,B from 0 to 1e30 such as .1,.1,.1, found '{}'", text));
  return Vec3d(colour);
}

Result<AovSet> parse_aovs(std::string_view text) {
  return choose_set("layer", text, aov_choices(), aov_bit);
}

Result<SavingSet> parse_savings(std::string_view text) {
  return choose_set("saving", text, saving_choices(), saving_bit);
}

Result<bool> parse_switch(std::string_view text) {
  return choose("setting", text, std::span<const Choice<bool>>(switches));
}

}  // namespace candela::cli
