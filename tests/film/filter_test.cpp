#include "renderer/film/filter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/math/constants.h"
#include "renderer/sampling/hash.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

constexpr FilterKind all_kinds[] = {
    FilterKind::Box,      FilterKind::Gaussian, FilterKind::BlackmanHarris,
    FilterKind::Triangle, FilterKind::Mitchell, FilterKind::Sinc};

double sinc(double x) {
  return x == 0 ? 1 : std::sin(pi_double * x) / (pi_double * x);
}

// [Mitchell88, eq. 8] for any B and C, over two units.
double mitchell(double t, double b, double c) {
  t = std::abs(t);
  if (t < 1) return (12 - 9 * b - 6 * c) * t * t * t + (-18 + 12 * b + 6 * c) * t * t + 6 - 2 * b;
  return (-b - 6 * c) * t * t * t + (6 * b + 30 * c) * t * t + (-12 * b - 48 * c) * t + 8 * b +
         24 * c;
}

// Not normalised, from its definition.
double weight(FilterKind kind, double x, double r) {
  if (kind == FilterKind::Gaussian) return std::exp(-x * x / 0.5) - std::exp(-r * r / 0.5);
  if (kind == FilterKind::Box) return 1;
  if (kind == FilterKind::Triangle) return std::max(0.0, r - std::abs(x));
  if (kind == FilterKind::Mitchell) return mitchell(2 * x / r, 1.0 / 3, 1.0 / 3);
  if (kind == FilterKind::Sinc) return sinc(x) * sinc(x / 3);
  const double p = pi_double * (x / r + 1);
  return 0.35875 - 0.48829 * std::cos(p) + 0.14128 * std::cos(2 * p) - 0.01168 * std::cos(3 * p);
}

double size(FilterKind kind, double x, double r) {
  return std::abs(weight(kind, x, r));
}

// The variance of a filter's position, by quadrature.
double variance_of(FilterKind kind, double r) {
  double sum = 0, moment = 0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double x = r * ((2.0 * i + 1) / steps - 1);
    const double w = size(kind, x, r);
    sum += w;
    moment += w * x * x;
  }
  return moment / sum;
}

TEST(Unit_Filter, SamplesFollowTheFilter) {
  for (const FilterKind kind : all_kinds) {
    const Filter filter(kind, default_radius(kind));
    double mean = 0, moment = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
      const double x = filter.sample({(static_cast<float>(i) + 0.5f) / count, 0.5f}).x;
      EXPECT_LE(std::abs(x), filter.radius());
      mean += x / count;
      moment += x * x / count;
    }
    EXPECT_NEAR(mean, 0, 1e-5);
    // The table's 1024 straight pieces are the filter that is used; they miss the ideal by < 1 %.
    EXPECT_NEAR(moment / variance_of(kind, filter.radius()), 1, 0.01);
  }
}

// Places that cut the filter into `count` parts of equal weight.
std::vector<double> quantiles(FilterKind kind, double r, int count) {
  constexpr int steps = 200000;
  std::vector<double> sums{0};
  for (int i = 0; i < steps; ++i)
    sums.push_back(sums.back() + size(kind, r * ((2.0 * i + 1) / steps - 1), r));
  std::vector<double> cuts;
  for (int k = 1; k < count; ++k) {
    const auto at = std::ranges::lower_bound(sums, sums.back() * k / count);
    cuts.push_back(r * (2 * static_cast<double>(at - sums.begin()) / steps - 1));
  }
  return cuts;
}

TEST(Statistical_Filter, PlacesFollowTheFilter) {
  constexpr std::size_t parts = 32;
  constexpr int count = 1'000'000;
  for (const FilterKind kind : all_kinds) {
    const Filter filter(kind, default_radius(kind));
    const std::vector<double> cuts = quantiles(kind, filter.radius(), parts);
    const auto part = [&](float x) {
      return static_cast<std::size_t>(std::ranges::upper_bound(cuts, double{x}) - cuts.begin());
    };
    std::vector<double> observed(parts * parts, 0);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t bits = mix_bits(i + 5);
      const Vec2f place = filter.sample({unit_float(static_cast<std::uint32_t>(bits)),
                                         unit_float(static_cast<std::uint32_t>(bits >> 32))});
      observed[part(place.y) * parts + part(place.x)] += 1;
    }
    const std::vector<double> expected(parts * parts, double{count} / (parts * parts));
    EXPECT_GT(statistics::chi_square_test(observed, expected).p_value,
              statistics::sidak_level(0.01, std::size(all_kinds)))
        << static_cast<int>(kind);
  }
}

// A filter far wider than its bell sends no more samples to its tails than the bell has there.
TEST(Unit_Filter, TailsAreThoseOfTheBell) {
  constexpr double sigma = 0.5;
  for (const float radius : {4.0f, 8.0f, 16.0f}) {
    const Filter filter(FilterKind::Gaussian, radius);
    for (int power = 1; power <= 18; ++power) {
      const auto u = static_cast<float>(std::ldexp(1.0, -power));
      const double x = double{filter.sample({u, 0.5f}).x};
      EXPECT_NEAR(std::erfc(-x / (sigma * std::sqrt(2))) / 2 / double{u}, 1, 0.05)
          << radius << " " << power;
      EXPECT_EQ(filter.sample({0.5f, 1 - u}).y, static_cast<float>(-x));
    }
  }
}

// Of a radius other than its own, in closed form: its inverse distribution.
TEST(Unit_Filter, TriangleOfAnyRadius) {
  for (const float radius : {0.5f, 1.0f, 2.5f}) {
    const Filter filter(FilterKind::Triangle, radius);
    for (const float u : {0.02f, 0.125f, 0.3f, 0.5f})
      EXPECT_NEAR(filter.sample({u, 0.5f}).x, radius * (std::sqrt(2 * u) - 1), 2e-3f * radius);
  }
}

