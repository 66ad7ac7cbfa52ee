#include "scene_io/pbrt/arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace candela::pbrt {
namespace {

std::string list_of(std::initializer_list<ParameterType> types) {
  std::string list;
  for (const ParameterType type : types)
    list += fmt::format("{}{}", list.empty() ? "" : " or ", name_of(type));
  return list;
}

bool is_index(double value) {
  return value >= 0 && value <= std::numeric_limits<std::uint32_t>::max() - 1.0 &&
         value == std::floor(value);
}

}  // namespace

Parameter* Arguments::find(std::string_view name) {
  if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) asked_.emplace_back(name);
  for (Parameter& parameter : statement_.parameters) {
    if (parameter.name != name) continue;
    parameter.is_used = true;
    return &parameter;
  }
  return nullptr;
}

Parameter* Arguments::find(std::string_view name, std::initializer_list<ParameterType> types) {
  Parameter* parameter = find(name);
  if (!parameter || std::find(types.begin(), types.end(), parameter->type) != types.end())
    return parameter;
  // Written so by hand and by exporters, and of one meaning.
  const bool wants_float =
      std::find(types.begin(), types.end(), ParameterType::Float) != types.end();
  if (wants_float && parameter->type == ParameterType::Integer) return parameter;
  error(*parameter,
        fmt::format("is of type {}, expected {}", name_of(parameter->type), list_of(types)));
  return nullptr;
}

bool Arguments::has(std::string_view name) const {
  return std::any_of(statement_.parameters.begin(), statement_.parameters.end(),
                     [&](const Parameter& parameter) { return parameter.name == name; });
}

bool Arguments::has_count(const Parameter& parameter, std::size_t count) const {
  if (value_count(parameter) == count) return true;
  error(parameter, fmt::format("has {}, expected {}", describe_count(parameter), count));
  return false;
}

std::optional<double> Arguments::number(std::string_view name) {
  const Parameter* parameter = find(name, {ParameterType::Float});
  if (!parameter || !has_count(*parameter, 1)) return std::nullopt;
  return parameter->numbers[0];
}

std::optional<std::int64_t> Arguments::integer(std::string_view name) {
  const Parameter* parameter = find(name, {ParameterType::Integer});
  if (!parameter || !has_count(*parameter, 1)) return std::nullopt;
  const double value = parameter->numbers[0];
  if (value == std::floor(value) && std::abs(value) < 9e15) return static_cast<std::int64_t>(value);
  error(*parameter, fmt::format("is {}, expected an integer", value));
  return std::nullopt;
}

std::optional<std::string> Arguments::string(std::string_view name) {
  const Parameter* parameter = find(name, {ParameterType::String});
  if (!parameter || !has_count(*parameter, 1)) return std::nullopt;
  return parameter->strings[0];
}

std::optional<Vec3d> Arguments::point(std::string_view name) {
  const Parameter* parameter = find(name, {ParameterType::Point3, ParameterType::Vector3});
  if (!parameter || !has_count(*parameter, 3)) return std::nullopt;
  return Vec3d(parameter->numbers[0], parameter->numbers[1], parameter->numbers[2]);
}

std::optional<double> Arguments::positive(std::string_view name, std::optional<double> unset) {
  const auto value = number(name);
  if (!value || value == unset) return std::nullopt;
  if (*value > 0) return value;
  warning(*find(name), fmt::format("is {}, expected above 0: it is ignored", *value));
  return std::nullopt;
}

double Arguments::clamped(std::string_view name, double value, double low, double high) {
  const double nearest = std::clamp(value, low, high);
  const Parameter* parameter = find(name);
  if (!parameter || nearest == value) return nearest;
  const std::string range =
      high == no_limit ? fmt::format("at least {}", low) : fmt::format("{} to {}", low, high);
  warning(*parameter, fmt::format("is {}, expected {}: {} is used", value, range, nearest));
  return nearest;
}

const Parameter* Arguments::file(std::string_view name, std::string_view whose) {
  const Parameter* parameter = find(name, {ParameterType::String});
  if (parameter) return has_count(*parameter, 1) ? parameter : nullptr;
  if (!has(name))
    report_.error(statement_.place,
                  fmt::format("{} without its file: expected \"string {}\"", whose, name));
  return nullptr;
}

