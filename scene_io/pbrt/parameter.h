// Typed parameters of a directive as written: "float radius" 2, "point3 P" [ 0 0 0  1 0 0 ].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene_io/pbrt/report.h"
#include "scene_io/pbrt/token.h"

namespace candela::pbrt {

enum class ParameterType : std::uint8_t {
  Float,
  Integer,
  Bool,  // numbers 0 and 1
  String,
  Texture,
  Point2,
  Vector2,
  Point3,
  Vector3,
  Normal,
  Rgb,
  Xyz,        // pbrt-v3
  Spectrum,   // a name or file, or pairs of wavelength and value
  Blackbody,  // a temperature; pbrt-v3 writes a scale behind it
};

// The types' names; pbrt-v3's point, vector, normal and color as well.
[[nodiscard]] std::optional<ParameterType> parameter_type_named(std::string_view name);
[[nodiscard]] std::string_view name_of(ParameterType type);

struct Parameter {
  ParameterType type = ParameterType::Float;
  std::string name;
  Place place;  // of the declaration
  std::vector<double> numbers;
  std::vector<std::string> strings;
  bool is_used = false;
  bool is_default = false;  // from an Attribute directive: may go unused
};

using ParameterList = std::vector<Parameter>;

// Numbers or strings.
[[nodiscard]] std::size_t value_count(const Parameter& parameter);
// For messages: "2 values".
[[nodiscard]] std::string describe_count(const Parameter& parameter);
// For messages: "[0.5, 2]".
[[nodiscard]] std::string describe_numbers(const Parameter& parameter);

// Those whose names `list` does not have.
void append_missing(const ParameterList& defaults, ParameterList& list);

// All parameters up to the next directive. After an error it skips to there.
[[nodiscard]] ParameterList read_parameters(Tokenizer& tokens, const SourceFile& file,
                                            const Report& report);

}  // namespace candela::pbrt
