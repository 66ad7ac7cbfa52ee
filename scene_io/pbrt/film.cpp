// Film, PixelFilter, Sampler and Integrator.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/white_balance.h"
#include "scene_io/pbrt/camera.h"
#include "scene_io/pbrt/spectrum.h"

namespace candela::pbrt {
namespace {

using description::RenderDefaults;

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

// For how long the camera's shutter, which has to open, is open: pbrt's exposure time where the
// film has none of its own.
double shutter_time(Context& context) {
  if (!context.program.camera) return 1;
  Arguments camera(*context.program.camera, context.report);
  const double closes = camera.number("shutterclose").value_or(1);
  const double opens = camera.number("shutteropen").value_or(0);
  if (closes > opens) return closes - opens;
  context.report.error(
      camera.statement().place,
      fmt::format("the shutter closes at {}, expected after it opens at {}", closes, opens));
  return 1;
}

// Kelvins of what is white on the film. pbrt's sensors are balanced for 6500 where nothing is said,
// the CIE's observer for nothing.
void read_white_balance(Context& context, Arguments& film) {
  const Parameter* sensor = film.find("sensor", {ParameterType::String});
  const bool is_plain = !sensor || sensor->strings.size() != 1 || sensor->strings[0] == "cie1931";
  if (!is_plain)
    film.warning(*sensor, "is not supported: the film is that of the CIE 1931 observer");
  double kelvins = film.number("whitebalance").value_or(0);
  if (kelvins == 0 && !is_plain) kelvins = 6500;
  if (kelvins == 0) return;
  if (kelvins > 0 && std::isfinite(kelvins))
    context.scene.defaults.white_balance_kelvins =
        film.clamped("whitebalance", kelvins, coolest_kelvins, hottest_kelvins);
  else
    film.error(*film.find("whitebalance"),
               fmt::format("is {}, expected kelvins, or 0 for no balance", kelvins));
}

double read_exposure(Context& context, Arguments& film) {
  double ratio = film.number("iso").value_or(100) / 100;
  const auto exposure = film.number("exposuretime");
  ratio *= exposure ? *exposure : shutter_time(context);
  film.ignore_unless("scale", 1, "it is pbrt-v3's");
  for (const std::string_view name : {"maxcomponentvalue", "maxsampleluminance"})
    film.ignore(name, "radiance is not clamped");
  constexpr double most = 1e30;
  if (ratio > 0 && ratio < most) return ratio;
  context.report.error(
      film.statement().place,
      fmt::format("the film multiplies light by {:g}, expected above 0 and below {:g}", ratio,
                  most));
  return 1;
}

// In shares of the picture, as "cropwindow" has it; "pixelbounds" counts pixels. Both list x0 x1 y0
// y1 in any order, from the top left; what lies outside of the picture is cut. Of both, the first.
void read_crop(Context& context, Arguments& film) {
  const auto& defaults = context.scene.defaults;
  const Parameter* window = film.find("cropwindow", {ParameterType::Float});
  const Parameter* bounds = film.find("pixelbounds", {ParameterType::Integer});
  if (window && bounds) film.warning(*bounds, "is ignored beside \"cropwindow\"");
  const Parameter* given = window ? window : bounds;
  if (!given || !film.has_count(*given, 4)) return;
  std::array<double, 4> shares{};
  bool is_cut = false;
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = given == bounds ? (i < 2 ? *defaults.width : *defaults.height) : 1;
    shares[i] = std::clamp(given->numbers[i] / side, 0.0, 1.0);
    is_cut = is_cut || shares[i] != given->numbers[i] / side;
  }
  if (is_cut && given == bounds)
    film.warning(*bounds, "reaches beyond the picture: what lies outside is cut");
  if (shares[1] < shares[0]) std::swap(shares[0], shares[1]);
  if (shares[3] < shares[2]) std::swap(shares[2], shares[3]);
  if (!(shares[0] < shares[1] && shares[2] < shares[3]))
    return film.error(*given, fmt::format("is {}, which holds no pixel: expected x0 < x1 and "
                                          "y0 < y1",
                                          describe_numbers(*given)));
  context.scene.defaults.crop = description::CropWindow{shares[0], shares[1], shares[2], shares[3]};
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
  context.scene.defaults.width =
      integer(film, "xresolution", 1, RenderDefaults::largest_side).value_or(1280);
  context.scene.defaults.height =
      integer(film, "yresolution", 1, RenderDefaults::largest_side).value_or(720);
  film.accept({"filename", "diagonal", "savefp16", "coordinatesystem", "nbuckets", "lambdamin",
               "lambdamax"});
  read_crop(context, film);
  context.scene.defaults.exposure = film.number("exposure");  // candela's own
  const double ratio = read_exposure(context, film);
  read_white_balance(context, film);
  film.warn_of_unknown();
  return ratio;
}

struct KnownFilter {
  std::string_view name;
  double radius;
};
constexpr KnownFilter filters[] = {
    {"box", 0.5}, {"gaussian", 1.5}, {"triangle", 2}, {"mitchell", 2}, {"sinc", 4}};

// A number of a filter that is always pbrt's own.
void expect_filter_number(Context& context, Arguments& arguments, std::string_view filter,
                          std::string_view name, double value) {
  const double found = arguments.number(name).value_or(value);
  if (arguments.statement().type == filter && std::abs(found - value) > 1e-3)
    context.warn_once(fmt::format("filter's {}", name), arguments.statement().place,
                      fmt::format("the {} filter's {} is {:.3g} here", filter, name, value));
}

void read_filter(Context& context) {
  Statement otherwise{"PixelFilter", "gaussian", {}, {}};
  Statement& statement = context.program.filter ? *context.program.filter : otherwise;
  Arguments arguments(statement, context.report);
  const auto* known = std::find_if(std::begin(filters), std::end(filters), [&](const auto& filter) {
    return filter.name == statement.type;
  });
  const auto x = arguments.number("xradius");
  const auto y = arguments.number("yradius");
  expect_filter_number(context, arguments, "gaussian", "alpha", 2);  // pbrt-v3's: a sigma of 0.5
  expect_filter_number(context, arguments, "mitchell", "B", 1.0 / 3);
  expect_filter_number(context, arguments, "mitchell", "C", 1.0 / 3);
  expect_filter_number(context, arguments, "sinc", "tau", 3);
  const double sigma = arguments.number("sigma").value_or(0.5);
  if (const auto own = arguments.string("filter")) {  // one that only candela has
    context.scene.defaults.filter = *own;
    context.scene.defaults.filter_radius = x;  // validate() looks at it
    return arguments.warn_of_unknown();
  }
  if (statement.type == "gaussian" && sigma != 0.5)
    context.warn_once("sigma", statement.place, "the gaussian filter's sigma is 0.5 here");
  arguments.warn_of_unknown();
  if (known == std::end(filters))
    return context.report.error(statement.place,
                                fmt::format("{} is no filter, expected box, gaussian, triangle, "
                                            "mitchell or sinc",
                                            text::quoted(statement.type)));
  context.scene.defaults.filter = std::string(known->name);
  const double radius = x.value_or(known->radius);
  if (!(radius > 0 && radius <= RenderDefaults::widest_filter))
    return context.report.error(statement.place,
                                fmt::format("the filter's radius is {}, expected above 0 and at "
                                            "most {}",
                                            radius, RenderDefaults::widest_filter));
  context.scene.defaults.filter_radius = radius;
  if (y && *y != radius)
    context.warn_once("yradius", statement.place, "filters are square: the xradius is used");
}

// Whether pbrt has a type of that name, in some version; else an error.
template <class Names>
bool check_type(const Statement& statement, std::string_view what, const Names& names,
                const Report& report) {
  if (std::find(std::begin(names), std::end(names), statement.type) != std::end(names)) return true;
  report.error(statement.place,
               fmt::format("{} is no {}{}", text::quoted(statement.type), what,
                           nearest_or_all(statement.type, {std::begin(names), std::end(names)})));
  return false;
}

// pbrt-v4's and those of pbrt-v3.
constexpr std::string_view samplers[] = {
    "halton", "independent", "paddedsobol",    "pmj02bn",    "sobol", "stratified",
    "zsobol", "02sequence",  "lowdiscrepancy", "maxmindist", "random"};
constexpr std::string_view integrators[] = {
    "path", "volpath", "simplepath",       "simplevolpath", "lightpath", "randomwalk",     "bdpt",
    "mlt",  "sppm",    "ambientocclusion", "function",      "whitted",   "directlighting", "ao"};

// candela's own is a text where pbrt's integers are too short.
std::optional<std::uint64_t> read_seed(Arguments& sampler) {
  const Parameter* own = sampler.find("seed");
  if (!own || own->type != ParameterType::String) {
    const auto seed = sampler.integer("seed");
    if (seed && *seed < 0)
      sampler.warning(*own, fmt::format("is {}, expected at least 0: it is left out", *seed));
    return seed && *seed >= 0 ? std::optional<std::uint64_t>(*seed) : std::nullopt;
  }
  const std::string text = sampler.string("seed").value_or("");
  std::uint64_t seed = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (fault == std::errc() && end == text.data() + text.size()) return seed;
  sampler.error(*own, fmt::format("is {}, expected an integer of at least 0", text::quoted(text)));
  return std::nullopt;
}

void read_sampler(Context& context) {
  auto& defaults = context.scene.defaults;
  defaults.samples_per_pixel = 16;
  if (context.program.seed) defaults.seed = *context.program.seed;
  if (!context.program.sampler) return;
  Arguments sampler(*context.program.sampler, context.report);
  (void)check_type(sampler.statement(), "sampler", samplers, context.report);
  const auto count = integer(sampler, "pixelsamples", 1, RenderDefaults::most_samples);
  const int x = integer(sampler, "xsamples", 1, 32768).value_or(4);
  const int y = integer(sampler, "ysamples", 1, 32768).value_or(4);
  const std::string& type = sampler.statement().type;
  const bool is_independent = is_one_of(type, {"independent", "random"});
  const int otherwise = type == "stratified" ? x * y : (is_independent ? 4 : 16);
  defaults.samples_per_pixel = count.value_or(otherwise);
  if (const auto seed = read_seed(sampler)) defaults.seed = seed;
  sampler.accept({"randomization", "jitter", "dimensions"});
  sampler.warn_of_unknown();
}

// candela's own: no limit, another integrator, lab3's ambient term.
void read_own_wishes(Arguments& integrator, Context& context) {
  auto& defaults = context.scene.defaults;
  if (integrator.flag("unlimited", false)) defaults.max_depth.reset();
  defaults.integrator = integrator.string("integrator").value_or("path");
  if (const Parameter* ambient = integrator.find("ambient", {ParameterType::Rgb}))
    context.scene.lab_ambient = factor_colour(*ambient, context.scene, context.report);
}

// candela has its own way to transport light for all of pbrt's.
void read_integrator(Context& context) {
  auto& defaults = context.scene.defaults;
  defaults.integrator = "path";
  defaults.max_depth = 5;
  if (!context.program.integrator) return;
  Statement& statement = *context.program.integrator;
  Arguments integrator(statement, context.report);
  defaults.max_depth = integer(integrator, "maxdepth", 0, RenderDefaults::deepest).value_or(5);
  read_own_wishes(integrator, context);
  if (!check_type(statement, "integrator", integrators, context.report)) return;
  if (!is_one_of(statement.type, {"path", "volpath"}))
    context.warn_once(
        "integrator", statement.place,
        fmt::format("the integrator {} is rendered by 'path'", text::quoted(statement.type)));
  if (statement.type == "path" && !context.program.media.empty())
    context.warn_once(
        "path and media", statement.place,
        "pbrt's path integrator, in contrast to volpath, does not see media: they are "
        "rendered here");
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