// A parameter whose name is nearly that is what is wrong.
std::optional<std::string> Arguments::type_of(std::string_view what, std::string_view name) {
  if (has("type")) return string("type");
  std::vector<std::string_view> names;
  for (const Parameter& parameter : statement_.parameters) names.push_back(parameter.name);
  if (const Parameter* misspelled = find(nearest_name("type", names)))
    error(*misspelled,
          fmt::format("is not a parameter of {}, did you mean 'type'?", statement_.directive));
  else
    report_.error(statement_.place, fmt::format("the {} {} has no type: expected \"string type\"",
                                                what, text::quoted(name)));
  return std::nullopt;
}

bool Arguments::flag(std::string_view name, bool otherwise) {
  const Parameter* parameter = find(name, {ParameterType::Bool});
  if (!parameter || !has_count(*parameter, 1)) return otherwise;
  return parameter->numbers[0] != 0;
}

std::vector<double> Arguments::numbers(std::string_view name) {
  const Parameter* parameter = find(name, {ParameterType::Float});
  return parameter ? parameter->numbers : std::vector<double>();
}

std::vector<std::uint32_t> Arguments::indices(std::string_view name) {
  const Parameter* parameter = find(name, {ParameterType::Integer});
  std::vector<std::uint32_t> indices;
  if (!parameter) return indices;
  indices.reserve(parameter->numbers.size());
  for (const double value : parameter->numbers) {
    if (!is_index(value)) {
      error(*parameter, fmt::format("has {}, expected integers of at least 0", value));
      return {};
    }
    indices.push_back(static_cast<std::uint32_t>(value));
  }
  return indices;
}

std::vector<Vec2d> Arguments::points2(std::string_view name) {
  // pbrt-v3 has plain floats.
  const Parameter* parameter =
      find(name, {ParameterType::Point2, ParameterType::Vector2, ParameterType::Float});
  std::vector<Vec2d> points;
  if (!parameter) return points;
  if (parameter->numbers.size() % 2 != 0) {
    error(*parameter, fmt::format("has {}, expected pairs", describe_count(*parameter)));
    return points;
  }
  points.reserve(parameter->numbers.size() / 2);
  for (std::size_t i = 0; i < parameter->numbers.size(); i += 2)
    points.emplace_back(parameter->numbers[i], parameter->numbers[i + 1]);
  return points;
}

std::vector<Vec3d> Arguments::points3(std::string_view name) {
  const Parameter* parameter =
      find(name, {ParameterType::Point3, ParameterType::Vector3, ParameterType::Normal});
  std::vector<Vec3d> points;
  if (!parameter) return points;
  if (parameter->numbers.size() % 3 != 0) {
    error(*parameter, fmt::format("has {}, expected triples", describe_count(*parameter)));
    return points;
  }
  points.reserve(parameter->numbers.size() / 3);
  for (std::size_t i = 0; i < parameter->numbers.size(); i += 3)
    points.emplace_back(parameter->numbers[i], parameter->numbers[i + 1],
                        parameter->numbers[i + 2]);
  return points;
}

void Arguments::accept(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) find(name);
}

void Arguments::ignore(std::string_view name, std::string_view why) {
  const Parameter* parameter = find(name);
  if (parameter && !parameter->is_default) warning(*parameter, fmt::format("is ignored: {}", why));
}

void Arguments::ignore_unless(std::string_view name, double value, std::string_view why) {
  const Parameter* parameter = find(name);
  if (parameter && parameter->numbers != std::vector<double>{value}) ignore(name, why);
}

void Arguments::warn_of_unknown() const {
  const std::vector<std::string_view> names(asked_.begin(), asked_.end());
  for (const Parameter& parameter : statement_.parameters) {
    if (parameter.is_used || parameter.is_default) continue;
    const std::string advice = report_.wants_warnings() ? did_you_mean(parameter.name, names) : "";
    warning(parameter, fmt::format("is not a parameter of {} \"{}\" and is ignored{}",
                                   statement_.directive, statement_.type, advice));
  }
}

void Arguments::error(const Parameter& parameter, std::string_view message) const {
  report_.error(parameter.place, fmt::format("{} {}", text::quoted(parameter.name), message));
}

void Arguments::warning(const Parameter& parameter, std::string_view message) const {
  report_.warning(parameter.place, fmt::format("{} {}", text::quoted(parameter.name), message));
}

}  // namespace candela::pbrt
