// Rooms of ordinary things drawn by chance (materials, shapes, placements, lamps from none to
// sixty, media, skies) with options drawn by chance: the same bits by the scene's kernel and the
// general one, by any threads and tiles, and of crops alone. tests/stress has those at the ends of
// their parameters.
#include <gtest/gtest.h>

#include <random>

#include "renderer/description/validate.h"
#include "tests/integrators/sample_ranges.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::MaterialHandle;
using description::SceneDescription;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double between(double a, double b) {
    return a + (b - a) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  int below(int count) { return static_cast<int>(between(0, count)); }
  bool one_in(int count) { return below(count) == 0; }
  Vec3d vector(double a, double b) { return {between(a, b), between(a, b), between(a, b)}; }
  template <class T>
  T one_of(std::initializer_list<T> choices) {
    return choices.begin()[below(static_cast<int>(choices.size()))];
  }

 private:
  std::mt19937_64 random_;
};

description::ScalarInput width(Draw& draw) {
  return {draw.one_of({0.0, 0.0, 0.003, 0.05, 0.3, 0.8}), {}, 0};
}

description::Coat coat(Draw& draw) {
  return {draw.between(1.2, 2), width(draw), {}, draw.one_of({0.0, 0.3}), draw.one_of({0, 10})};
}

MaterialHandle simple_material(Draw& draw, SceneDescription& scene) {
  const Vec3d colour = draw.vector(0.1, 0.9);
  switch (draw.below(9)) {
    case 0:
      return add_material(scene, description::MirrorMaterial{{colour, {}}});
    case 1:
      return add_material(scene, description::ConductorMaterial{.roughness = width(draw)});
    case 2:
      return add_material(scene, description::DielectricMaterial{.ior = draw.between(1.1, 2),
                                                                 .roughness = width(draw),
                                                                 .transmittance = colour,
                                                                 .is_thin = draw.one_in(4)});
    case 3:
      return add_material(scene, description::CoatedDiffuseMaterial{{colour, {}}, coat(draw)});
    case 4:
      return add_material(scene, description::CoatedConductorMaterial{.roughness = width(draw),
                                                                      .coat = coat(draw)});
    case 5:
      return add_material(
          scene, description::DiffuseTransmissionMaterial{{colour * 0.5, {}}, {colour * 0.5, {}}});
    case 6: {
      description::CookTorranceMaterial glossy;
      glossy.roughness = {draw.between(0.05, 0.9), {}, 0};
      glossy.f0 = colour;
      if (draw.one_in(2)) glossy.geometry = description::GeometryModel::Smith;
      if (draw.one_in(3)) {
        glossy.fresnel = description::FresnelModel::Exact;
        glossy.ior = draw.between(1.2, 2);
      }
      return add_material(scene, glossy);
    }
    default:
      return add_material(scene, diffuse(colour));
  }
}

MaterialHandle material(Draw& draw, SceneDescription& scene) {
  if (!draw.one_in(6)) return simple_material(draw, scene);
  const MaterialHandle first = simple_material(draw, scene);
  const MaterialHandle second = simple_material(draw, scene);
  return add_material(scene,
                      description::MixMaterial{first, second, {draw.between(0, 1), {}, 0, {}}});
}

// Turned, stretched, sheared, mirrored.
Transform placement(Draw& draw) {
  Mat3d linear(1.0);
  for (int column = 0; column < 3; ++column) linear[column] += draw.vector(-0.4, 0.4);
  if (draw.one_in(3)) linear[0] = -linear[0];
  return {linear, draw.vector(-0.7, 0.7)};
}

void add_shape(Draw& draw, SceneDescription& scene) {
  const MaterialHandle surface = material(draw, scene);
  if (draw.one_in(4)) scene.materials[surface.index].opacity.factor = draw.between(0.1, 0.9);
  if (draw.one_in(3)) {
    add_mesh(scene, exact_sphere(draw.between(0.1, 0.4)), surface,
             at_place(draw.vector(-0.6, 0.6)));
    return;
  }
  const int subdivisions = draw.below(3);
  const description::Mesh shape = draw.one_in(2)
                                      ? box(Vec3d(-0.2), draw.vector(0, 0.3))
                                      : sphere(Vec3d(0.0), draw.between(0.1, 0.3), subdivisions);
  const auto mesh = add_mesh(scene, shape, surface, placement(draw));
  for (int i = draw.below(3); i > 0; --i) add_instance(scene, mesh, placement(draw));
}

