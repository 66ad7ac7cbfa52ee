// A value among bytes, which need not be aligned.
#pragma once

#include <cstddef>
#include <cstring>

namespace candela {

template <class Value>
[[nodiscard]] Value value_at(const std::byte* place) {
  Value value;
  std::memcpy(&value, place, sizeof(Value));
  return value;
}

}  // namespace candela
