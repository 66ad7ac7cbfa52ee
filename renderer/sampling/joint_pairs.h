// Which pairs of random numbers are points of one sequence of more than two dimensions.
//
// Where light arrives depends on several pairs at once: the place in the pixel and the place on the
// lamp, a direction and the place on the lamp that lights what it meets. Pairs that are shuffled
// independently of each other [Burley20] are well spread each, and together no better than chance.
// So the pairs of a path's first vertices take their (0,2)-sequences (sobol.h) in one shuffled
// order, each after multiplying the index by a matrix of its own over GF(2): an upper triangular
// one with a diagonal of ones, which permutes every aligned block of a power of two and so leaves a
// pair what it is, while pairs together are a digital sequence of four and more dimensions
// [Niederreiter92, chapter 4]. Deeper vertices' pairs stay independent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/sampling/dimension.h"

namespace candela {

// Of an index these many lowest bits are multiplied: beyond 4096 points of a sequence, blocks of
// them follow one another in the same order.
inline constexpr std::uint32_t joint_bits = 12;

// Over GF(2). Of the product digit r, counted from the lowest bit of an index, is the parity of the
// index's bits in row r.
using BitMatrix = std::array<std::uint16_t, joint_bits>;

[[nodiscard]] constexpr BitMatrix product(const BitMatrix& a, const BitMatrix& b) {
  BitMatrix rows{};
  for (std::size_t r = 0; r < joint_bits; ++r)
    for (std::size_t k = 0; k < joint_bits; ++k)
      if ((a[r] >> k & 1) != 0) rows[r] = static_cast<std::uint16_t>(rows[r] ^ b[k]);
  return rows;
}

// What each bit of a reversed index, from the highest, adds to the reversed product.
using ReversedColumns = std::array<std::uint32_t, joint_bits>;

[[nodiscard]] constexpr ReversedColumns reversed_columns(const BitMatrix& matrix) {
  ReversedColumns columns{};
  for (std::size_t r = 0; r < joint_bits; ++r)
    for (std::size_t c = 0; c < joint_bits; ++c)
      if ((matrix[r] >> c & 1) != 0) columns[c] |= 0x80000000u >> r;
  return columns;
}

// What a product takes over from the bits beyond the matrix, and what it has from column c.
[[nodiscard]] constexpr std::uint32_t untouched_part(std::uint32_t reversed_index) {
  return reversed_index & (0xffffffffu >> joint_bits);
}
[[nodiscard]] constexpr std::uint32_t chosen_column(std::uint32_t reversed_index, std::uint32_t c,
                                                    std::uint32_t column) {
  return (0u - (reversed_index >> (31 - c) & 1u)) & column;
}
[[nodiscard]] constexpr std::uint32_t multiplied(std::uint32_t reversed_index,
                                                 const ReversedColumns& columns) {
  std::uint32_t product = untouched_part(reversed_index);
  for (std::uint32_t c = 0; c < joint_bits; ++c)
    product ^= chosen_column(reversed_index, c, columns[c]);
  return product;
}

// From a vertex's pair of the ray that reaches it (the camera's: the place in the pixel; else the
// direction) to its light sample's, and to its direction's. Found by search: the variance of random
// half spaces, bells and ramps over the pairs that meet in a path, at 16, 64 and 256 points
// (docs/decisions.md).
inline constexpr BitMatrix to_light_point = {0x36d, 0xe7a, 0x7c4, 0xaf8, 0x5d0, 0x5e0,
                                             0x8c0, 0x980, 0x700, 0x600, 0xc00, 0x800};
inline constexpr BitMatrix to_direction = {0xbad, 0x65e, 0x04c, 0xeb8, 0x5d0, 0xca0,
                                           0x840, 0xb80, 0x900, 0xa00, 0x400, 0x800};

// The first vertices of a path, whose pairs are joint.
inline constexpr std::uint32_t joint_bounces = 4;

struct JointMatrices {
  std::array<ReversedColumns, joint_bounces> light_points;
  std::array<ReversedColumns, joint_bounces> directions;
};
[[nodiscard]] constexpr JointMatrices joint_matrices_of_path() {
  JointMatrices matrices{};
  BitMatrix arriving{};  // of the ray that reaches the vertex: the identity for the camera's
  for (std::size_t r = 0; r < joint_bits; ++r) arriving[r] = static_cast<std::uint16_t>(1u << r);
  for (std::size_t bounce = 0; bounce < joint_bounces; ++bounce) {
    matrices.light_points[bounce] = reversed_columns(product(to_light_point, arriving));
    arriving = product(to_direction, arriving);
    matrices.directions[bounce] = reversed_columns(arriving);
  }
  return matrices;
}
inline constexpr JointMatrices joint_matrices = joint_matrices_of_path();

// The pair in whose order all joint pairs are shuffled.
inline constexpr Dimension joint_order = Dimension::Filter;

// The matrix of a pair that is joint with those before it; null where it has an order of its own.
[[nodiscard]] constexpr const ReversedColumns* joint_matrix(std::uint32_t bounce,
                                                            Dimension dimension) {
  if (bounce >= joint_bounces) return nullptr;
  if (dimension == Dimension::LightPoint) return &joint_matrices.light_points[bounce];
  if (dimension == Dimension::Direction) return &joint_matrices.directions[bounce];
  return nullptr;
}

}  // namespace candela