// A few, or so many that they are picked by cells.
void add_lamps(Draw& draw, SceneDescription& scene) {
  for (int i = draw.one_in(2) ? draw.below(4) : draw.one_of({8, 20, 60}); i > 0; --i) {
    const MaterialHandle glow =
        add_material(scene, diffuse(Vec3d(0.1)), draw.vector(0.5, draw.one_of({2.0, 40.0})));
    scene.materials[glow.index].emits_both_sides = draw.one_in(3);
    const Vec3d place = draw.vector(-0.9, 0.9);
    const double size = draw.one_of({0.01, 0.1, 0.4});
    if (draw.one_in(4))
      add_mesh(scene, exact_sphere(size * 0.5), glow, at_place(place));
    else if (draw.one_in(2))
      add_mesh(scene, quad(place, {size, 0, 0.01 * size}, {0, 0.02 * size, size}), glow);
    else
      add_mesh(scene, triangle(place, place + draw.vector(-size, size), place + Vec3d(0, size, 0)),
               glow);
  }
  if (draw.one_in(3))
    add_light(scene, description::PointLight{draw.vector(-0.8, 0.8), draw.vector(0.1, 2)});
  if (draw.one_in(3))
    add_light(scene, description::SpotLight{.position = draw.vector(-0.8, 0.8),
                                            .intensity = draw.vector(0.1, 2),
                                            .inner_angle_radians = 0.3,
                                            .outer_angle_radians = draw.between(0.3, 1)});
  if (draw.one_in(3))
    add_light(scene, description::DirectionalLight{normalize(draw.vector(0.1, 1)), Vec3d(1.0)});
  if (draw.one_in(3)) add_light(scene, description::ConstantEnvironment{draw.vector(0.1, 1)});
}

void add_smoke(Draw& draw, SceneDescription& scene) {
  const Vec3d absorption = draw.vector(0, 1);
  const Vec3d scattering = draw.vector(0, 3);
  const auto smoke = add_medium(scene, absorption, scattering, draw.between(-0.7, 0.7));
  const bool is_glass = draw.one_in(2);
  const MaterialHandle boundary = is_glass ? add_material(scene, description::DielectricMaterial{})
                                           : add_material(scene, description::InterfaceMaterial{});
  scene.materials[boundary.index].media.inside = smoke;
  add_mesh(scene, sphere(draw.vector(-0.3, 0.3), 0.5, 2), boundary);
  if (!draw.one_in(4)) return;
  const auto fog = add_medium(scene, Vec3d(0.05), draw.vector(0, 0.3), 0.3);
  scene.materials[boundary.index].media.outside = fog;
  scene.cameras[0].medium = fog;
}

SceneDescription random_scene(std::uint64_t seed) {
  Draw draw(seed);
  SceneDescription scene = small_room();
  for (int i = 1 + draw.below(6); i > 0; --i) add_shape(draw, scene);
  add_lamps(draw, scene);
  if (draw.one_in(3)) add_smoke(draw, scene);
  return scene;
}

// A picture of few pixels with options of path that keep it unbiased.
RenderSettings random_settings(std::uint64_t seed) {
  Draw draw(~seed);
  RenderSettings settings = settings_of(12 + draw.below(12), draw.one_of({3, 16, 37, 64}), seed);
  RenderOptions& options = settings.options;
  options.replicates = draw.one_of({1, 2, 4, 5});
  options.adaptive = draw.one_in(2);
  options.plan.splitting = draw.one_of({1u, 1u, 3u});
  options.plan.roulette_threshold = draw.one_of({0.1f, 0.5f, 1.0f});
  options.plan.first_roulette_bounce = draw.one_of({0u, 2u});
  options.lamp_rays = options.plan.splitting == 1 ? draw.one_of({0, 8}) : 0;
  if (draw.one_in(2)) options.max_depth = draw.below(6);
  if (draw.one_in(4)) options.heuristic = Heuristic::Balance;
  options.sampler =
      draw.one_of({SamplerKind::Sobol, SamplerKind::Padded, SamplerKind::Independent});
  options.samples_constant_sky = draw.one_in(2);
  options.light_cells = !draw.one_in(3);
  options.light_sampling =
      draw.one_of({LightSampling::Area, LightSampling::Triangles, LightSampling::SolidAngle});
  options.transparent = draw.one_in(4);
  options.filter = draw.one_of({FilterKind::Box, FilterKind::BlackmanHarris});
  options.plan.reuses_paths = draw.one_in(2);
  return settings;
}

TEST(Agreement_RandomOptions, KernelsThreadsAndCropsGiveTheSameBits) {
  int with_lanes = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const description::SceneDescription description = random_scene(seed);
    ASSERT_FALSE(description::validate(description).has_errors());
    RenderSettings settings = random_settings(seed);
    settings.options.aovs = all_aovs;
    const Scene scene = compiled(description, settings.options);
    const RenderResult own = rendered(scene, settings);
    EXPECT_EQ(own.statistics.invalid_samples, 0u);
    const Image whole = own.film.to_image(true);
    const int size = settings.options.width;
    expect_same_bits_however_rendered(scene, settings, whole,
                                      {size / 4, size / 3, size - 2, size - 1});
    settings.options.uses_general_kernel = true;
    const RenderResult general = rendered(scene, settings);
    EXPECT_EQ(general.film.to_image(true).values, whole.values);
    EXPECT_EQ(general.statistics.rays.shadow, own.statistics.rays.shadow);
    EXPECT_EQ(general.statistics.rays.indirect, own.statistics.rays.indirect);
    if (own.statistics.kernel.find("lanes") != std::string::npos) ++with_lanes;
  }
  EXPECT_GT(with_lanes, 30);
}

}  // namespace
}  // namespace candela
