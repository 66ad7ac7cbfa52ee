#include "scene_io/pbrt/media.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene_io/pbrt/media_presets.h"
#include "scene_io/pbrt/spectrum.h"

namespace candela::pbrt {
namespace {

using description::Medium;
using description::MediumHandle;

// pbrt's own coefficients, where a medium gives none.
constexpr std::string_view default_preset = "Wholemilk";

Vec3d coefficient(Arguments& arguments, std::string_view name, const Vec3d& otherwise,
                  description::SceneDescription& scene) {
  const Parameter* parameter =
      arguments.find(name, {ParameterType::Rgb, ParameterType::Xyz, ParameterType::Spectrum});
  if (!parameter) return otherwise;
  return factor_colour(*parameter, scene, arguments.report()).value_or(otherwise);
}

// A preset counts for more than coefficients, as in pbrt.
void set_coefficients(Arguments& arguments, description::SceneDescription& scene, Medium& medium) {
  const MediumPreset defaults = *medium_preset(default_preset);
  medium.absorption = coefficient(arguments, "sigma_a", defaults.absorption, scene);
  medium.scattering = coefficient(arguments, "sigma_s", defaults.scattering, scene);
  const auto name = arguments.string("preset");
  if (!name || name->empty()) return;
  if (const auto preset = medium_preset(*name)) {
    medium.absorption = preset->absorption;
    medium.scattering = preset->scattering;
    return;
  }
  arguments.warning(*arguments.find("preset"),
                    fmt::format("is {}, no medium that candela knows{}", text::quoted(*name),
                                did_you_mean(*name, medium_preset_names())));
}

}  // namespace

MediumHandle Media::of(const MediumUse& use) {
  if (use.name.empty()) return {};
  const auto known = read_.find(use.name);
  if (known != read_.end()) return known->second;
  return read_[use.name] = find(use);
}

void Media::check_unused() const {
  description::SceneDescription unused;
  Context context = context_.for_unused(unused);
  Media media(context);
  media.read_ = read_;
  for (const auto& [name, statement] : context_.program.media)
    (void)media.of({name, statement.place});
}

MediumHandle Media::find(const MediumUse& use) {
  const auto found = context_.program.media.find(use.name);
  if (found != context_.program.media.end()) return read(found->second, use.name);
  context_.report.error(
      use.place, fmt::format("there is no medium {}{}", text::quoted(use.name),
                             context_.report.did_you_mean_key(use.name, context_.program.media)));
  return {};
}

// Of those that are as clear as air.
void Media::warn_of_type(const Statement& statement, const std::string& type,
                         const std::string& name) {
  static constexpr std::string_view types[] = {"homogeneous", "uniformgrid", "rgbgrid",
                                               "cloud",       "nanovdb",     "heterogeneous"};
  if (std::find(std::begin(types), std::end(types), type) != std::end(types))
    return context_.report.warning(
        statement.place, fmt::format("media of type {} are not rendered: {} is as clear as air",
                                     text::quoted(type), text::quoted(name)));
  context_.report.error(statement.place,
                        fmt::format("{} is no type of media{}", text::quoted(type),
                                    nearest_or_all(type, {std::begin(types), std::end(types)})));
}

MediumHandle Media::read(Statement& statement, const std::string& name) {
  Arguments arguments(statement, context_.report);
  const auto type = arguments.type_of("medium", name);
  if (!type) return {};
  if (*type != "homogeneous") {
    warn_of_type(statement, *type, name);
    return {};
  }
  Medium medium;
  medium.name = name;
  medium.span = statement.place.span();
  set_coefficients(arguments, context_.scene, medium);
  const double scale = arguments.number("scale").value_or(1);
  medium.absorption *= scale;
  medium.scattering *= scale;
  medium.asymmetry = arguments.number("g").value_or(0);
  arguments.ignore("Le", "media do not shine");
  arguments.accept({"Lescale"});
  arguments.warn_of_unknown();
  context_.scene.media.push_back(std::move(medium));
  return MediumHandle(context_.scene.media.size() - 1);
}

}  // namespace candela::pbrt
