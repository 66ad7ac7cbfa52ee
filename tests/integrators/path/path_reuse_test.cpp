// Pixels that share what their paths find (integrators/path/path_reuse.h): the same expectation and
// less noise, the error that is stated stays true, the same bits however it is rendered.
#include <gtest/gtest.h>

#include "integrators/background_pixels.h"
#include "integrators/path/kernels.h"
#include "integrators/path/reuse_groups.h"
#include "tests/image/crafted_files.h"
#include "tests/integrators/leaning_mirror.h"
#include "tests/integrators/reused_paths.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/room_of_a_point.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Diffuse surfaces share, with normals of their own or of an instance, too; a mirror, a glossy
// wall, a dim one that shines and a sky do not.
SceneDescription room_of_what_shares_and_not() {
  SceneDescription scene = small_room();
  add_leaning_mirror(scene);
  add_mesh(scene, sphere({0.5, -0.6, 0.4}, 0.3, 2), add_material(scene, diffuse(Vec3d(0.6))));
  description::CookTorranceMaterial glossy;
  glossy.diffuse.factor = Vec3d(0.3);
  glossy.specular.factor = Vec3d(0.5);
  glossy.roughness.factor = 0.3;
  add_mesh(scene, quad({-0.95, -0.5, -0.9}, {0.8, 0, 0}, {0, 0.9, 0}), add_material(scene, glossy));
  add_mesh(scene, quad({0.3, 0.1, -0.9}, {0.5, 0, 0}, {0, 0.4, 0}),
           add_material(scene, diffuse(Vec3d(0.4)), {4, 2, 6}));
  const auto block =
      add_mesh(scene, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}),
               add_material(scene, diffuse({0.7, 0.3, 0.2})), at_place({0.1, -0.8, 0.6}));
  add_instance(scene, block, at_place({-0.6, 0.5, 0.2}));
  add_light(scene, description::ConstantEnvironment{Vec3d(0.2), true});
  return scene;
}

// All surfaces have normals far from the faces' own, the back wall and the ceiling by a map: many
// are bent, and many directions are above their horizon alone. What bounces is more than what comes
// straight from the light, which is close to the floor.
SceneDescription room_of_tilted_normals(const TemporaryFolder& folder) {
  constexpr std::array<unsigned, 4> tilted{216, 168, 205, 255};
  SceneDescription scene = empty_scene();
  const auto grey = add_material(scene, diffuse(Vec3d(0.8)));
  const auto mapped = add_material(scene, diffuse(Vec3d(0.8)));
  scene.images.push_back(
      {folder.put("map.png",
                  crafted::png_rgba(
                      2, 2, [&](int, int, int c) { return tilted[static_cast<std::size_t>(c)]; })),
       description::Encoding::Linear,
       description::Wrap::Repeat,
       {}});
  scene.materials[mapped.index].normal_map = description::ImageHandle(0);
  const auto with_normal = [](description::Mesh mesh, const Vec3d& normal) {
    mesh.normals.assign(mesh.positions.size(), normalize(normal));
    return mesh;
  };
  add_mesh(scene, with_normal(quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}), {1.7, 1, 0}), grey);
  add_mesh(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}), mapped);
  add_mesh(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), mapped);
  add_mesh(scene, with_normal(quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}), {1, 1.7, 0}), grey);
  add_mesh(scene, with_normal(quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}), {-1, 0, 2.5}), grey);
  const auto block = add_mesh(scene, sphere({0, 0, 0}, 0.3, 0), grey, at_place({-0.5, -0.5, 0.4}));
  add_instance(scene, block, at_place({0.5, -0.7, 0.5}));
  add_light(scene, description::PointLight{{0, -0.5, 0}, Vec3d(1)});
  set_camera(scene, {0, 0, 3.5}, {0, 0, 0}, 45);
  return scene;
}

TEST(Statistical_PathReuse, KeepsEveryPixelsMean) {
  expect_same_mean_shared(small_room(), 64);
  expect_same_mean_shared(room_of_what_shares_and_not(), 64);
}

