// The header of a PLY file: which numbers follow, in which form.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "scene_io/text/source.h"

namespace candela::ply {

enum class Form : std::uint8_t { Ascii, LittleEndian, BigEndian };

enum class Type : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

[[nodiscard]] std::size_t byte_size(Type type);

struct Property {
  std::string_view name;
  Type type = Type::Float32;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;  // as claimed
  std::vector<Property> properties;
  std::size_t offset = 0;  // of its line

  [[nodiscard]] const Property* find(std::string_view property) const;
};

struct Header {
  Form form = Form::Ascii;
  std::vector<Element> elements;
  std::size_t body = 0;  // offset of the first byte behind it
};

// Nothing, after an error, where the text does not begin with a sound header. Views point into the
// text.
[[nodiscard]] std::optional<Header> parse_header(const text::Source& source,
                                                 Diagnostics& diagnostics);

}  // namespace candela::ply
