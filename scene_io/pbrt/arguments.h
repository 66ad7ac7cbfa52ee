// What a directive asks of its parameters: each by name and type, with checks of the count.
// Parameters that nobody asked for are warned of with the nearest name that was.
#pragma once

#include <initializer_list>
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
  // Both outlive it. Marks the statement's parameters as used.
  Arguments(Statement& statement, const Report& report) : statement_(statement), report_(report) {}
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

  [[nodiscard]] Statement& statement() const { return statement_; }
  [[nodiscard]] const Report& report() const { return report_; }
  void error(const Parameter& parameter, std::string_view message) const;
  void warning(const Parameter& parameter, std::string_view message) const;

 private:
  bool has_count(const Parameter& parameter, std::size_t count) const;

  Statement& statement_;
  const Report& report_;
  std::vector<std::string> asked_;
};

}  // namespace candela::pbrt
