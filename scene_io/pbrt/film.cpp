// Film, PixelFilter, Sampler and Integrator.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene_io/pbrt/camera.h"

namespace candela::pbrt {
namespace {

constexpr std::int64_t largest_side = 65536;
constexpr std::int64_t most_samples = std::int64_t{1} << 30;
constexpr std::int64_t deepest = 1000000;

// Within limits; nothing after an error.
std::optional<int> integer(Arguments& arguments, std::string_view name, std::int64_t low,
                           std::int64_t high) {
  const auto number = arguments.integer(name);
  if (!number) return std::nullopt;
  if (*number >= low && *number <= high) return static_cast<int>(*number);
  arguments.error(*arguments.find(name),
                  fmt::format("is {}, expected {} to {}", *number, low, high));
  return std::nullopt;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// pbrt's exposure time is that of the camera's shutter.
double exposure_time(Context& context) {
  if (!context.program.camera) return 1;
  Arguments camera(*context.program.camera, context.report);
  const double time =
      camera.number("shutterclose").value_or(1) - camera.number("shutteropen").value_or(0);
  return time > 0 ? time : 1;
}

double read_exposure(Context& context, Arguments& film) {
  double ratio = film.number("iso").value_or(100) / 100;
  ratio *= film.number("exposuretime").value_or(exposure_time(context));
  film.ignore("maxcomponentvalue", "radiance is not clamped");
  const Parameter* sensor = film.find("sensor", {ParameterType::String});
  const bool is_plain = !sensor || sensor->strings.size() != 1 || sensor->strings[0] == "cie1931";
  if (!is_plain)
    film.warning(*sensor, "is not supported: the film is that of the CIE 1931 observer");
  const Parameter* balance = film.find("whitebalance", {ParameterType::Float});
  if (balance && is_plain && balance->numbers.size() == 1 && balance->numbers[0] != 0)
    film.warning(*balance, "is ignored: colours are not balanced");
  if (ratio > 0 && ratio < 1e30) return ratio;
  context.report.error(film.statement().place,
                       fmt::format("the film multiplies light by {}, expected above 0", ratio));
  return 1;
}

double read_picture(Context& context) {
  Statement otherwise{"Film", "rgb", {}, {}};
  Statement& statement = context.program.film ? *context.program.film : otherwise;
  Arguments film(statement, context.report);
  if (!is_one_of(statement.type, {"rgb", "image", "gbuffer", "spectral"}))
    context.report.error(statement.place,
                         fmt::format("{} is no film, expected rgb", text::quoted(statement.type)));
  if (is_one_of(statement.type, {"gbuffer", "spectral"}))
    context.warn_once("film", statement.place,
                      fmt::format("films of type {} are not supported: the picture is rgb",
                                  text::quoted(statement.type)));
  context.scene.defaults.width = integer(film, "xresolution", 1, largest_side).value_or(1280);
  context.scene.defaults.height = integer(film, "yresolution", 1, largest_side).value_or(720);
  film.accept({"filename", "diagonal", "savefp16", "coordinatesystem", "nbuckets", "lambdamin",
               "lambdamax", "scale", "maxsampleluminance"});
  film.ignore("cropwindow", "use --crop");
  film.ignore("pixelbounds", "use --crop");
  const double ratio = read_exposure(context, film);
  film.warn_of_unknown();
  return ratio;
}

struct KnownFilter {
  std::string_view name;
  double radius;
};
constexpr KnownFilter filters[] = {{"box", 0.5}, {"gaussian", 1.5}, {"triangle", 2}};

void read_filter(Context& context) {
  Statement otherwise{"PixelFilter", "gaussian", {}, {}};
  Statement& statement = context.program.filter ? *context.program.filter : otherwise;
  Arguments arguments(statement, context.report);
  const auto* known = std::find_if(std::begin(filters), std::end(filters), [&](const auto& filter) {
    return filter.name == statement.type;
  });
  const auto x = arguments.number("xradius");
  const auto y = arguments.number("yradius");
  arguments.accept({"B", "C", "tau", "alpha"});
  const double sigma = arguments.number("sigma").value_or(0.5);
  if (statement.type == "gaussian" && sigma != 0.5)
    context.warn_once("sigma", statement.place, "the gaussian filter's sigma is 0.5 here");
  arguments.warn_of_unknown();
  if (known == std::end(filters)) {
    const bool is_pbrt = is_one_of(statement.type, {"mitchell", "sinc"});
    if (!is_pbrt)
      return context.report.error(statement.place,
                                  fmt::format("{} is no filter, expected box, gaussian, triangle, "
                                              "mitchell or sinc",
                                              text::quoted(statement.type)));
    context.warn_once("filter", statement.place,
                      fmt::format("the filter {} has negative parts, which are not supported: "
                                  "blackman_harris is used",
                                  text::quoted(statement.type)));
    context.scene.defaults.filter = "blackman_harris";
    return;
  }
  context.scene.defaults.filter = std::string(known->name);
  const double radius = x.value_or(known->radius);
  if (!(radius > 0 && radius <= 16))
    return context.report.error(statement.place,
                                fmt::format("the filter's radius is {}, expected above 0 and at "
                                            "most 16",
                                            radius));
  context.scene.defaults.filter_radius = radius;
  if (y && *y != radius)
    context.warn_once("yradius", statement.place, "filters are square: the xradius is used");
}

void read_sampler(Context& context) {
  auto& defaults = context.scene.defaults;
  defaults.samples_per_pixel = 16;
  if (!context.program.sampler) return;
  Arguments sampler(*context.program.sampler, context.report);
  const auto count = integer(sampler, "pixelsamples", 1, most_samples);
  const int x = integer(sampler, "xsamples", 1, 32768).value_or(4);
  const int y = integer(sampler, "ysamples", 1, 32768).value_or(4);
  const bool is_stratified = sampler.statement().type == "stratified";
  defaults.samples_per_pixel = count.value_or(is_stratified ? x * y : 16);
  const auto seed = sampler.integer("seed");
  if (seed && *seed >= 0) defaults.seed = static_cast<std::uint64_t>(*seed);
  sampler.accept({"randomization", "jitter", "dimensions"});
  sampler.warn_of_unknown();
}

// candela has its own way to transport light for all of pbrt's.
void read_integrator(Context& context) {
  auto& defaults = context.scene.defaults;
  defaults.integrator = "path";
  defaults.max_depth = 5;
  if (!context.program.integrator) return;
  Statement& statement = *context.program.integrator;
  Arguments integrator(statement, context.report);
  defaults.max_depth = integer(integrator, "maxdepth", 0, deepest).value_or(5);
  if (!is_one_of(statement.type, {"path", "volpath"}))
    context.warn_once(
        "integrator", statement.place,
        fmt::format("the integrator {} is rendered by 'path'", text::quoted(statement.type)));
  for (Parameter& parameter : statement.parameters)
    if (statement.type != "path" && statement.type != "volpath") parameter.is_used = true;
  integrator.accept({"lightsampler", "lightsamplestrategy", "rrthreshold"});
  if (integrator.flag("regularize", false))
    integrator.warning(*integrator.find("regularize"), "is ignored: paths are not regularized");
  integrator.ignore("pixelbounds", "use --crop");
  integrator.warn_of_unknown();
}

}  // namespace

double read_film(Context& context) {
  const double ratio = read_picture(context);
  read_filter(context);
  read_sampler(context);
  read_integrator(context);
  return ratio;
}

}  // namespace candela::pbrt