TEST(Statistical_PathReuse, KeepsEveryPixelsMeanWithAdaptiveSampling) {
  expect_same_mean_shared(room_of_what_shares_and_not(), 128,
                          [](RenderOptions& options) { options.adaptive = true; });
}

TEST(Statistical_PathReuse, KeepsTheMeanOfTiltedNormals) {
  const TemporaryFolder folder;
  expect_same_mean_shared(room_of_tilted_normals(folder), 256);
}

// The room without the lamp's edges, of which more is stated than there is with and without.
TEST(Statistical_PathReuse, LowersTheErrorAndTheOneThatIsStated) {
  expect_less_error_shared(room_of_a_point(0.7), 0.4);
}

// What paths from dark pixels find serves bright ones: roulette may not end them as if for their
// own pixels alone.
TEST(Statistical_PathReuse, DarkPixelsFindWhatBrightOnesNeed) {
  SceneDescription scene = room_of_a_point(0.85);
  const auto dark = add_material(scene, diffuse(Vec3d(0.002)));
  for (int stripe = 0; stripe < 8; ++stripe)
    add_mesh(scene, quad({-0.875 + 0.25 * stripe, -0.9, -0.99}, {0.125, 0, 0}, {0, 1.8, 0}), dark);
  expect_less_error_shared(scene, 0.4);
}

// Pixels of unlike numbers of samples find as many to share with.
TEST(Statistical_PathReuse, AdaptiveSamplingLosesNothingByIt) {
  const Scene scene = compiled(room_of_a_point(0.7), settings_of(32, 64).options);
  const Image reference = reference_without_reuse(scene);
  const auto gain = [&](bool reuses_paths) {
    const Errors alike = errors_over_seeds(scene, reuses_paths, reference);
    const Errors adaptive = errors_over_seeds(scene, reuses_paths, reference, true);
    EXPECT_NEAR(adaptive.stated / adaptive.true_relmse, 1, 0.15);
    return alike.true_relmse / adaptive.true_relmse;
  };
  const double shared = gain(true), alone = gain(false);
  EXPECT_GT(shared, 0.95 * alone) << alone;
}

TEST(Agreement_PathReuse, SameBitsOverThreadsTilesCropsAndKernels) {
  RenderSettings settings = settings_with_reuse(true, 40, 24);
  settings.options.replicates = 3;
  settings.options.aovs = all_aovs;
  settings.options.lamp_rays = 4;
  const TemporaryFolder folder;
  for (const SceneDescription& description :
       {small_room(), room_of_what_shares_and_not(), room_of_tilted_normals(folder)}) {
    const Scene scene = compiled(description, settings.options);
    const RenderResult whole = expect_same_bits_shared(scene, settings);
    EXPECT_EQ(whole.statistics.kernel, "path/lanes");
    RenderSettings alone = settings;
    alone.options.plan.reuses_paths = false;
    EXPECT_NE(rendered(scene, alone).film.to_image(true).values, whole.film.to_image(true).values);
  }
}

RenderSettings settings_of_trial() {
  RenderSettings settings = settings_with_reuse(true, 32, 16);
  settings.options.max_depth = 2;  // roulette, which ends longer paths, sees rounded throughputs
  return settings;
}
Film rendered_square(const PathContext<EmbreeAccel>& context, const PixelRect& square,
                     bool reuses_paths, const GroupTrial* trial = nullptr) {
  TilePass pass;
  pass.tile = square;
  pass.range = {0, 16};
  pass.plan.reuses_paths = reuses_paths;
  pass.trial = trial;
  Film film(32, 32, square, 0);
  render_tile<lane_features>(context, pass, film);
  return film;
}

