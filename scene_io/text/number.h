// Numbers of text files: locale-free, in double, exact (std::from_chars).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace candela::text {

enum class NumberFault : std::uint8_t {
  None,
  Malformed,  // not a number, or a number with something behind it
  NotFinite,  // nan, inf
  TooLarge,   // beyond the type
};

template <class T>
struct Number {
  T value{};
  NumberFault fault = NumberFault::None;
  explicit operator bool() const { return fault == NumberFault::None; }
};

// The whole word as a number. A leading '+', ".5" and "5." are numbers; what is too small for a
// double is 0.
[[nodiscard]] Number<double> parse_double(std::string_view word);
[[nodiscard]] Number<std::int64_t> parse_integer(std::string_view word);

// "is not a number" and its like, for a sentence that begins with the word.
[[nodiscard]] std::string_view describe(NumberFault fault);

// "'v' has 2 numbers; expected 3"
[[nodiscard]] std::string too_few_numbers(std::string_view statement, std::size_t count,
                                          std::string_view expected);

}  // namespace candela::text
