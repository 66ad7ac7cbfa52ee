#include "scene_io/text/number.h"

#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "scene_io/text/cursor.h"

namespace candela::text {
namespace {

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

// Whether a number whose exponent is out of range is too small: its first significant digit, moved
// by the exponent, stands behind the point.
bool is_underflow(std::string_view word) {
  std::int64_t digits_before_point = 0;
  bool is_behind_point = false;
  bool has_significant = false;
  std::size_t i = word[0] == '-' ? 1 : 0;
  for (; i < word.size() && (is_digit(word[i]) || word[i] == '.'); ++i) {
    if (word[i] == '.') {
      is_behind_point = true;
    } else {
      has_significant = has_significant || word[i] != '0';
      if (has_significant && !is_behind_point) ++digits_before_point;
      if (!has_significant && is_behind_point) --digits_before_point;
    }
  }
  if (i == word.size()) return digits_before_point <= 0;
  const std::string_view exponent_word = without_plus(word.substr(i + 1));
  std::int64_t exponent = 0;
  const auto [end, status] =
      std::from_chars(exponent_word.data(), exponent_word.data() + exponent_word.size(), exponent);
  if (status == std::errc::result_out_of_range) return exponent_word[0] == '-';
  return exponent + digits_before_point <= 0;
}

// What old run-time libraries print for numbers that are none: 1.#QNAN, -1.#IND, 1.#INF.
bool is_printed_nan(std::string_view word) {
  return word.find(".#") != std::string_view::npos;
}

bool is_finite_digits(std::string_view word) {
  const std::size_t first = word[0] == '-' ? 1 : 0;
  return first < word.size() && (is_digit(word[first]) || word[first] == '.');
}

}  // namespace

Number<double> parse_double(std::string_view word) {
  const std::string_view digits = without_plus(word);
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, status] = std::from_chars(digits.data(), end, value);
  if (status == std::errc::invalid_argument) return {0.0, NumberFault::Malformed};
  if (stop != end) {
    return {0.0, is_printed_nan(digits) ? NumberFault::NotFinite : NumberFault::Malformed};
  }
  if (status == std::errc::result_out_of_range) {
    return {0.0, is_underflow(digits) ? NumberFault::None : NumberFault::TooLarge};
  }
  if (!is_finite_digits(digits)) return {0.0, NumberFault::NotFinite};
  return {value, NumberFault::None};
}

Number<std::int64_t> parse_integer(std::string_view word) {
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, status] = std::from_chars(digits.data(), end, value);
  if (status == std::errc::invalid_argument || stop != end) return {0, NumberFault::Malformed};
  if (status == std::errc::result_out_of_range) return {0, NumberFault::TooLarge};
  return {value, NumberFault::None};
}

std::string_view describe(NumberFault fault) {
  switch (fault) {
    case NumberFault::None:
      return "is a number";
    case NumberFault::Malformed:
      return "is not a number";
    case NumberFault::NotFinite:
      return "is not a finite number";
    case NumberFault::TooLarge:
      return "is too large a number";
  }
  return "";
}

std::string too_few_numbers(std::string_view statement, std::size_t count,
                            std::string_view expected) {
  return fmt::format("'{}' has {}; expected {}", statement, counted(count, "number"), expected);
}

}  // namespace candela::text
