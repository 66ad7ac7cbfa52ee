// The same small picture with many seeds, for tests of agreement and of noise.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/scenes/render_scene.h"
#include "tests/statistics/replicates.h"

namespace candela::test {

// Sixteen pictures with seeds from the settings' own on; none may have invalid samples.
inline statistics::Replicates replicated_pictures(const description::SceneDescription& description,
                                                  RenderSettings settings, std::string name) {
  const RenderOptions& options = settings.options;
  statistics::Replicates result{std::move(name), options.width, options.height, {}};
  const std::uint64_t end = options.seed + 16;
  for (; settings.options.seed < end; ++settings.options.seed) {
    const RenderResult render = rendered(description, settings);
    EXPECT_EQ(render.statistics.invalid_samples, 0u);
    result.images.push_back(grey(render.film.to_image(false)));
  }
  return result;
}

}  // namespace candela::test
