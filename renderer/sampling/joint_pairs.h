// Which random numbers are points of one sequence of more than two dimensions.
//
// Where light arrives depends on several pairs at once: the place in the pixel and the place on the
// lamp, a direction and the place on the lamp that lights what it meets. Pairs that are shuffled
// independently of each other [Burley20] are well spread each, and together no better than chance.
// So the pairs of a path's first vertices take their (0,2)-sequences (sobol.h) in one shuffled
// order, each after multiplying the index by a matrix of its own over GF(2): an upper triangular
// one with a diagonal of ones, which permutes every aligned block of a power of two and so leaves a
// pair what it is, while pairs together are a digital sequence of four and more dimensions
// [Niederreiter92, chapter 4]. So does the number that chooses a lobe, or the directions of a lobe
// would be a random part of those of all. Deeper vertices' numbers stay independent.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "renderer/sampling/dimension.h"
#include "renderer/sampling/sobol.h"

namespace candela {

// Of an index these many lowest bits are multiplied: beyond a million points of a sequence, blocks
// of them follow one another in the same order.
inline constexpr std::uint32_t joint_bits = 20;

// Over GF(2). Of the product digit r, counted from the lowest bit of an index, is the parity of the
// index's bits in row r.
using BitMatrix = std::array<std::uint32_t, joint_bits>;

[[nodiscard]] constexpr BitMatrix product(const BitMatrix& a, const BitMatrix& b) {
  BitMatrix rows{};
  for (std::size_t r = 0; r < joint_bits; ++r)
    for (std::size_t k = 0; k < joint_bits; ++k)
      if ((a[r] >> k & 1) != 0) rows[r] ^= b[k];
  return rows;
}

// What each bit of an index, from the lowest, adds to the product.
using BitColumns = std::array<std::uint32_t, joint_bits>;

[[nodiscard]] constexpr BitColumns columns_of(const BitMatrix& matrix) {
  BitColumns columns{};
  for (std::size_t r = 0; r < joint_bits; ++r)
    for (std::size_t c = 0; c < joint_bits; ++c)
      if ((matrix[r] >> c & 1) != 0) columns[c] |= 1u << r;
  return columns;
}

// How many columns an index (or all whose union this is) may choose: none beyond its last bit.
[[nodiscard]] constexpr std::uint32_t needed_columns(std::uint32_t index) {
  return std::min(static_cast<std::uint32_t>(std::bit_width(index)), joint_bits);
}
// What a product takes over from the bits beyond the matrix, and what it has from column c.
[[nodiscard]] constexpr std::uint32_t untouched_part(std::uint32_t index) {
  return index & (0xffffffffu << joint_bits);
}
[[nodiscard]] constexpr std::uint32_t chosen_column(std::uint32_t index, std::uint32_t c,
                                                    std::uint32_t column) {
  return (index & 1u << c) != 0 ? column : 0;
}
[[nodiscard]] constexpr std::uint32_t multiplied(std::uint32_t index, const BitColumns& columns) {
  std::uint32_t product = untouched_part(index);
  const std::uint32_t needed = needed_columns(index);
  for (std::uint32_t c = 0; c < needed; ++c) product ^= chosen_column(index, c, columns[c]);
  return product;
}

// The order of joint pairs, of a reversed index: shuffled, and counted from where the first point
// went, so that few points have small indices.
[[nodiscard]] constexpr std::uint32_t joint_index(std::uint32_t reversed_index,
                                                  std::uint32_t seed) {
  return reverse_bits(shuffle_reversed_index(reversed_index, seed) ^
                      shuffle_reversed_index(0, seed));
}

// From a vertex's pair of the ray that reaches it (the camera's: the place in the pixel; else the
// direction) to its light sample's, to its direction's, and to the number that chooses its lobe.
// Found by search: the variance of edges, ramps, bells and ridges over the numbers that meet in a
// path, at 16, 64 and 256 points, in which the first eight columns matter; of those after them, how
// many elementary intervals are hit (docs/decisions.md).
inline constexpr BitMatrix to_light_point = {
    0x13a6d, 0x34fb6, 0x7e384, 0x218c8, 0xb6cd0, 0x04d60, 0x5fd40, 0x96780, 0xd6300, 0x9c600,
    0xdb400, 0xa2800, 0x9b000, 0xc6000, 0x9c000, 0x48000, 0x70000, 0x60000, 0x40000, 0x80000};
inline constexpr BitMatrix to_direction = {
    0x6ce5d, 0xe537a, 0x318d4, 0xb6168, 0x84470, 0x4f7a0, 0x85f40, 0x1a680, 0xd9d00, 0xdc200,
    0x74c00, 0x2a800, 0x0d000, 0x06000, 0x9c000, 0x58000, 0x70000, 0x60000, 0xc0000, 0x80000};
inline constexpr BitMatrix to_lobe_choice = {
    0x12b65, 0xf5e86, 0x6fa54, 0x06318, 0x7c3f0, 0xf9ee0, 0x56fc0, 0x80d80, 0x89b00, 0x49a00,
    0xa0400, 0x08800, 0x71000, 0x46000, 0x7c000, 0xa8000, 0x70000, 0x60000, 0x40000, 0x80000};

// The first vertices of a path, whose numbers are joint.
inline constexpr std::uint32_t joint_bounces = 4;

struct JointMatrices {
  std::array<BitColumns, joint_bounces> light_points;
  std::array<BitColumns, joint_bounces> directions;
  std::array<BitColumns, joint_bounces> lobe_choices;
};
[[nodiscard]] constexpr JointMatrices joint_matrices_of_path() {
  JointMatrices matrices{};
  BitMatrix arriving{};  // of the ray that reaches the vertex: the identity for the camera's
  for (std::size_t r = 0; r < joint_bits; ++r) arriving[r] = 1u << r;
  for (std::size_t bounce = 0; bounce < joint_bounces; ++bounce) {
    matrices.light_points[bounce] = columns_of(product(to_light_point, arriving));
    matrices.lobe_choices[bounce] = columns_of(product(to_lobe_choice, arriving));
    arriving = product(to_direction, arriving);
    matrices.directions[bounce] = columns_of(arriving);
  }
  return matrices;
}
inline constexpr JointMatrices joint_matrices = joint_matrices_of_path();

// The pair in whose order all joint numbers are shuffled.
inline constexpr Dimension joint_order = Dimension::Filter;

// The matrix of what is joint with those before it; null for what has an order of its own.
[[nodiscard]] constexpr const BitColumns* joint_matrix(std::uint32_t bounce, Dimension dimension) {
  if (bounce >= joint_bounces) return nullptr;
  if (dimension == Dimension::LightPoint) return &joint_matrices.light_points[bounce];
  if (dimension == Dimension::Direction) return &joint_matrices.directions[bounce];
  if (dimension == Dimension::LobeChoice) return &joint_matrices.lobe_choices[bounce];
  return nullptr;
}

}  // namespace candela