TEST(Agreement_PathReuse, ATrialsGroupsAreThoseOfThePictureWithAndWithout) {
  const RenderSettings settings = settings_of_trial();
  const Scene scene = compiled(room_of_what_shares_and_not(), settings.options);
  const EmbreeAccel accelerator(scene);
  const Filter filter = make_filter(settings.options);
  const auto context = make_path_context(scene, accelerator, filter, settings.options);
  const PixelRect square{16, 0, 32, 16};
  const Film shared = rendered_square(context, square, true);
  const Film alone = rendered_square(context, square, false);
  std::vector<int> groups_of(16 * 16, 0);
  for (std::uint64_t group = 0; group < 16; ++group) {
    Film alone_by_trial(32, 32, square, 0);
    const GroupTrial trial{group, &alone_by_trial};
    const Film shared_by_trial = rendered_square(context, square, true, &trial);
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < shared.pixel_count(); ++i) {
      EXPECT_EQ(alone_by_trial.samples(i), shared_by_trial.samples(i));
      if (shared_by_trial.samples(i) == 0) continue;
      ++pixels;
      ++groups_of[i];
      EXPECT_EQ(shared_by_trial.samples(i), 16u);
      EXPECT_EQ(shared_by_trial.mean(i), shared.mean(i));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(alone_by_trial.mean(i)[c], alone.mean(i)[c], 1e-5 * alone.mean(i)[c]);
    }
    EXPECT_EQ(pixels, reuse_group_size);
  }
  EXPECT_EQ(groups_of, std::vector<int>(16 * 16, 1));
}

TEST(Agreement_PathReuse, SoTheyAreBesidePixelsThatAreKnownToSeeNothing) {
  const RenderSettings settings = settings_of_trial();
  SceneDescription description = ball_on_ground({0, 0, 0});
  add_light(description, description::ConstantEnvironment{Vec3d(0.3), true});
  const Scene scene = compiled(description, settings.options);
  const EmbreeAccel accelerator(scene);
  const Filter filter = make_filter(settings.options);
  auto context = make_path_context(scene, accelerator, filter, settings.options);
  const BackgroundPixels background(scene, filter, settings.options);
  context.background = &background;
  for (const PixelRect& square : {PixelRect{0, 0, 16, 16}, {16, 0, 32, 16}, {0, 16, 16, 32}}) {
    const Film shared = rendered_square(context, square, true);
    std::vector<int> is_asked(16 * 16, 0), is_seen(16 * 16, 0);
    for (std::uint64_t group = 0; group < 16; ++group) {
      Film alone(32, 32, square, 0);
      const GroupTrial trial{group, &alone};
      const Film by_trial = rendered_square(context, square, true, &trial);
      for (std::size_t i = 0; i < shared.pixel_count(); ++i)
        if (by_trial.samples(i) > 0) {
          is_asked[i] = 1;
          EXPECT_EQ(by_trial.mean(i), shared.mean(i));
        }
    }
    for (int y = square.y0; y < square.y1; ++y)
      for (int x = square.x0; x < square.x1; ++x)
        is_seen[shared.index(x, y)] = background.contains(x, y) ? 0 : 1;
    EXPECT_EQ(is_asked, is_seen);
  }
  EXPECT_TRUE(background.contains(0, 0));
}

TEST(Agreement_PathReuse, AdaptiveSamplingToo) {
  for (const int replicates : {1, 4}) {
    RenderSettings settings = settings_with_reuse(true, 40, 128);
    settings.options.replicates = replicates;
    settings.options.adaptive = true;
    const Scene scene = compiled(small_room(), settings.options);
    expect_same_bits_however_rendered(scene, settings, picture(scene, settings), {13, 5, 38, 40});
  }
}

// A crop that may end early has a pilot of its own, with whole squares.
TEST(Agreement_PathReuse, CropsThatEndEarly) {
  RenderSettings settings = settings_with_reuse(true, 70, 128);
  settings.options.adaptive = true;
  settings.options.target_relmse = 1e-3;
  settings.options.crop = PixelRect{20, 5, 38, 40};
  const Scene scene = compiled(small_room(), settings.options);
  const Image image = picture(scene, settings);
  for (const int tile_size : {8, 32, 64}) {
    settings.options.tile_size = tile_size;
    EXPECT_EQ(picture(scene, settings).values, image.values) << tile_size;
  }
}

