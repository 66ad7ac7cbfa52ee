#include "renderer/sampling/drawable_probability.h"

#include <cmath>

#include <gtest/gtest.h>

#include "integrators/path/path_step.h"
#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

constexpr std::uint32_t all_numbers = 1u << 24;

float number(std::uint32_t i) {
  return unit_float(i << 8);
}

TEST(Unit_DrawableProbability, IsTheNextThatNumbersHold) {
  for (const float p : {1e-30f, 1e-8f, 6e-8f, 1e-5f, 0.1f, 0.3f, 0.499999f, 0.5f, 0.7f, 1.0f}) {
    const float drawable = drawable_probability(p);
    EXPECT_EQ(drawable * 0x1p24f, std::ceil(p * 0x1p24f)) << p;
  }
  EXPECT_EQ(drawable_probability(0), 0);
  EXPECT_EQ(drawable_probability(0.25f), 0.25f);
  EXPECT_TRUE(std::isnan(drawable_probability(NAN)));
}

// Over all numbers that there are, exactly: what the dimmest paths hold is neither lost nor gained.
TEST(Unit_DrawableProbability, RouletteKeepsTheMean) {
  for (const float throughput : {1e-3f, 3e-7f, 3e-8f, 1e-9f}) {
    double sum = 0;
    for (std::uint32_t i = 0; i < all_numbers; ++i) {
      PathState path;
      path.throughput = Rgb(throughput);
      if (survives_roulette(number(i), 2, {.inverse_threshold = 2, .first_bounce = 2}, path))
        sum += static_cast<double>(path.throughput.x);
    }
    EXPECT_NEAR(sum / all_numbers / static_cast<double>(throughput), 1, 1e-6) << throughput;
  }
}

// The mean weight of the samples above the surface and of those below, over all numbers.
struct Halves {
  double above = 0, below = 0;
};
Halves halves_of(const Bsdf& bsdf) {
  Halves sum;
  for (std::uint32_t i = 0; i < all_numbers; ++i) {
    const BsdfSample sample = sample_bsdf(bsdf, Vec3f(0, 0, 1), number(i), Vec2f(0.3f, 0.6f));
    (sample.wi.z > 0 ? sum.above : sum.below) += static_cast<double>(sample.weight.x);
  }
  return {sum.above / all_numbers, sum.below / all_numbers};
}

// As glass of hardly another index than what is around it reflects.
TEST(Unit_DrawableProbability, RareReflectionsKeepTheirMean) {
  for (const float ior : {1.01f, 1.001f, 1.0003f}) {
    const Bsdf glass{.model = BsdfModel::Dielectric, .is_smooth = true, .eta = Rgb(ior)};
    const auto reflectance = static_cast<double>(fresnel_dielectric(1, ior).reflectance);
    EXPECT_NEAR(halves_of(glass).above / reflectance, 1, 1e-6) << ior;
  }
}

// As what is nearly black lets through.
TEST(Unit_DrawableProbability, RareTransmissionsKeepTheirMean) {
  for (const float tint : {1e-3f, 1e-7f, 1e-9f}) {
    const auto expected = static_cast<double>(tint);
    const Bsdf sheet{
        .model = BsdfModel::DiffuseTransmission, .diffuse = Rgb(0.5f), .transmittance = Rgb(tint)};
    EXPECT_NEAR(halves_of(sheet).below / expected, 1, 1e-6) << tint;
    Bsdf glass{.model = BsdfModel::Dielectric, .is_smooth = true, .eta = Rgb(1.5f)};
    const double clear = halves_of(glass).below;
    glass.transmittance = Rgb(tint);
    EXPECT_NEAR(halves_of(glass).below / (clear * expected), 1, 1e-6) << tint;
    Bsdf rough{.model = BsdfModel::Dielectric, .alpha = 0.2f, .eta = Rgb(1.5f)};
    const double through = halves_of(rough).below;
    rough.transmittance = Rgb(tint);
    EXPECT_NEAR(halves_of(rough).below / (through * expected), 1, 1e-4) << tint;
  }
}

}  // namespace
}  // namespace candela
