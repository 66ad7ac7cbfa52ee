#include "scene_io/pbrt/spectrum.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/cie.h"
#include "renderer/math/colour.h"
#include "renderer/math/reflectance.h"
#include "renderer/math/white_balance.h"
#include "scene_io/pbrt/named_spectra.h"
#include "scene_io/pbrt/source_files.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/file.h"
#include "scene_io/text/number.h"

namespace candela::pbrt {
namespace {

constexpr std::size_t most_samples = 100000;

void error(const Parameter& parameter, const Report& report, std::string_view message) {
  report.error(parameter.place, fmt::format("{} {}", text::quoted(parameter.name), message));
}

bool is_one_name(const Parameter& parameter) {
  return parameter.strings.size() == 1 && parameter.numbers.empty();
}

// Pairs of wavelength and value.
std::optional<SampledSpectrum> spectrum_of_pairs(const std::vector<double>& numbers,
                                                 const Parameter& parameter, const Report& report) {
  if (numbers.size() < 2 || numbers.size() % 2 != 0 || numbers.size() > 2 * most_samples) {
    error(parameter, report,
          fmt::format("has {} numbers, expected pairs of a wavelength and a "
                      "value",
                      numbers.size()));
    return std::nullopt;
  }
  SampledSpectrum spectrum;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const bool rises = spectrum.wavelengths.empty() || numbers[i] > spectrum.wavelengths.back();
    if (!rises || !std::isfinite(numbers[i + 1])) {
      error(parameter, report,
            fmt::format("has the wavelength {} in place {}: expected rising ones", numbers[i],
                        i / 2 + 1));
      return std::nullopt;
    }
    spectrum.wavelengths.push_back(numbers[i]);
    spectrum.values.push_back(numbers[i + 1]);
  }
  return spectrum;
}

// A .spd file: pairs line by line, comments from '#'.
std::optional<SampledSpectrum> spectrum_of_file(const Parameter& parameter,
                                                description::SceneDescription& scene,
                                                const Report& report) {
  const std::string& name = parameter.strings[0];
  if (names_a_spectrum(parameter)) {
    error(parameter, report,
          fmt::format("is {}, which is a spectrum of another kind: illuminants are for lights, "
                      "metals and glasses for what reflects",
                      text::quoted(name)));
    return std::nullopt;
  }
  const std::string path = resolve_file(scene.path, parameter.place, name, report);
  const auto bytes = text::read_file(path, {.bytes = 1 << 24, .inflated_bytes = 1 << 24});
  if (!bytes) {
    error(parameter, report,
          fmt::format("{} is no named spectrum, and as a file it {}{}", text::quoted(path),
                      bytes.diagnostics.list()[0].message, did_you_mean(name, spectrum_names())));
    return std::nullopt;
  }
  scene.files.push_back(path);
  std::vector<double> numbers;
  Tokenizer tokens(*bytes);
  for (Token token = tokens.next(); token.kind != TokenKind::End; token = tokens.next()) {
    const auto number = text::parse_double(token.text);
    if (token.kind != TokenKind::Word || !number || numbers.size() > 2 * most_samples) {
      error(parameter, report,
            fmt::format("{} holds {}, expected pairs of numbers", text::quoted(path),
                        text::quoted(token.text)));
      return std::nullopt;
    }
    numbers.push_back(number.value);
  }
  return spectrum_of_pairs(numbers, parameter, report);
}

std::optional<SampledSpectrum> sampled(const Parameter& parameter,
                                       description::SceneDescription& scene, const Report& report) {
  if (parameter.strings.empty()) return spectrum_of_pairs(parameter.numbers, parameter, report);
  if (!is_one_name(parameter)) {
    error(parameter, report, "has several values, expected one name or a list of numbers");
    return std::nullopt;
  }
  return spectrum_of_file(parameter, scene, report);
}

template <class Table>
auto* find_named(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const auto& entry) { return entry.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::optional<Vec3d> triple(const Parameter& parameter, const Report& report) {
  if (parameter.numbers.size() != 3) {
    error(parameter, report, fmt::format("has {} numbers, expected 3", parameter.numbers.size()));
    return std::nullopt;
  }
  const Vec3d numbers(parameter.numbers[0], parameter.numbers[1], parameter.numbers[2]);
  const Vec3d colour = parameter.type == ParameterType::Xyz ? xyz_to_rgb(numbers) : numbers;
  if (parameter.type == ParameterType::Xyz) return glm::max(colour, Vec3d(0.0));
  if (colour.x >= 0 && colour.y >= 0 && colour.z >= 0) return colour;
  error(parameter, report,
        fmt::format("has {}, expected at least 0", std::min({colour.x, colour.y, colour.z})));
  return std::nullopt;
}

// A temperature and, as pbrt-v3 has it, a scale.
struct BlackBody {
  double kelvin = 0;
  double scale = 1;
};
std::optional<BlackBody> read_black_body(const Parameter& parameter, const Report& report) {
  constexpr std::string_view expected = "expected a temperature in kelvins, above 0";
  const std::size_t count = parameter.numbers.size();
  if (count == 0 || count > 2) {
    error(parameter, report, fmt::format("has {} numbers, {}", count, expected));
    return std::nullopt;
  }
  if (!(parameter.numbers[0] > 0)) {
    error(parameter, report, fmt::format("is {}, {}", parameter.numbers[0], expected));
    return std::nullopt;
  }
  return BlackBody{std::clamp(parameter.numbers[0], coolest_kelvins, hottest_kelvins),
                   count == 2 ? std::max(parameter.numbers[1], 0.0) : 1.0};
}

std::optional<Vec3d> black_body_light(const Parameter& parameter, const Report& report) {
  const auto body = read_black_body(parameter, report);
  if (!body) return std::nullopt;
  return body->scale * colour_of_light([&](double nm) { return black_body(nm, body->kelvin); });
}

// As what reflects: of its largest value, at Wien's wavelength [Planck01].
std::optional<Vec3d> black_body_factor(const Parameter& parameter, const Report& report) {
  constexpr double wien = 2.897771955e6;  // nanometre kelvins
  const auto body = read_black_body(parameter, report);
  if (!body) return std::nullopt;
  const double largest = black_body(wien / body->kelvin, body->kelvin);
  return body->scale *
         colour_of_factor([&](double nm) { return black_body(nm, body->kelvin) / largest; });
}

std::optional<Vec3d> spectrum_light(const Parameter& parameter,
                                    description::SceneDescription& scene, const Report& report) {
  if (is_one_name(parameter))
    if (const auto* illuminant = find_named(named_illuminants(), parameter.strings[0]))
      return colour_of_chromaticity(illuminant->x, illuminant->y);
  const auto spectrum = sampled(parameter, scene, report);
  if (!spectrum) return std::nullopt;
  const Vec3d colour = colour_of_light(*spectrum);
  if (colour == Vec3d(0.0))
    report.warning(parameter.place, fmt::format("{} has no light that is seen: it is black",
                                                text::quoted(parameter.name)));
  return colour;
}

// The part of a metal's pair that a name asks for.
std::optional<Vec3d> metal_part(std::string_view name) {
  for (const NamedMetal& metal : named_metals()) {
    if (metal.eta_name == name) return metal.eta;
    if (metal.k_name == name) return metal.k;
  }
  return std::nullopt;
}

std::optional<Vec3d> spectrum_factor(const Parameter& parameter,
                                     description::SceneDescription& scene, const Report& report) {
  if (is_one_name(parameter)) {
    if (const auto part = metal_part(parameter.strings[0])) return part;
    if (const auto* glass = find_named(named_glasses(), parameter.strings[0]))
      return Vec3d(glass->ior);
  }
  const auto spectrum = sampled(parameter, scene, report);
  if (!spectrum) return std::nullopt;
  return colour_of_factor(*spectrum);
}

}  // namespace

bool names_a_spectrum(const Parameter& parameter) {
  if (!is_one_name(parameter)) return false;
  const std::vector<std::string_view> names = spectrum_names();
  return std::ranges::find(names, parameter.strings[0]) != names.end();
}

std::optional<Vec3d> light_colour(Arguments& arguments, std::string_view name,
                                  description::SceneDescription& scene) {
  const Parameter* parameter = arguments.find(
      name,
      {ParameterType::Rgb, ParameterType::Xyz, ParameterType::Blackbody, ParameterType::Spectrum});
  if (!parameter) return std::nullopt;
  const Report& report = arguments.report();
  if (parameter->type == ParameterType::Blackbody) return black_body_light(*parameter, report);
  if (parameter->type == ParameterType::Spectrum) return spectrum_light(*parameter, scene, report);
  return triple(*parameter, report);
}

std::optional<Vec3d> factor_colour(const Parameter& parameter, description::SceneDescription& scene,
                                   const Report& report) {
  if (parameter.type == ParameterType::Spectrum) return spectrum_factor(parameter, scene, report);
  if (parameter.type == ParameterType::Blackbody) return black_body_factor(parameter, report);
  if (parameter.type == ParameterType::Float || parameter.type == ParameterType::Integer) {
    if (parameter.numbers.size() == 1 && parameter.numbers[0] >= 0)
      return Vec3d(parameter.numbers[0]);
    error(parameter, report, "expected one number of at least 0");
    return std::nullopt;
  }
  return triple(parameter, report);
}

std::optional<double> mean_value(const Parameter& parameter, description::SceneDescription& scene,
                                 const Report& report) {
  if (parameter.type == ParameterType::Float || parameter.type == ParameterType::Integer) {
    if (parameter.numbers.size() == 1) return parameter.numbers[0];
    error(parameter, report, "expected one number");
    return std::nullopt;
  }
  if (parameter.type == ParameterType::Rgb) {
    const auto colour = triple(parameter, report);
    return colour ? std::optional(luminance(*colour)) : std::nullopt;
  }
  if (is_one_name(parameter)) {
    if (const auto* glass = find_named(named_glasses(), parameter.strings[0])) return glass->ior;
    if (const auto part = metal_part(parameter.strings[0])) return part->y;
  }
  const auto spectrum = sampled(parameter, scene, report);
  if (!spectrum) return std::nullopt;
  return luminous_mean(*spectrum);
}

std::optional<std::array<Vec3d, 2>> metal_of_spectra(const Parameter& eta, const Parameter& k,
                                                     description::SceneDescription& scene,
                                                     const Report& report) {
  auto n = sampled(eta, scene, report);
  auto extinction = sampled(k, scene, report);
  if (!n || !extinction) return std::nullopt;
  constexpr double largest = 1e6;  // what no metal has, and squares of which are numbers
  for (SampledSpectrum* spectrum : {&*n, &*extinction})
    for (double& value : spectrum->values) value = std::clamp(value, 0.0, largest);
  const Vec3d mean = colour_of_factor(*n);
  const Vec3d reflectance = colour_of_factor([&](double wavelength) {
    return normal_reflectance((*n)(wavelength), (*extinction)(wavelength));
  });
  Vec3d result;
  for (int c = 0; c < 3; ++c)
    result[c] =
        extinction_of_reflectance(mean[c], std::min(reflectance[c], largest_metal_reflectance));
  return std::array<Vec3d, 2>{mean, result};
}

std::optional<std::array<Vec3d, 2>> metal_named(std::string_view spectrum) {
  for (const NamedMetal& metal : named_metals())
    if (metal.eta_name == spectrum || metal.k_name == spectrum)
      return std::array<Vec3d, 2>{metal.eta, metal.k};
  return std::nullopt;
}

}  // namespace candela::pbrt
