// Either a value, or the reasons why there is none.
#pragma once

#include <optional>
#include <utility>

#include "renderer/base/diagnostic.h"

namespace candela {

// The value is present unless `diagnostics` has errors; warnings and notes come along either way.
template <class T>
struct Result {
  std::optional<T> value;
  Diagnostics diagnostics;

  Result(T&& present) : value(std::move(present)) {}
  Result(T&& present, Diagnostics found)
      : value(std::move(present)), diagnostics(std::move(found)) {}
  Result(Diagnostics reasons) : diagnostics(std::move(reasons)) {}

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

// A Result that holds one error without a place.
[[nodiscard]] inline Diagnostics failure(std::string message) {
  Diagnostics diagnostics;
  diagnostics.error({}, std::move(message));
  return diagnostics;
}

}  // namespace candela
