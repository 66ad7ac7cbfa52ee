// Pictures of which pixels share what their paths find (integrators/path/path_reuse.h).
#pragma once

#include <gtest/gtest.h>

#include "tests/integrators/replicated_pictures.h"
#include "tests/scenes/render_scene.h"

namespace candela::test {

inline RenderSettings settings_with_reuse(bool reuses_paths, int size, int samples,
                                          std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.plan.reuses_paths = reuses_paths;
  return settings;
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
  options.block = 4;          // none has two pixels of a group
  const auto agreement =
      statistics::compare_replicates(replicated_pictures(description, alone, "each by itself"),
                                     replicated_pictures(description, shared, "shared"), options);
  EXPECT_TRUE(agreement.passed) << agreement.message;
  EXPECT_NEAR(agreement.whole_ratio, 1, 0.01);
}
inline void expect_same_mean_shared(const description::SceneDescription& description, int samples) {
  expect_same_mean_shared(description, samples, [](RenderOptions&) {});
}

}  // namespace candela::test