TEST(Unit_PathReuse, IsLeftOutWhereItCannotBe) {
  const auto is_done = [](const SceneDescription& description, RenderSettings settings) {
    settings.options.plan.reuses_paths = true;
    const Scene scene = compiled(description, settings.options);
    return rendered(scene, settings).statistics.plan.reuses_paths;
  };
  const SceneDescription room = small_room();
  const RenderSettings plain = settings_of(16, 16);
  EXPECT_TRUE(is_done(room, plain));
  SceneDescription foggy = room;
  foggy.cameras[0].medium = add_medium(foggy, Vec3d(0.01), Vec3d(0.0));
  EXPECT_FALSE(is_done(foggy, plain));
  SceneDescription without_diffuse = ball_on_ground({0, 0, 0});
  EXPECT_TRUE(is_done(without_diffuse, plain));
  without_diffuse.materials[0].model = description::MirrorMaterial{};
  without_diffuse.materials[1].model = description::MirrorMaterial{};
  EXPECT_FALSE(is_done(without_diffuse, plain));
  for (const auto& change : std::initializer_list<void (*)(RenderOptions&)>{
           [](RenderOptions& options) { options.plan.splitting = 2; },
           [](RenderOptions& options) { options.guiding = Guiding::On; },
           [](RenderOptions& options) { options.max_depth = 1; },
           [](RenderOptions& options) { options.sampling = SamplingStrategy::Light; },
           [](RenderOptions& options) { options.integrator = IntegratorKind::Report; }}) {
    RenderSettings settings = plain;
    change(settings.options);
    EXPECT_FALSE(is_done(room, settings));
  }
}

// Whatever comes from behind the screen is not a number: what is lost there is its own path's
// sample, not those that it would have served or that share their lanes.
TEST(Unit_PathReuse, LostPathsSpoilTheirOwnSamplesAlone) {
#if defined(CANDELA_FLOATING_POINT_TRAPS)
  GTEST_SKIP() << "a NaN that is compared ends a program with traps";
#endif
  RenderSettings settings = settings_with_reuse(false, 32, 32);
  settings.options.max_depth = 2;
  settings.options.replicates = 1;  // else doubtful pixels get more
  SceneDescription room = small_room();
  const auto front = add_material(room, diffuse(Vec3d(0.5)));
  const auto back = add_material(room, diffuse(Vec3d(0.5)));
  add_mesh(room, quad({-0.6, -0.6, 0.01}, {1, 0, 0}, {0, 1, 0}), front);
  add_mesh(room, quad({-0.6, -0.6, 0}, {1, 0, 0}, {0, 1, 0}), back);
  Scene scene = compiled(room, settings.options);
  scene.materials[back.index].diffuse.constant = Rgb(std::numeric_limits<float>::quiet_NaN());
  const AnyAccelerator accelerator = build_accelerator(scene, settings.accelerator);
  const auto lost = [&](bool reuses_paths) {
    settings.options.plan.reuses_paths = reuses_paths;
    return render(scene, accelerator, settings.options, nullptr, nullptr)
        .statistics.invalid_samples;
  };
  EXPECT_GT(lost(false), 0u);
  EXPECT_EQ(lost(true), lost(false));
}

// Roulette may not end paths at first hits, where it would change with which density points are
// met.
TEST(Unit_PathReuse, RouletteLeavesFirstHitsAlone) {
  EXPECT_EQ((PathPlan{1, 1, 0, true}.roulette().first_bounce), 1u);
  EXPECT_EQ((PathPlan{1, 1, 2, true}.roulette().first_bounce), 2u);
  EXPECT_EQ((PathPlan{1, 1, 0, false}.roulette().first_bounce), 0u);
}

}  // namespace
}  // namespace candela
