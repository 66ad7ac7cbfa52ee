// Reading numbers and strings out of bytes, never beyond their end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace candela {

class ByteCursor {
 public:
  explicit ByteCursor(std::span<const unsigned char> bytes, std::size_t position = 0)
      : bytes_(bytes),
        position_(std::min(position, bytes.size())),
        is_good_(position <= bytes.size()) {}

  // False once anything was asked for that is not there; what is read then is 0.
  [[nodiscard]] bool is_good() const { return is_good_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }

  void skip(std::size_t count) { (void)take(count); }
  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1, false)); }
  std::uint16_t u16_little() { return static_cast<std::uint16_t>(number(2, false)); }
  std::uint16_t u16_big() { return static_cast<std::uint16_t>(number(2, true)); }
  std::uint32_t u32_little() { return static_cast<std::uint32_t>(number(4, false)); }
  std::uint32_t u32_big() { return static_cast<std::uint32_t>(number(4, true)); }
  std::int32_t i32_little() { return static_cast<std::int32_t>(u32_little()); }

  std::span<const unsigned char> take(std::size_t count) {
    is_good_ = is_good_ && count <= remaining();
    if (!is_good_) return {};
    position_ += count;
    return bytes_.subspan(position_ - count, count);
  }

  // Up to a zero byte, which is passed over.
  std::string_view text() {
    const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + position_,
                                is_good_ ? remaining() : 0);
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) {
      is_good_ = false;
      return {};
    }
    position_ += end + 1;
    return rest.substr(0, end);
  }

 private:
  std::uint64_t number(std::size_t count, bool is_big_endian) {
    std::uint64_t value = 0;
    const auto digits = take(count);
    for (std::size_t i = 0; i < digits.size(); ++i)
      value |= std::uint64_t{digits[i]} << (8 * (is_big_endian ? digits.size() - 1 - i : i));
    return value;
  }

  std::span<const unsigned char> bytes_;
  std::size_t position_;
  bool is_good_;
};

}  // namespace candela
