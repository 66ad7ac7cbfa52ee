// Integer hashes that turn coordinates into random-looking bits.
#pragma once

#include <cstdint>

namespace candela {

// A bijection of 64 bits with full avalanche (the finaliser of splitmix64, "variant 13" of
// [Stafford11]).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t v) {
  v ^= v >> 30;
  v *= 0xbf58476d1ce4e5b9ull;
  v ^= v >> 27;
  v *= 0x94d049bb133111ebull;
  v ^= v >> 31;
  return v;
}

[[nodiscard]] constexpr std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b) {
  return mix_bits(a + 0x9e3779b97f4a7c15ull * (b + 1));
}

[[nodiscard]] constexpr std::uint64_t hash_pixel(std::uint64_t seed, std::uint32_t x,
                                                 std::uint32_t y) {
  return hash_combine(mix_bits(seed ^ 0x5851f42d4c957f2dull), (std::uint64_t{y} << 32) | x);
}

// Random bits of the n-th of many streams that share one key; half the cost of hash_combine. A full
// product folded onto itself, as in wyhash [Wang20].
[[nodiscard]] constexpr std::uint64_t hash_counter(std::uint64_t key, std::uint64_t n) {
  const std::uint64_t a = key + 0x9e3779b97f4a7c15ull * (n + 1);
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * (a ^ 0xa0761d6478bd642full);
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

// 32 random bits -> [0, 1): the upper 24 bits, so that 1 is never reached.
[[nodiscard]] constexpr float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

}  // namespace candela
