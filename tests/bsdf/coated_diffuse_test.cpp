// The coated Lambert surface against light followed bounce by bounce, and its delta lobe.
#include "renderer/bsdf/coated_diffuse.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/material/bsdf_at.h"
#include "renderer/sampling/hash.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/bsdf/layered_walk.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using tests::direction_of;
using tests::LayeredSurface;

struct Coated {
  CoatTable table;
  Bsdf bsdf;

  explicit Coated(const LayeredSurface& s)
      : table(static_cast<float>(s.eta), static_cast<float>(s.thickness),
              static_cast<float>(s.coat_alpha)) {
    const auto alpha = static_cast<float>(s.coat_alpha);
    bsdf = {.model = BsdfModel::CoatedDiffuse,
            .alpha = alpha,
            .diffuse =
                coated_reflectance(table, alpha, Rgb(static_cast<float>(s.reflectance)), s.bounces),
            .alpha_across = alpha,
            .coat = &table};
  }
};

constexpr std::uint64_t walks = 100'000;

// Means and errors of the two ways out.
struct Walked {
  statistics::Moments coat, below;
};
Walked walked(const LayeredSurface& surface, double cos_o) {
  Walked result;
  for (std::uint64_t i = 0; i < walks; ++i) {
    const tests::WalkEnd end = tests::walk_layers(surface, cos_o, i + 17);
    result.coat.add(end.coat);
    result.below.add(end.below);
  }
  return result;
}

// What interpolation in the table may be wrong by.
constexpr double table_error = 1e-3;

// By 5 errors: 200 comparisons.
void expect_albedo(const LayeredSurface& surface) {
  const Coated coated(surface);
  for (const float cos_o : {1.0f, 0.7f, 0.3f, 0.1f}) {
    const Walked expected = walked(surface, double{cos_o});
    const double found = double{coated_diffuse_albedo(coated.bsdf, cos_o).y};
    EXPECT_NEAR(found, expected.below.mean(), table_error + 5 * expected.below.standard_error())
        << fmt::format("alpha {} kd {} thickness {} bounces {} cosine {}", surface.coat_alpha,
                       surface.reflectance, surface.thickness, surface.bounces, cos_o);
  }
}

TEST(Agreement_CoatedDiffuse, AlbedoIsThatOfARandomWalk) {
  for (const double alpha : {0.0, 0.03, 0.1, 0.3, 1.0})
    for (const double reflectance : {0.2, 0.9})
      expect_albedo({.coat_alpha = alpha, .reflectance = reflectance});
}

TEST(Agreement_CoatedDiffuse, ThicknessDepthAndIndexCount) {
  expect_albedo({.thickness = 0, .reflectance = 0.9});
  expect_albedo({.coat_alpha = 0.2, .thickness = 0.5, .reflectance = 0.9});
  expect_albedo({.coat_alpha = 0.2, .bounces = 5, .reflectance = 0.9});
  expect_albedo({.bounces = 1, .reflectance = 0.9});
  expect_albedo({.eta = 2.4, .coat_alpha = 0.3, .reflectance = 0.6});
  expect_albedo({.eta = 1, .coat_alpha = 0, .thickness = 0, .reflectance = 0.6});
}

// The whole of it by its own samples, coat and below.
TEST(Agreement_CoatedDiffuse, SamplesBringWhatTheWalkBrings) {
  for (const double alpha : {0.0, 0.1, 0.5})
    for (const float cos_o : {0.9f, 0.2f}) {
      const LayeredSurface surface{.coat_alpha = alpha, .reflectance = 0.8};
      const Coated coated(surface);
      statistics::Moments found;
      for (std::uint64_t i = 0; i < walks; ++i) {
        const std::uint64_t bits = mix_bits(i + 3);
        const BsdfSample sample =
            sample_bsdf(coated.bsdf, direction_of(cos_o, 0.4f),
                        unit_float(static_cast<std::uint32_t>(mix_bits(bits))),
                        {unit_float(static_cast<std::uint32_t>(bits)),
                         unit_float(static_cast<std::uint32_t>(bits >> 32))});
        EXPECT_EQ(sample.is_delta, alpha == 0 && sample.pdf == 0);
        found.add(double{sample.weight.x});
      }
      const Walked expected = walked(surface, double{cos_o});
      const double error = std::hypot(found.standard_error(), expected.below.standard_error(),
                                      expected.coat.standard_error());
      EXPECT_NEAR(found.mean(), expected.below.mean() + expected.coat.mean(),
                  table_error + 5 * error)
          << alpha << " at " << cos_o;
    }
}

// Beside the delta lobe: the density of the others, times the chance that they are chosen.
TEST(Unit_CoatedDiffuse, SmoothCoatsLeaveTheirShareToTheDensity) {
  const Coated coated({.reflectance = 0.8});
  for (const float cos_o : {1.0f, 0.4f, 0.05f}) {
    const Vec3f wo = direction_of(cos_o, 0);
    std::uint32_t mirrored = 0;
    constexpr std::uint32_t count = 4096;
    for (std::uint32_t i = 0; i < count; ++i)
      mirrored += sample_bsdf(coated.bsdf, wo, (static_cast<float>(i) + 0.5f) / count, {0.3f, 0.4f})
                          .is_delta
                      ? 1
                      : 0;
    const double integral = statistics::integrate_sphere(
        [&](const Vec3f& wi) { return double{evaluate_bsdf(coated.bsdf, wo, wi).pdf}; }, {});
    EXPECT_NEAR(integral, 1 - static_cast<double>(mirrored) / count, 1.5 / count + 1e-4);
  }
  EXPECT_FALSE(is_only_delta(coated.bsdf));
}

// Rows of a table over all widths, and its own width's.
TEST(Unit_CoatTable, InterpolatesBetweenWidths) {
  const CoatTable all(1.5f, 0.01f, -1);
  for (const float alpha : {0.01f, 0.08f, 0.37f, 0.8f}) {
    const CoatTable own(1.5f, 0.01f, alpha);
    EXPECT_NEAR(all.internal_reflectance(alpha), own.internal_reflectance(alpha), 2e-3);
    for (const float cos_o : {1.0f, 0.5f, 0.2f, 0.05f})
      EXPECT_NEAR(all.transmittance(cos_o, alpha), own.transmittance(cos_o, alpha), 1e-2)
          << alpha << " at " << cos_o;
  }
}

TEST(Unit_BsdfAt, CoatsNarrowerThanFloatTellsAreSmooth) {
  Material material{.model = MaterialModel::CoatedDiffuse};
  material.coat = std::make_shared<const CoatTable>(1.5f, 0.01f, 0.0f);
  material.roughness.constant = 0.5f * smallest_ggx_width;
  EXPECT_EQ(bsdf_at(material, {}, {}, true).alpha, 0);
  material.roughness.constant = 2 * smallest_ggx_width;
  EXPECT_EQ(bsdf_at(material, {}, {}, true).alpha, 2 * smallest_ggx_width);
}

}  // namespace
}  // namespace candela
