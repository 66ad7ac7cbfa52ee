#include "scene_io/pbrt/media.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene_io/pbrt/spectrum.h"

namespace candela::pbrt {
namespace {

std::optional<Vec3d> coefficient(Arguments& arguments, std::string_view name,
                                 const std::string& scene_path) {
  const Parameter* parameter =
      arguments.find(name, {ParameterType::Rgb, ParameterType::Xyz, ParameterType::Spectrum});
  if (!parameter) return std::nullopt;
  return factor_colour(*parameter, scene_path, arguments.report());
}

}  // namespace

Vec3d Media::absorption_of(const MediumUse& use) {
  const auto known = read_.find(use.name);
  if (known != read_.end()) return known->second;
  const auto found = context_.program.media.find(use.name);
  if (found != context_.program.media.end()) return read_[use.name] = read(found->second, use.name);
  std::vector<std::string_view> names;
  for (const auto& [name, statement] : context_.program.media) names.push_back(name);
  context_.report.error(
      use.place, fmt::format("there is no medium {}{}", text::quoted(use.name),
                             did_you_mean(std::string_view(use.name).substr(0, 100), names)));
  return read_[use.name] = Vec3d(0.0);
}

// pbrt's own coefficients, where a medium gives none, are those of a scattering one.
Vec3d Media::read(Statement& statement, const std::string& name) {
  Arguments arguments(statement, context_.report);
  const std::string type = arguments.string("type").value_or("");
  if (type != "homogeneous") {
    context_.report.warning(statement.place,
                            fmt::format("media of type {} are not rendered: {} is as clear as air",
                                        text::quoted(type), text::quoted(name)));
    return Vec3d(0.0);
  }
  const double scale = std::max(arguments.number("scale").value_or(1), 0.0);
  const auto absorption = coefficient(arguments, "sigma_a", context_.scene.path);
  const auto scattering = coefficient(arguments, "sigma_s", context_.scene.path);
  arguments.accept({"g", "preset"});
  arguments.ignore("Le", "media do not shine");
  arguments.warn_of_unknown();
  if (!scattering || *scattering != Vec3d(0.0))
    context_.report.warning(
        statement.place, fmt::format("media do not scatter: {} only absorbs", text::quoted(name)));
  const Vec3d total = absorption.value_or(Vec3d(0.0)) * scale;
  if (is_finite(total)) return total;
  context_.report.error(statement.place, "the medium's absorption is not finite");
  return Vec3d(0.0);
}

}  // namespace candela::pbrt
