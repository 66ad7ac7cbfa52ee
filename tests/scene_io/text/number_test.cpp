#include "scene_io/text/number.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "renderer/base/floating_point_traps.h"

namespace candela::text {
namespace {

TEST(Unit_Number, ReadsWhatIsANumber) {
  const std::vector<std::pair<std::string_view, double>> cases{
      {"0", 0.0},
      {"-0.0", -0.0},
      {"1", 1.0},
      {"+1", 1.0},
      {"1.", 1.0},
      {".5", 0.5},
      {"-.5", -0.5},
      {"2e5", 2e5},
      {"1E-3", 1e-3},
      {"1e+3", 1e3},
      {"0.1", 0.1},
      {"1e-400", 0.0},
      {"-1e-999999", 0.0},
      {"1e-324", 0.0},
      {"0e999999", 0.0},
      {"1.7976931348623157e308", std::numeric_limits<double>::max()},
      {"4.9406564584124654e-324", std::numeric_limits<double>::denorm_min()},
  };
  for (const auto& [word, value] : cases) {
    const Number<double> number = parse_double(word);
    EXPECT_EQ(number.fault, NumberFault::None) << word;
    EXPECT_EQ(number.value, value) << word;
  }
}

TEST(Unit_Number, SaysWhatIsNone) {
  const std::vector<std::pair<std::string_view, NumberFault>> cases{
      {"", NumberFault::Malformed},        {"+", NumberFault::Malformed},
      {"-", NumberFault::Malformed},       {"+-1", NumberFault::Malformed},
      {"++1", NumberFault::Malformed},     {"1x", NumberFault::Malformed},
      {"1,5", NumberFault::Malformed},     {"1e", NumberFault::Malformed},
      {"0x10", NumberFault::Malformed},    {".", NumberFault::Malformed},
      {"nan", NumberFault::NotFinite},     {"-NaN", NumberFault::NotFinite},
      {"inf", NumberFault::NotFinite},     {"-Infinity", NumberFault::NotFinite},
      {"1.#QNAN", NumberFault::NotFinite}, {"-1.#IND", NumberFault::NotFinite},
      {"1e309", NumberFault::TooLarge},    {"-1e99999999999999999999", NumberFault::TooLarge},
      {"12e308", NumberFault::TooLarge},
  };
  for (const auto& [word, fault] : cases) EXPECT_EQ(parse_double(word).fault, fault) << word;
}

TEST(Unit_Number, AMillionDigitsAreOneNumber) {
  const std::string zeros(1'000'000, '0');
  EXPECT_EQ(parse_double("1" + zeros).fault, NumberFault::TooLarge);
  EXPECT_EQ(parse_double("0." + zeros + "1").value, 0.0);
  EXPECT_TRUE(parse_double("0." + zeros + "1"));
  EXPECT_EQ(parse_double("1" + zeros + "e-50").fault, NumberFault::TooLarge);
  EXPECT_TRUE(parse_double("0." + zeros + "1e50"));
  EXPECT_EQ(parse_double("1." + zeros + "e2").value, 100.0);
  EXPECT_EQ(parse_double(zeros + "7").value, 7.0);
}

TEST(Unit_Number, DoublesComeBackFromTheirShortestForm) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(parse_double(fmt::format("{}", value)).value, value);
  }
}

TEST(Unit_Number, Integers) {
  EXPECT_EQ(parse_integer("-12").value, -12);
  EXPECT_EQ(parse_integer("+9223372036854775807").value, INT64_MAX);
  EXPECT_EQ(parse_integer("9223372036854775808").fault, NumberFault::TooLarge);
  EXPECT_EQ(parse_integer("1.0").fault, NumberFault::Malformed);
  EXPECT_EQ(parse_integer("").fault, NumberFault::Malformed);
}

}  // namespace
}  // namespace candela::text
