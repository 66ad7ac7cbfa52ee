// The coated metal against light followed bounce by bounce.
#include "renderer/bsdf/coated_conductor.h"

#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/hash.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/bsdf/layered_walk.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using tests::direction_of;

// The green channel's metal of bsdf_cases.h.
tests::LayeredSurface layers_of(double coat_alpha, double metal_alpha) {
  const Bsdf metal = tests::conductor(0.1f);
  return {.coat_alpha = coat_alpha,
          .metal = std::complex<double>(double{metal.eta.y}, -double{metal.k.y}),
          .metal_alpha = metal_alpha};
}

int walks() {
  return std::getenv("CANDELA_HEAVY") != nullptr ? 1'000'000 : 100'000;
}

statistics::Moments walked(const tests::LayeredSurface& surface, double cos_o) {
  statistics::Moments moments;
  for (int i = 0; i < walks(); ++i) {
    const tests::WalkEnd end =
        tests::walk_layers(surface, cos_o, static_cast<std::uint64_t>(i) + 29);
    moments.add(end.coat + end.below);
  }
  return moments;
}

statistics::Moments sampled(const Bsdf& bsdf, const Vec3f& wo) {
  statistics::Moments moments;
  for (int i = 0; i < walks(); ++i) {
    const std::uint64_t bits = mix_bits(static_cast<std::uint64_t>(i) + 3);
    const BsdfSample sample =
        sample_bsdf(bsdf, wo, unit_float(static_cast<std::uint32_t>(mix_bits(bits))),
                    {unit_float(static_cast<std::uint32_t>(bits)),
                     unit_float(static_cast<std::uint32_t>(bits >> 32))});
    moments.add(double{sample.weight.y});
  }
  return moments;
}

// Two layers of any width: the whole albedo, within 2 % and five errors.
TEST(Agreement_CoatedConductor, AlbedoIsThatOfARandomWalk) {
  statistics::Moments differences;
  for (const double coat : {0.0, 0.05, 0.2, 0.6})
    for (const double metal : {0.0, 0.05, 0.2, 0.6}) {
      const Bsdf bsdf =
          tests::coated_conductor(static_cast<float>(coat), static_cast<float>(metal));
      for (const float cos_o : {1.0f, 0.7f, 0.3f, 0.1f}) {
        const statistics::Moments expected = walked(layers_of(coat, metal), double{cos_o});
        const statistics::Moments found = sampled(bsdf, direction_of(cos_o, 0.4f));
        const double error = std::hypot(expected.standard_error(), found.standard_error());
        EXPECT_NEAR(found.mean(), expected.mean(), 0.02 * expected.mean() + 5 * error)
            << fmt::format("coat {} metal {} cosine {}", coat, metal, cos_o);
        differences.add(std::abs(found.mean() - expected.mean()) / expected.mean());
        RecordProperty(fmt::format("coat {} metal {} cosine {}", coat, metal, cos_o),
                       fmt::format("{:+.4f} +- {:.4f}", found.mean() / expected.mean() - 1,
                                   error / expected.mean()));
      }
    }
  EXPECT_LT(differences.mean(), 0.01);
  RecordProperty("mean_relative_difference", fmt::format("{:.4f}", differences.mean()));
}

TEST(Unit_CoatedConductor, SmoothLayersAreOneMirror) {
  const Bsdf bsdf = tests::coated_conductor(0, 0);
  EXPECT_TRUE(is_only_delta(bsdf));
  for (const float cos_o : {1.0f, 0.4f, 0.05f}) {
    const BsdfSample sample = sample_bsdf(bsdf, direction_of(cos_o, 1), 0.3f, {0.1f, 0.2f});
    ASSERT_TRUE(sample.is_delta);
    const statistics::Moments expected = walked(layers_of(0, 0), double{cos_o});
    EXPECT_NEAR(sample.weight.y, expected.mean(), 1e-3 + 5 * expected.standard_error());
  }
}

TEST(Unit_CoatedConductor, DirectionsOutOfAnyCoatAreUnit) {
  for (const float eta : {1.5f, 10.0f, 1000.0f}) {
    const CoatTable table(eta, 0, 0);
    Bsdf bsdf = tests::conductor(0.3f);
    bsdf.model = BsdfModel::CoatedConductor;
    bsdf.coat = &table;
    bsdf.metal_widths = Vec2f(0.3f);
    int count = 0;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
      const std::uint64_t bits = mix_bits(i);
      const Vec2f u(unit_float(static_cast<std::uint32_t>(bits)),
                    unit_float(static_cast<std::uint32_t>(bits >> 32)));
      const Vec3f wi = sample_coated_metal(bsdf, direction_of(0.8f, 0), u);
      if (!(wi.z > 0)) continue;
      ++count;
      ASSERT_NEAR(length(wi), 1, 1e-6f) << eta;
    }
    EXPECT_GT(count, 0) << eta;
  }
}

// Where nothing bends it, light that comes in edge-on meets the metal edge-on.
TEST(Unit_CoatedConductor, IsFiniteEdgeOnUnderACoatThatHardlyRefracts) {
  for (const float eta : {1.0f, 1.0000001f, 1.0001f}) {
    const CoatTable table(eta, 0, 0);
    Bsdf bsdf = tests::conductor(0.3f);
    bsdf.model = BsdfModel::CoatedConductor;
    bsdf.alpha = bsdf.alpha_across = 0;
    bsdf.coat = &table;
    bsdf.metal_widths = Vec2f(0.3f);
    for (const float cos_o : {1e-2f, 1e-4f, 1e-6f, 1e-12f})
      for (const float cos_i : {1.0f, 1e-4f, 1e-12f}) {
        const Vec3f wo = direction_of(cos_o, 0);
        const Vec3f wi = direction_of(cos_i, 3);
        const BsdfEvaluation there = evaluate_bsdf(bsdf, wo, wi);
        const BsdfEvaluation back = evaluate_bsdf(bsdf, wi, wo);
        ASSERT_TRUE(is_finite(there.value) && std::isfinite(there.pdf)) << eta << ' ' << cos_o;
        EXPECT_NEAR(there.value.y * cos_o, back.value.y * cos_i, 1e-6f * there.value.y * cos_o);
      }
  }
}

}  // namespace
}  // namespace candela
