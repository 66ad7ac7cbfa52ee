// Text for terminals.
#pragma once

#include <string>
#include <string_view>

namespace candela {

// Not the first byte of its character.
[[nodiscard]] bool is_utf8_continuation(char c);

// With `replacement` in place of control characters and of bytes that are no UTF-8.
[[nodiscard]] std::string printable(std::string_view text, char replacement = '?');

}  // namespace candela
