// The directives by name: what reads each of them, and on which side of WorldBegin it may stand.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scene_io/pbrt/token.h"

namespace candela::pbrt {

class Parser;

struct Directive {
  enum class Where : std::uint8_t { Anywhere, BeforeWorld, InWorld };

  std::string_view name;
  void (Parser::*read)();
  Where where = Where::Anywhere;
};

// Null where there is none of that name.
[[nodiscard]] const Directive* directive_named(std::string_view name);
[[nodiscard]] std::vector<std::string_view> directive_names();

// No value is a directive's name without quotes, so a list that nothing closes ends at one.
[[nodiscard]] bool begins_directive(const Token& token);

}  // namespace candela::pbrt
