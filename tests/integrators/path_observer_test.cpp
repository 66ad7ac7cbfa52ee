// What observers are told of paths (integrators/path_observer.h).
#include "integrators/path_observer.h"

#include <gtest/gtest.h>

#include "integrators/path/kernels.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

struct DensityLog final : PathObserver {
  void leave(std::uint32_t, const LeftSurface& left) override {
    if (left.is_delta) return;
    ++directions;
    EXPECT_EQ(left.bsdf_pdf, left.pdf);
  }
  void radiance_so_far(std::uint32_t, const Rgb&) override {}
  void meet(std::uint32_t, float) override {}
  void end(std::uint32_t, const Rgb&) override {}

  int directions = 0;
};

// Refraction scales what roulette goes by, and no density.
TEST(Unit_PathObserver, WithoutAGuideAllDirectionsAreTheBsdfs) {
  description::SceneDescription room = small_room();
  description::DielectricMaterial glass;
  glass.roughness.factor = 0.4;
  add_mesh(room, sphere({0, 0, 0.6}, 0.6, 3), add_material(room, glass));
  const RenderSettings settings = settings_of(8, 16);
  const Scene scene = compiled(room, settings.options);
  const EmbreeAccel accelerator(scene);
  const Filter filter = make_filter(settings.options);
  DensityLog log;
  TilePass pass;
  pass.tile = {0, 0, 8, 8};
  pass.range = {0, 16};
  pass.observer = &log;
  Film film(8, 8, pass.tile, 0, 1);
  const TileCounts counts = render_tile<guided_features>(
      make_path_context(scene, accelerator, filter, settings.options), pass, film);
  EXPECT_GT(log.directions, 2000);
  EXPECT_GE(counts.rays.indirect, static_cast<std::uint64_t>(log.directions));
}

}  // namespace
}  // namespace candela
