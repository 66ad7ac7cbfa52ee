// The first two Sobol dimensions, shuffled and Owen-scrambled by hashing.
//
// Everything works on bit-reversed indices: the first dimension (van der Corput's) of an index is
// its reversal, so a sequence's order is shuffled and its points are scrambled without reversing
// any bits on the way. A call costs about 6 ns (2D) and 3 ns (1D); see docs/decisions.md.
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

// Shuffles the order of a sequence within every aligned block of a power of two, given and
// returning reversed indices: a hash whose lower bits do not depend on the higher ones [Laine11],
// by the constants of [Vegdahl21].
[[nodiscard]] constexpr std::uint32_t shuffle_reversed_index(std::uint32_t reversed_index,
                                                             std::uint32_t seed) {
  std::uint32_t x = reversed_index;
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// The second Sobol dimension's point, as a 32-bit fraction, of a reversed index. Its generator
// matrix is Pascal's triangle mod 2: the Kronecker power of [1 1; 0 1], so five shift-and-xor steps
// multiply by it.
[[nodiscard]] constexpr std::uint32_t sobol_second(std::uint32_t reversed_index) {
  std::uint32_t v = reversed_index;
  v ^= (v << 1) & 0xaaaaaaaau;
  v ^= (v << 2) & 0xccccccccu;
  v ^= (v << 4) & 0xf0f0f0f0u;
  v ^= (v << 8) & 0xff00ff00u;
  v ^= v << 16;
  return v;
}

// A nested scramble of a 32-bit fraction [Owen95]: flips of a digit depend on the digits above it
// only, so every elementary interval goes over into one of its size. All digits are flipped by
// `shift` (which alone makes points uniform), and those below the 1st, 4th and 8th by a
// multiplicative hash of all above: enough to give each stratum a jitter of its own, at half the
// full nested scramble's time. Variances of edges and smooth functions are within noise of that
// one's for 16 to 1024 samples; those of patterns with eight periods or so are higher, up to four
// times those of independent numbers (docs/decisions.md).
[[nodiscard]] constexpr std::uint32_t nested_scramble(std::uint32_t v, std::uint32_t shift,
                                                      std::uint32_t multiplier) {
  const std::uint32_t odd = multiplier | 1u;
  v ^= shift;
  v ^= ((v >> 31) * odd) >> 1;
  v ^= ((v >> 28) * odd) >> 4;
  v ^= ((v >> 24) * odd) >> 8;
  return v;
}

// Keys hold 64 random bits; multiplications spread them over the further seeds that a point needs.
[[nodiscard]] constexpr std::uint64_t multiplier_seeds(std::uint64_t key) {
  return key * 0xd1342543de82ef95ull;
}
[[nodiscard]] constexpr std::uint64_t second_shift_seeds(std::uint64_t key) {
  return key * 0xaf251af3b0f025b5ull;
}

// The number of a reversed index, in the order that it has, as a 32-bit fraction.
[[nodiscard]] constexpr std::uint32_t scrambled_number(std::uint32_t reversed_index,
                                                       std::uint64_t key) {
  return nested_scramble(reversed_index, static_cast<std::uint32_t>(key >> 32),
                         static_cast<std::uint32_t>(multiplier_seeds(key) >> 32));
}
// In an order of its own.
[[nodiscard]] constexpr std::uint32_t scrambled_sobol_1d(std::uint32_t reversed_index,
                                                         std::uint64_t key) {
  return scrambled_number(shuffle_reversed_index(reversed_index, static_cast<std::uint32_t>(key)),
                          key);
}

struct SobolPoint {
  std::uint32_t x;
  std::uint32_t y;
};
// The point of a reversed index, in the order that it has.
[[nodiscard]] constexpr SobolPoint scrambled_pair(std::uint32_t reversed_index, std::uint64_t key) {
  const std::uint64_t multipliers = multiplier_seeds(key);
  return {nested_scramble(reversed_index, static_cast<std::uint32_t>(key >> 32),
                          static_cast<std::uint32_t>(multipliers >> 32)),
          nested_scramble(sobol_second(reversed_index),
                          static_cast<std::uint32_t>(second_shift_seeds(key) >> 32),
                          static_cast<std::uint32_t>(multipliers >> 24))};
}
// In an order of its own.
[[nodiscard]] constexpr SobolPoint scrambled_sobol_2d(std::uint32_t reversed_index,
                                                      std::uint64_t key) {
  return scrambled_pair(shuffle_reversed_index(reversed_index, static_cast<std::uint32_t>(key)),
                        key);
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
