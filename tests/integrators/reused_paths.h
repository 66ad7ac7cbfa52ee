// Pictures of which pixels share what their paths find (integrators/path/path_reuse.h).
#pragma once

#include <gtest/gtest.h>

#include "renderer/image/compare.h"
#include "tests/integrators/replicated_pictures.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/render_scene.h"

namespace candela::test {

inline RenderSettings settings_with_reuse(bool reuses_paths, int size, int samples,
                                          std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.plan.reuses_paths = reuses_paths;
  return settings;
}

// Of 40x40 pixels. Returns one of the pictures that are the same.
inline RenderResult expect_same_bits_shared(const Scene& scene, const RenderSettings& settings) {
  RenderResult whole = rendered(scene, settings);
  EXPECT_TRUE(whole.statistics.plan.reuses_paths);
  const Image image = whole.film.to_image(true);
  expect_same_bits_however_rendered(scene, settings, image, {13, 5, 38, 40});
  RenderSettings general = settings;
  general.options.uses_general_kernel = true;
  EXPECT_EQ(rendered(scene, general).film.to_image(true).values, image.values);
  return whole;
}

// Pictures of which `change(options)` says more.
template <class Change>
void expect_same_mean_shared(const description::SceneDescription& description, int samples,
                             const Change& change) {
  RenderSettings alone = settings_with_reuse(false, 32, samples, 1);
  RenderSettings shared = settings_with_reuse(true, 32, samples, 101);
  change(alone.options);
  change(shared.options);
  statistics::AgreementOptions options;
  options.pixel_levels = {};  // pixels of a group are not independent
  options.block = 4;          // hardly any has two pixels of a group
  const auto agreement =
      statistics::compare_replicates(replicated_pictures(description, alone, "each by itself"),
                                     replicated_pictures(description, shared, "shared"), options);
  EXPECT_TRUE(agreement.passed) << agreement.message;
  EXPECT_NEAR(agreement.whole_ratio, 1, 0.01);
}
inline void expect_same_mean_shared(const description::SceneDescription& description, int samples) {
  expect_same_mean_shared(description, samples, [](RenderOptions&) {});
}

struct Errors {
  double stated = 0;
  double true_relmse = 0;
};

// Sums over 32 seeds, of 64 samples a pixel.
inline Errors errors_over_seeds(const Scene& scene, bool reuses_paths, const Image& reference,
                                bool adaptive = false) {
  Errors errors;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    RenderSettings settings = settings_with_reuse(reuses_paths, reference.width, 64, seed);
    settings.options.adaptive = adaptive;
    const auto result = rendered(scene, settings);
    errors.stated += result.error->relmse;
    errors.true_relmse += compare_images(result.film.to_image(false), reference)->relmse;
  }
  return errors;
}

inline Image reference_without_reuse(const Scene& scene) {
  return rendered(scene, settings_with_reuse(false, 32, 8192, 107)).film.to_image(false);
}

// Where pixels share there is less than `most` times the relMSE, and what is stated is true.
inline void expect_less_error_shared(const description::SceneDescription& description,
                                     double most) {
  const Scene scene = compiled(description, settings_of(32, 64).options);
  const Image reference = reference_without_reuse(scene);
  const Errors alone = errors_over_seeds(scene, false, reference);
  const Errors shared = errors_over_seeds(scene, true, reference);
  EXPECT_LT(shared.true_relmse, most * alone.true_relmse);
  EXPECT_NEAR(shared.stated / shared.true_relmse, 1, 0.15);
}

}  // namespace candela::test
