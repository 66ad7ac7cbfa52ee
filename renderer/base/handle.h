// Typed indices between tables: a handle to a mesh cannot be used to look up a material.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace candela {

template <class Tag>
struct Handle {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t index = none;

  constexpr Handle() = default;
  constexpr explicit Handle(std::size_t i) : index(static_cast<std::uint32_t>(i)) {}
  [[nodiscard]] constexpr bool is_valid() const { return index != none; }
  constexpr explicit operator bool() const { return is_valid(); }
  friend constexpr auto operator<=>(const Handle&, const Handle&) = default;
};

}  // namespace candela
