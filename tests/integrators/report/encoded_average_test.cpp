// REPORT 4.2: samples that are encoded for display before they are averaged make noise dark.
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/integrators/report/quadrature.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

double encoded(double radiance) {
  return std::pow(radiance, 1 / 2.2);
}
double decoded(double code) {
  return std::pow(code, 2.2);
}

// A white Lambert surface under L = 1 by one sample: cosine-weighted directions weigh 1, uniform
// ones 2 cos. Both average to 1; encoded first, the uniform estimator averages to .877 and looks
// "black", as the report found, at any number of samples.
TEST(Statistical_ReportEncoding, UniformSamplingIsDarkerByJensenAlone) {
  const auto uniform_weight = [](double xi) { return 2 * xi; };  // cos(theta) = xi
  EXPECT_NEAR(tests::unit_integral(uniform_weight), 1, 1e-5);
  const double code = tests::unit_integral([&](double xi) { return encoded(uniform_weight(xi)); });
  EXPECT_NEAR(code, std::pow(2, 1 / 2.2) / (1 / 2.2 + 1), 1e-5);
  EXPECT_NEAR(decoded(code), 0.877, 1e-3);
}

// Renders of one sample a pixel, averaged over pixels both ways.
struct Averages {
  statistics::Moments linear;
  statistics::Moments encoded_first;
};

Averages averages_of(const Scene& scene, int samples_per_pixel, std::uint64_t first_seed) {
  Averages averages;
  for (std::uint64_t seed = first_seed; seed < first_seed + 96; ++seed) {
    const test::RenderSettings settings = test::settings_of(16, samples_per_pixel, seed);
    const Image image = test::rendered(scene, settings).film.to_image(false);
    double linear = 0;
    double code = 0;
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
      linear += double{image.values[image.channel_count() * i]} /
                static_cast<double>(image.pixel_count());
      code += encoded(image.values[image.channel_count() * i]) /
              static_cast<double>(image.pixel_count());
    }
    averages.linear.add(linear);
    averages.encoded_first.add(code);
  }
  return averages;
}

// The mean of linear renders does not depend on how noisy they are; the mean of encoded ones does.
TEST(Statistical_ReportEncoding, NoisierRendersAverageDarkerOnceEncoded) {
  const Scene scene = test::compiled(test::small_room(), test::settings_of(16, 1).options);
  const Averages noisy = averages_of(scene, 1, 1);
  const Averages calm = averages_of(scene, 64, 101);
  EXPECT_GT(statistics::welch_p_value(noisy.linear, calm.linear), 0.01);
  EXPECT_LT(statistics::welch_p_value(noisy.encoded_first, calm.encoded_first), 1e-6);
  EXPECT_LT(noisy.encoded_first.mean(), 0.98 * calm.encoded_first.mean());
}

}  // namespace
}  // namespace candela
