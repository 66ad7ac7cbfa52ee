// The first two Sobol dimensions and Owen scrambling by hashing.
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

// The hash that keeps lower bits from depending on higher ones: applied to a bit-reversed number it
// is a nested uniform scramble [Laine11; the constants of Vegdahl21].
[[nodiscard]] constexpr std::uint32_t laine_karras_permutation(std::uint32_t x,
                                                               std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// The second Sobol dimension's point of `index`, bit-reversed (bit 0 is the first digit).
// Its generator matrix is Pascal's triangle mod 2: the Kronecker power of [1 1; 0 1], so five
// shift-and-xor steps multiply by it.
[[nodiscard]] constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
  std::uint32_t v = index;
  v ^= (v >> 1) & 0x55555555u;
  v ^= (v >> 2) & 0x33333333u;
  v ^= (v >> 4) & 0x0f0f0f0fu;
  v ^= (v >> 8) & 0x00ff00ffu;
  v ^= (v >> 16) & 0x0000ffffu;
  return v;
}

// Shuffles the order of a sequence within every aligned block of a power of two.
[[nodiscard]] constexpr std::uint32_t shuffle_index(std::uint32_t index, std::uint32_t seed) {
  return reverse_bits(laine_karras_permutation(reverse_bits(index), seed));
}

// The first dimension is van der Corput's, whose bit-reversed point is the index itself, so the
// shuffle's last reversal and the scramble's first cancel.
[[nodiscard]] constexpr std::uint32_t owen_sobol_1d_bits(std::uint32_t index, std::uint64_t key) {
  const std::uint32_t shuffled = shuffle_index(index, static_cast<std::uint32_t>(key));
  return reverse_bits(laine_karras_permutation(shuffled, static_cast<std::uint32_t>(key >> 32)));
}
[[nodiscard]] constexpr float owen_sobol_1d(std::uint32_t index, std::uint64_t key) {
  return unit_float(owen_sobol_1d_bits(index, key));
}

[[nodiscard]] inline Vec2f owen_sobol_2d(std::uint32_t index, std::uint64_t key) {
  const std::uint32_t shuffled = shuffle_index(index, static_cast<std::uint32_t>(key));
  const std::uint64_t seeds = mix_bits(key);
  const std::uint32_t x = laine_karras_permutation(shuffled, static_cast<std::uint32_t>(seeds));
  const std::uint32_t y = laine_karras_permutation(sobol_second_reversed(shuffled),
                                                   static_cast<std::uint32_t>(seeds >> 32));
  return {unit_float(reverse_bits(x)), unit_float(reverse_bits(y))};
}

}  // namespace candela
