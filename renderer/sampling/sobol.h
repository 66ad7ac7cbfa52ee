// The first two Sobol dimensions, shuffled and Owen-scrambled by hashing.
//
// Both are hashes of bits in reverse, so sequences are told by bit-reversed indices. What that
// costs: docs/decisions.md.
#pragma once

#include <cstdint>

#include "renderer/math/vec.h"
#include "renderer/sampling/hash.h"

namespace candela {

[[nodiscard]] constexpr std::uint32_t reverse_bits(std::uint32_t v) {
  v = (v << 16) | (v >> 16);
  v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
  v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
  v = ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
  return v;
}

// A hash whose lower bits do not depend on the higher ones [Laine11], by the constants of
// [Vegdahl21].
[[nodiscard]] constexpr std::uint32_t hash_upwards(std::uint32_t x, std::uint32_t shift,
                                                   std::uint32_t multiplier) {
  x ^= x * 0x3d20adeau;
  x += shift;
  x *= multiplier | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Shuffles the order of a sequence within every aligned block of a power of two, given and
// returning reversed indices.
[[nodiscard]] constexpr std::uint32_t shuffle_reversed_index(std::uint32_t reversed_index,
                                                             std::uint32_t seed) {
  return hash_upwards(reversed_index, seed, seed >> 16);
}
[[nodiscard]] constexpr std::uint32_t shuffled_index(std::uint32_t reversed_index,
                                                     std::uint32_t seed) {
  return reverse_bits(shuffle_reversed_index(reversed_index, seed));
}

// The second Sobol dimension's point of an index, as a 32-bit fraction whose bits are in reverse.
// Its generator matrix is Pascal's triangle mod 2: the Kronecker power of [1 1; 0 1], so five
// shift-and-xor steps multiply by it.
[[nodiscard]] constexpr std::uint32_t reversed_sobol_second(std::uint32_t index) {
  std::uint32_t v = index;
  v ^= (v >> 1) & 0x55555555u;
  v ^= (v >> 2) & 0x33333333u;
  v ^= (v >> 4) & 0x0f0f0f0fu;
  v ^= (v >> 8) & 0x00ff00ffu;
  v ^= v >> 16;
  return v;
}

// A nested scramble [Owen95] of a 32-bit fraction whose bits are given in reverse: flips of a digit
// depend on the digits above it only, so every elementary interval goes over into one of its size.
[[nodiscard]] constexpr std::uint32_t nested_scramble(std::uint32_t reversed, std::uint32_t shift,
                                                      std::uint32_t multiplier) {
  return reverse_bits(hash_upwards(reversed, shift, multiplier));
}

// Keys hold 64 random bits; multiplications spread them over the further seeds that a point needs.
[[nodiscard]] constexpr std::uint64_t multiplier_seeds(std::uint64_t key) {
  return key * 0xd1342543de82ef95ull;
}
[[nodiscard]] constexpr std::uint64_t second_shift_seeds(std::uint64_t key) {
  return key * 0xaf251af3b0f025b5ull;
}

// The number of an index, in the order that it has, as a 32-bit fraction: of the first dimension
// (van der Corput's), which has the digits of the index in reverse.
[[nodiscard]] constexpr std::uint32_t scrambled_number(std::uint32_t index, std::uint64_t key) {
  return nested_scramble(index, static_cast<std::uint32_t>(key >> 32),
                         static_cast<std::uint32_t>(multiplier_seeds(key) >> 32));
}
// Of a reversed index, in an order of its own.
[[nodiscard]] constexpr std::uint32_t scrambled_sobol_1d(std::uint32_t reversed_index,
                                                         std::uint64_t key) {
  return scrambled_number(shuffled_index(reversed_index, static_cast<std::uint32_t>(key)), key);
}

struct SobolPoint {
  std::uint32_t x;
  std::uint32_t y;
};
// The point of an index, in the order that it has.
[[nodiscard]] constexpr SobolPoint scrambled_pair(std::uint32_t index, std::uint64_t key) {
  const std::uint64_t multipliers = multiplier_seeds(key);
  return {nested_scramble(index, static_cast<std::uint32_t>(key >> 32),
                          static_cast<std::uint32_t>(multipliers >> 32)),
          nested_scramble(reversed_sobol_second(index),
                          static_cast<std::uint32_t>(second_shift_seeds(key) >> 32),
                          static_cast<std::uint32_t>(multipliers >> 24))};
}
// Of a reversed index, in an order of its own.
[[nodiscard]] constexpr SobolPoint scrambled_sobol_2d(std::uint32_t reversed_index,
                                                      std::uint64_t key) {
  return scrambled_pair(shuffled_index(reversed_index, static_cast<std::uint32_t>(key)), key);
}

// The same from an index, in [0, 1).
[[nodiscard]] constexpr float owen_sobol_1d(std::uint32_t index, std::uint64_t key) {
  return unit_float(scrambled_sobol_1d(reverse_bits(index), key));
}
[[nodiscard]] inline Vec2f owen_sobol_2d(std::uint32_t index, std::uint64_t key) {
  SobolPoint point = scrambled_sobol_2d(reverse_bits(index), key);
  return {unit_float(point.x), unit_float(point.y)};
}

}  // namespace candela
