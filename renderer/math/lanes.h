// Sixteen values side by side, as a block of rays or of a pixel's samples has them: what loops over
// all lanes do, processors do to several lanes at once.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "renderer/math/vec.h"

namespace candela {

inline constexpr std::uint32_t block_size = 16;

template <class T>
using Lanes = std::array<T, block_size>;
using LaneFlags = Lanes<std::uint32_t>;  // 1 in lanes where something holds, else 0

// Booleans as numbers: what && makes is a branch, which vectors do not have.
[[nodiscard]] constexpr std::uint32_t flag(bool condition) {
  return condition ? 1 : 0;
}

template <class Vector>
struct VectorLanes {
  Lanes<typename Vector::value_type> x{}, y{}, z{};

  [[nodiscard]] Vector operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vector& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};
using Vec3Lanes = VectorLanes<Vec3f>;
using Vec3dLanes = VectorLanes<Vec3d>;

// Bit i stands for lane i.
using LaneMask = std::uint32_t;
inline constexpr LaneMask all_lanes = (1u << block_size) - 1;

[[nodiscard]] inline LaneMask mask_of(const LaneFlags& flags) {
  LaneMask mask = 0;
  for (std::uint32_t i = 0; i < block_size; ++i) mask |= flags[i] << i;
  return mask;
}

[[nodiscard]] inline LaneFlags flags_of(LaneMask lanes) {
  LaneFlags flags;
  for (std::uint32_t i = 0; i < block_size; ++i) flags[i] = lanes >> i & 1;
  return flags;
}

// std::popcount, without a call where the processor need not have an instruction for it.
inline constexpr auto bit_counts = [] {
  std::array<std::uint8_t, 256> counts{};
  for (std::size_t i = 1; i < counts.size(); ++i)
    counts[i] = static_cast<std::uint8_t>(counts[i / 2] + i % 2);
  return counts;
}();
[[nodiscard]] constexpr std::uint32_t lane_count(LaneMask lanes) {
  return std::uint32_t{bit_counts[lanes & 0xff]} + bit_counts[lanes >> 8];
}

// For each lane of the mask, from the lowest.
template <class Visit>
inline void for_each_lane(LaneMask lanes, const Visit& visit) {
  for (; lanes != 0; lanes &= lanes - 1) visit(static_cast<std::uint32_t>(std::countr_zero(lanes)));
}

}  // namespace candela
