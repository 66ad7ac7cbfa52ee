// No length in the scene's unit decides anything.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/stress/busy_room.h"
#include "tests/stress/disturb.h"
#include "tests/stress/row.h"
#include "tests/stress/undisturbed.h"

namespace candela {
namespace {

using namespace test;

RenderSettings with_all_layers(int size, int samples_per_pixel) {
  RenderSettings settings = settings_of(size, samples_per_pixel);
  settings.options.aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Normal) | aov_bit(Aov::Depth) |
                          aov_bit(Aov::Position) | aov_bit(Aov::MaterialId);
  return settings;
}

// Depth and position are in the file's unit.
void divide_lengths(Renders& renders, float factor) {
  for (Image& image : renders.images)
    for (std::size_t c = 0; c < image.channel_count(); ++c)
      if (image.channels[c].starts_with("depth") || image.channels[c].starts_with("position"))
        for (std::size_t i = c; i < image.values.size(); i += image.channel_count())
          image.values[i] /= factor;
}

TEST(Stress_Scale, PowersOfTwoGiveTheSameBits) {
  const RenderSettings settings = with_all_layers(48, is_heavy() ? 256 : 16);
  const Renders undisturbed = renders_of("undisturbed", busy_room(), settings, 1);
  for (const Where where : {Where::Vertices, Where::Instances})
    for (const int k : {-40, -20, -10, 10, 20, 40}) {
      const auto name =
          fmt::format("2^{}, {}", k, where == Where::Vertices ? "vertices" : "instances");
      Renders disturbed =
          renders_of(name, scaled(busy_room(), std::ldexp(1.0, k), where), settings, 1);
      divide_lengths(disturbed, std::ldexp(1.0f, k));
      expect_same_bits(disturbed, undisturbed);
    }
}

// What the command line adds to a render: pilots and rays that look for lamps go by lengths, too,
// and so may the layers that tell the error.
TEST(Stress_Scale, AdaptivePicturesAndTheirErrorsHaveTheSameBits) {
  RenderSettings settings = settings_of(32, 64);
  settings.options.adaptive = true;
  settings.options.lamp_rays = 8;
  settings.options.aovs = aov_bit(Aov::Samples) | aov_bit(Aov::Variance) | aov_bit(Aov::Interval) |
                          aov_bit(Aov::HeavyTail);
  const Renders undisturbed = renders_of("adaptive, undisturbed", busy_room(), settings, 1);
  for (const int k : {-40, -10, 10, 40})
    expect_same_bits(
        renders_of(fmt::format("adaptive, 2^{}", k),
                   scaled(busy_room(), std::ldexp(1.0, k), Where::Vertices), settings, 1),
        undisturbed);
}

TEST(Stress_Scale, PowersOfTenAreWithinNoise) {
  const RenderSettings settings = settings_of(24, is_heavy() ? 256 : 16);
  const Renders undisturbed = renders_of("undisturbed", busy_room(), settings);
  for (int k = -6; k <= 6; ++k)
    expect_within_noise(
        renders_of(fmt::format("10^{}", k), scaled(busy_room(), std::pow(10.0, k)), settings),
        undisturbed);
}

TEST(Stress_Scale, RotationsAreWithinNoise) {
  const RenderSettings settings = settings_of(24, is_heavy() ? 256 : 16);
  const Renders undisturbed = renders_of("undisturbed", busy_room(), settings);
  for (const double degrees : {1e-3, 30.0, 90.0, 179.0}) {
    const auto turned = rotated(busy_room(), degrees * pi_double / 180, {1, 2, 3});
    expect_within_noise(renders_of(fmt::format("{} degrees", degrees), turned, settings),
                        undisturbed);
  }
}

}  // namespace
}  // namespace candela
