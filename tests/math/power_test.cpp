// Powers by polynomials against the library's, in double.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "renderer/math/transcendental.h"

namespace candela {
namespace {

double relative_error(float found, double expected) {
  return std::abs(static_cast<double>(found) - expected) / expected;
}

double largest_error(double exponent, std::uint32_t from_bits, std::uint32_t to_bits) {
  double largest = 0;
  for (std::uint32_t bits = from_bits; bits < to_bits; bits += 1009) {
    const auto x = std::bit_cast<float>(bits);
    const double expected = std::pow(static_cast<double>(x), exponent);
    if (expected < 1.2e-38 || expected > 3.4e38) continue;
    largest = std::max(largest, relative_error(power(x, exponent), expected));
  }
  return largest;
}

TEST(Unit_Power, StaysWithinItsStatedErrorOverAllMagnitudes) {
  const auto smallest = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::min());
  const auto largest = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::max());
  for (const double exponent : {2.2, 2.4, 1 / 2.2, 0.5, 4.0})
    EXPECT_LT(largest_error(exponent, smallest, largest), 1e-7) << exponent;
}

TEST(Unit_Power, LogarithmAndExponentialStayWithinTheirs) {
  double logarithm_error = 0;
  double exponential_error = 0;
  for (int i = 1; i < 200000; ++i) {
    const double x = i * 1e-5 * i;
    logarithm_error = std::max(logarithm_error, std::abs(binary_logarithm(x) - std::log2(x)));
    const double y = (i - 100000) * 1e-3;
    exponential_error =
        std::max(exponential_error, std::abs(binary_exponential(y) / std::exp2(y) - 1));
  }
  EXPECT_LT(logarithm_error, 1e-10);
  EXPECT_LT(exponential_error, 1e-9);
}

TEST(Unit_Power, EndsAreExact) {
  EXPECT_EQ(power(1, 2.2), 1);
  EXPECT_EQ(power(0, 2.2), 0);
  EXPECT_EQ(power(-1, 2.2), 0);
  EXPECT_EQ(power(std::numeric_limits<float>::quiet_NaN(), 2.2), 0);
  EXPECT_EQ(power(1e-30f, 2.2), 0);
  EXPECT_EQ(power(1e30f, 2.2), std::numeric_limits<float>::infinity());
}

TEST(Unit_Power, NeverFallsAsItsBaseRises) {
  float earlier = 0;
  for (int i = 0; i <= 65535; ++i) {
    const float value = power(static_cast<float>(i) / 65535.0f, 2.2);
    ASSERT_GE(value, earlier) << i;
    earlier = value;
  }
}

}  // namespace
}  // namespace candela
