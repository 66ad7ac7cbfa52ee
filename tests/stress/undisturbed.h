// A disturbed scene held against the undisturbed one: by bits, or within noise.
//
//   const Renders undisturbed = renders_of("undisturbed", small_room(), settings);
//   expect_same_bits("2^10", render_of(scaled(small_room(), 1024), settings), undisturbed);
//   expect_within_noise(renders_of("10^3", scaled(small_room(), 1000), settings), undisturbed);
//
// Each also writes a row (row.h). Renders of an invalid sample fail the test (render_scene.h).
#pragma once

#include <string>
#include <vector>

#include "renderer/image/image.h"
#include "tests/scenes/render_scene.h"

namespace candela::test {

// Independent renders of one scene: seeds that count up from 1.
struct Renders {
  std::string name;
  std::vector<Image> images;  // R G B and the layers that the settings ask for
  std::uint64_t invalid_samples = 0;
};

[[nodiscard]] Renders renders_of(const std::string& name,
                                 const description::SceneDescription& description,
                                 const RenderSettings& settings, int count = 16);

// Image by image the same 32-bit floats.
void expect_same_bits(const Renders& disturbed, const Renders& undisturbed);

// The same expectation: t-tests of pixels, blocks and the whole (tests/statistics/replicates.h)
// against renders with other seeds than the disturbed ones, at `level` for one false alarm.
// The row also has what equal seeds show: the relMSE of the difference between the two, which is
// rounding and not noise, beside the noise's own.
void expect_within_noise(const Renders& disturbed, const Renders& undisturbed, double level = 1e-3);

// The row alone, where nothing is promised.
void add_comparison(const Renders& disturbed, const Renders& undisturbed);

// relMSE [docs: candela compare] of the difference between images of equal seeds, and of the
// undisturbed renders' noise: both the mean over the renders.
struct Distance {
  double difference_relmse = 0;
  double noise_relmse = 0;
};
[[nodiscard]] Distance distance_of(const Renders& disturbed, const Renders& undisturbed);

}  // namespace candela::test