TEST(Unit_Filter, OfTinyRadiiThereIsOneToo) {
  for (const FilterKind kind : all_kinds)
    for (const float radius : {1e-6f, 1e-10f, 1e-30f}) {
      const Filter filter(kind, radius);
      for (const float u : {0.01f, 0.25f, 0.5f, 0.75f, 0.99f}) {
        const float x = filter.sample({u, 0.5f}).x;
        EXPECT_TRUE(std::abs(x) <= radius && (x < 0) == (u < 0.5f)) << x << ", " << radius;
      }
    }
  // A bell that is so narrow is a parabola: half of it lies within .347 of its radius.
  EXPECT_NEAR(Filter(FilterKind::Gaussian, 1e-7f).sample({0.25f, 0.5f}).x / 1e-7f, -0.347f, 1e-3f);
}

TEST(Unit_Filter, ABoxWithoutAWidthIsTheMiddle) {
  const Filter middle(FilterKind::Box, 0);
  EXPECT_EQ(middle.sample({0.9f, 0.1f}), Vec2f(0));
  const FilterPart around = middle.part_within({{-1, -1}, {1, 1}});
  EXPECT_EQ(around.size, Vec2f(1));
  EXPECT_EQ(middle.part_within({{1, -1}, {2, 1}}).size, Vec2f(0));
}

// What a pixel shows of a picture whose light is cos(k x): the filter's own transform, for
// frequencies up to what pixels can hold. At k = 0 it is the mean of the weights: 1.
TEST(Unit_Filter, SignedWeightsMakeTheFilter) {
  for (const FilterKind kind : all_kinds) {
    const Filter filter(kind, default_radius(kind));
    const double r = filter.radius();
    EXPECT_EQ(filter.is_signed(), kind == FilterKind::Mitchell || kind == FilterKind::Sinc);
    for (const double k : {0.0, 1.0, 2.0, pi_double}) {
      constexpr int count = 1 << 16;
      double sum = 0, exact = 0, all = 0;
      for (int i = 0; i < count; ++i) {
        const double x = double{filter.sample({(static_cast<float>(i) + 0.5f) / count, 0.5f}).x};
        // On the axis; the weight of x = 0 is known by it.
        const Vec2f place(static_cast<float>(x), 0);
        sum += std::cos(k * x) * double{filter.weight(place) / std::sqrt(filter.weight({0, 0}))};
        const double y = r * ((2.0 * i + 1) / count - 1);
        exact += std::cos(k * y) * weight(kind, y, r);
        all += weight(kind, y, r);
      }
      EXPECT_NEAR(sum / count, exact / all, k == 0 ? 1e-4 : 5e-3) << static_cast<int>(kind) << k;
    }
  }
}

TEST(Unit_Filter, ChangesItsSignWhereItIsZero) {
  for (const FilterKind kind : {FilterKind::Mitchell, FilterKind::Sinc})
    for (float x = -3.999f; x < 4; x += 0.01f) {
      const Filter filter(kind, 4);
      const double f = weight(kind, double{x}, 4);
      if (std::abs(f) > 1e-4) {
        EXPECT_EQ(filter.weight({x, 0}) > 0, f > 0) << x;
      }
    }
}

TEST(Unit_Filter, IsSymmetric) {
  const Filter filter(FilterKind::BlackmanHarris, 1.5f);
  for (int i = 1; i < 64; ++i) {
    const float u = static_cast<float>(i) / 64;
    EXPECT_NEAR(filter.sample({u, u}).x, -filter.sample({1 - u, u}).x, 1e-5);
  }
}

// By numbers on a grid: those of the part have their places in the rectangle, the others not, but
// for what rounding allows.
TEST(Unit_Filter, APartHoldsTheNumbersOfARectangle) {
  constexpr int n = 200;
  for (const FilterKind kind : {FilterKind::Box, FilterKind::Gaussian, FilterKind::Triangle}) {
    const Filter filter(kind, default_radius(kind));
    const Bounds<Vec2d> rectangle{{-0.31, 0.1}, {0.07, 0.44}};
    const FilterPart part = filter.part_within(rectangle);
    int inside = 0;
    for (int i = 0; i < n * n; ++i) {
      const Vec2f u{(static_cast<float>(i % n) + 0.5f) / n, (static_cast<float>(i / n) + 0.5f) / n};
      const Vec2d place(filter.sample(u));
      const bool is_in_part = glm::all(glm::greaterThanEqual(u, part.first)) &&
                              glm::all(glm::lessThanEqual(u, part.first + part.size));
      const bool is_in_rectangle = glm::all(glm::greaterThanEqual(place, rectangle.lower)) &&
                                   glm::all(glm::lessThanEqual(place, rectangle.upper));
      EXPECT_EQ(is_in_part, is_in_rectangle) << u.x << " " << u.y;
      inside += is_in_rectangle;
    }
    EXPECT_NEAR(static_cast<double>(part.share()), static_cast<double>(inside) / (n * n), 0.01);
  }
}

TEST(Unit_Filter, PartsOfAllAndOfNothing) {
  const Filter filter(FilterKind::Gaussian, 1.5f);
  EXPECT_TRUE(filter.part_within({Vec2d(-2), Vec2d(1.5)}).is_whole());
  EXPECT_EQ(filter.part_within({Vec2d(-2), Vec2d(1.5)}).first, Vec2f(0));
  EXPECT_EQ(filter.part_within({{1.5, -1}, {3, 1}}).share(), 0);
  EXPECT_EQ(filter.part_within({{-3, -1}, {-1.5, 1}}).share(), 0);
  EXPECT_EQ(filter.part_within({}).share(), 0);
}

}  // namespace
}  // namespace candela
