// What editors put around and between lines of text.
#pragma once

#include <string>
#include <string_view>

namespace candela::text {

[[nodiscard]] bool is_utf16(std::string_view text);
// Of UTF-8.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);
void drop_byte_order_mark(std::string& text);
// Where the first line ends as on old Macs, by a carriage return alone, all such become line feeds.
void use_line_feeds(std::string& text);

}  // namespace candela::text
