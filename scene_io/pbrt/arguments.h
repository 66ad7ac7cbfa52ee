// What a directive asks of its parameters: each by name and type, with checks of the count.
// Parameters that nobody asked for are warned of with the nearest name that was.
#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/math/vec.h"
#include "scene_io/pbrt/parameter.h"

namespace candela::pbrt {

// A directive as written, e.g. Shape "sphere" with its parameters.
struct Statement {
  std::string directive;
  std::string type;
  Place place;  // of the type, or of the directive where it has none
  ParameterList parameters;
};

class Arguments {
 public:
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  // Both outlive it. Marks the statement's parameters as used.
  Arguments(Statement& statement, const Report& report)
      : statement_(statement), report_(report), errors_before_(report.error_count()) {}
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  // The parameter where it is there, whatever its type. Counts as used.
  Parameter* find(std::string_view name);
  // The parameter where it is there with one of these types; else an error and null.
  Parameter* find(std::string_view name, std::initializer_list<ParameterType> types);
  [[nodiscard]] bool has(std::string_view name) const;

  // One value; nothing where it is absent or, after an error, of another type or count.
  std::optional<double> number(std::string_view name);
  std::optional<std::int64_t> integer(std::string_view name);
  std::optional<std::string> string(std::string_view name);
  std::optional<Vec3d> point(std::string_view name);
  bool flag(std::string_view name, bool otherwise);
  // A number above 0; nothing where it is absent, `unset` or, with a warning, another.
  std::optional<double> positive(std::string_view name, std::optional<double> unset = {});
  // What is nearest to the value within [low, high]; where that is another, a warning at the
  // parameter that it is of.
  double clamped(std::string_view name, double value, double low, double high = no_limit);
  // The file that a directive cannot do without: one name. Null after an error, which says what
  // (`whose`) lacks it where it is absent.
  const Parameter* file(std::string_view name, std::string_view whose);
  // The type of what a directive names: MakeNamedMaterial "a" "string type" "diffuse". Nothing
  // after an error.
  std::optional<std::string> type_of(std::string_view what, std::string_view name);
  // All values; empty where it is absent or in error.
  std::vector<double> numbers(std::string_view name);
  std::vector<std::uint32_t> indices(std::string_view name);
  std::vector<Vec2d> points2(std::string_view name);
  std::vector<Vec3d> points3(std::string_view name);

  // Known, of no effect here: no warning.
  void accept(std::initializer_list<std::string_view> names);
  // Known in pbrt, but without effect in candela: a warning where it is there.
  void ignore(std::string_view name, std::string_view why);
  // Only where it is not that number.
  void ignore_unless(std::string_view name, double value, std::string_view why);
  // Warns of what was never asked for.
  void warn_of_unknown() const;

  // Whether something was wrong since they are being read.
  [[nodiscard]] bool has_errors() const { return report_.error_count() > errors_before_; }
  [[nodiscard]] Statement& statement() const { return statement_; }
  [[nodiscard]] const Report& report() const { return report_; }
  void error(const Parameter& parameter, std::string_view message) const;
  void warning(const Parameter& parameter, std::string_view message) const;
  // Whether it has so many values; else an error.
  [[nodiscard]] bool has_count(const Parameter& parameter, std::size_t count) const;

 private:
  Statement& statement_;
  const Report& report_;
  std::size_t errors_before_;
  std::vector<std::string> asked_;
};

}  // namespace candela::pbrt
