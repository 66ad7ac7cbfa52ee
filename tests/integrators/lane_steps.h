// Kernels whose paths take their steps side by side against those in which each steps alone.
#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/render_scene.h"

namespace candela::test {

// The same bits and the same counts by the scene's own kernel, which is `lanes`, as by the general.
inline void expect_single_steps(const description::SceneDescription& description,
                                RenderSettings settings, std::string_view lanes,
                                const std::string& what) {
  settings.options.aovs = all_aovs;
  const Scene scene = compiled(description, settings.options);
  const RenderResult together = rendered(scene, settings);
  settings.options.uses_general_kernel = true;
  const RenderResult single = rendered(scene, settings);
  ASSERT_EQ(together.statistics.kernel, lanes) << what;
  ASSERT_NE(single.statistics.kernel, lanes) << what;
  EXPECT_GT(mean_of(single.film.to_image(false)), 0.01) << what;
  EXPECT_EQ(together.film.to_image(true).values, single.film.to_image(true).values) << what;
  EXPECT_EQ(together.statistics.rays.indirect, single.statistics.rays.indirect) << what;
  EXPECT_EQ(together.statistics.rays.shadow, single.statistics.rays.shadow) << what;
  EXPECT_EQ(together.statistics.skipped.shadow_rays, single.statistics.skipped.shadow_rays) << what;
}

}  // namespace candela::test
