// The numbers behind a PLY header, one after another, all as double (which holds every type).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "scene_io/ply/header.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/number.h"

namespace candela::ply {

class BinaryValues {
 public:
  BinaryValues(std::string_view text, std::size_t offset, bool is_little_endian)
      : text_(text),
        at_(offset),
        swaps_(is_little_endian != (std::endian::native == std::endian::little)) {}

  // Nothing at the file's end. Inlined, since it is most of what a large file's reading takes.
  [[gnu::always_inline]] std::optional<double> next(Type type) {
    if (bytes_left() < byte_size(type)) return std::nullopt;
    switch (type) {
      case Type::Int8:
        return load<std::int8_t>();
      case Type::Uint8:
        return load<std::uint8_t>();
      case Type::Int16:
        return load<std::int16_t>();
      case Type::Uint16:
        return load<std::uint16_t>();
      case Type::Int32:
        return load<std::int32_t>();
      case Type::Uint32:
        return load<std::uint32_t>();
      case Type::Float32:
        return load<float>();
      case Type::Float64:
        return load<double>();
    }
    return std::nullopt;
  }
  // Steps over `count` numbers; false where the file ends before.
  bool skip(Type type, std::uint64_t count) {
    if (count > bytes_left() / byte_size(type)) return false;
    at_ += static_cast<std::size_t>(count) * byte_size(type);
    return true;
  }
  [[nodiscard]] std::uint64_t bytes_left() const { return text_.size() - at_; }
  // The fewest bytes that a number of this type can take.
  [[nodiscard]] static std::uint64_t least_bytes(Type type) { return byte_size(type); }
  [[nodiscard]] std::size_t offset() const { return at_; }

 private:
  template <class T>
  double load() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), text_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if (swaps_) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool swaps_ = false;
};

class AsciiValues {
 public:
  AsciiValues(std::string_view text, std::size_t offset)
      : begin_(text.data()), words_(text.substr(offset)) {}

  // Nothing at the file's end or at what is no number; nan and inf pass, as in binary.
  std::optional<double> next(Type /*type*/) {
    words_.skip_spaces();
    at_ = words_.position();
    const std::string_view word = words_.next_word();
    if (word.empty()) return std::nullopt;
    const text::Number<double> number = text::parse_double(word);
    if (number.fault == text::NumberFault::NotFinite) return not_finite;
    if (!number) return std::nullopt;
    return number.value;
  }
  bool skip(Type type, std::uint64_t count) {
    if (count > bytes_left()) return false;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!next(type)) return false;
    }
    return true;
  }
  [[nodiscard]] std::uint64_t bytes_left() const { return words_.rest().size(); }
  // A digit; the blank behind the last one may lack.
  [[nodiscard]] static std::uint64_t least_bytes(Type /*type*/) { return 1; }
  // Of the last word.
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  static constexpr double not_finite = __builtin_nan("");

  const char* begin_;
  text::Cursor words_;
  const char* at_ = begin_;
};

}  // namespace candela::ply
