// Scenes of things at the ends of their parameters, put together by chance: whatever meets
// whatever, no sample is invalid, and the specialised kernels agree with the general one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/stress/row.h"
#include "tests/stress/undisturbed.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : random_(seed) {}

  SceneDescription make() {
    scene_ = empty_scene();
    add_mesh(scene_, inside_out(box({-1, -1, -1}, {1, 1, 1})), any_material());
    for (int i = 0; i < 6; ++i) add_thing();
    for (int i = one_of({0, 1, 2, 6}); i > 0; --i) add_any_light();
    if (chance(0.5)) add_light(scene_, description::ConstantEnvironment{Vec3d(strength()), true});
    const Vec3d eye = chance(0.2) ? Vec3d(1.0) : point();
    set_camera(scene_, eye, eye + direction(), one_of({0.01, 40.0, 90.0, 179.0}), direction());
    scene_.cameras[0].lens_radius = one_of({0.0, 0.0, 0.1});
    return scene_;
  }

 private:
  double unit() { return std::uniform_real_distribution<double>()(random_); }
  bool chance(double p) { return unit() < p; }
  template <class T>
  T one_of(std::initializer_list<T> list) {
    return list.begin()[static_cast<std::size_t>(unit() * static_cast<double>(list.size()))];
  }
  Vec3d direction() {
    std::normal_distribution<double> normal;
    return normalize(Vec3d(normal(random_), normal(random_), normal(random_)));
  }
  // Often on the grid of corners, edges and middles, where things touch.
  Vec3d point() {
    if (chance(0.5)) return {one_of({-1.0, -0.5, 0.0, 1.0}), one_of({-1.0, 0.0, 0.5}), unit()};
    return Vec3d(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1);
  }
  double strength() { return one_of({1e-12, 1e-3, 1.0, 1e12}); }
  double roughness() { return one_of({0.0, 1e-6, 1e-4, 1e-3, 0.1, 1.0}); }
  double index() { return one_of({1.0, 1.0000001, 1.0001, 1.5, 1000.0}); }
  double share() { return one_of({0.0, 0.5, 1.0}); }

  decltype(description::Material::model) any_model() {
    switch (one_of({0, 1, 2, 3, 4, 5, 6, 7, 8})) {
      case 0:
        return diffuse(Vec3d(share(), 0.3, 1.0));
      case 1: {
        description::CookTorranceMaterial m;
        m.roughness.factor = roughness();
        m.f0 = Vec3d(share());
        if (chance(0.5)) m.geometry = description::GeometryModel::Smith;
        m.energy_compensation = m.geometry == description::GeometryModel::Smith && chance(0.5);
        if (chance(0.3)) m.ior = index();
        if (m.ior) m.fresnel = description::FresnelModel::Exact;
        return m;
      }
      case 2: {
        description::LabMaterial m;
        m.diffuse.factor = Vec3d(share());
        m.specular.factor = Vec3d(one_of({0.0, 1e-20, 0.5, 1.0}));
        m.shininess = one_of({0.0, 30.0, 256.0, 1e9});
        return m;
      }
      case 3: {
        description::ConductorMaterial m;
        m.eta = Vec3d(one_of({0.0, 0.2, 1.0, 1.5, 1000.0}));
        m.k = Vec3d(one_of({0.0, 3.9, 100.0}));
        m.roughness.factor = roughness();
        m.roughness_across = any_across();
        m.energy_compensation = !m.roughness_across && chance(0.3);
        return m;
      }
      case 4:
        return description::MirrorMaterial{{Vec3d(share()), {}}};
      case 5: {
        description::CoatedDiffuseMaterial m;
        m.reflectance.factor = Vec3d(share());
        m.coat = any_coat();
        return m;
      }
      case 6: {
        description::CoatedConductorMaterial m;
        m.eta = Vec3d(one_of({0.2, 1.5}));
        m.k = Vec3d(one_of({0.0, 3.9, 100.0}));
        m.roughness.factor = roughness();
        m.roughness_across = any_across();
        m.coat = any_coat();
        return m;
      }
      case 7: {
        description::DiffuseTransmissionMaterial m;
        m.reflectance.factor = Vec3d(share() / 2);
        m.transmittance.factor = Vec3d(share() / 2);
        return m;
      }
      default: {
        description::DielectricMaterial m;
        m.ior = index();
        m.roughness.factor = roughness();
        m.transmittance = Vec3d(share(), 1.0, 0.2);
        m.is_thin = chance(0.3);
        if (!m.is_thin) m.roughness_across = any_across();
        return m;
      }
    }
  }
  // A second width, or none.
  std::optional<description::ScalarInput> any_across() {
    if (!chance(0.3)) return std::nullopt;
    return description::ScalarInput{roughness(), {}, 0};
  }
  description::Coat any_coat() {
    description::Coat coat;
    coat.ior = one_of({1.0, 1.0001, 1.5, 2.4});
    coat.roughness.factor = roughness();
    coat.roughness_across = any_across();
    coat.thickness = one_of({0.0, 0.01, 10.0});
    coat.max_depth = one_of({0, 2, 10});
    return coat;
  }
  description::MaterialHandle any_material() {
    auto model = any_model();
    if (chance(0.1)) {
      const auto first = add_material(scene_, any_model());
      model = description::MixMaterial{first, add_material(scene_, model), {share(), {}, 0}};
    }
    const auto handle = add_material(scene_, model, chance(0.3) ? Vec3d(strength()) : Vec3d(0.0));
    scene_.materials.back().emits_both_sides = chance(0.5);
    if (chance(0.1)) scene_.materials.back().opacity.factor = 0.5;
    return handle;
  }
  void add_thing() {
    const Vec3d at = point();
    const double size = one_of({1e-6, 1e-2, 0.3, 0.5});
    const description::MaterialHandle material = any_material();
    switch (one_of({0, 1, 2, 3})) {
      case 0:
        add_mesh(scene_, sphere(at, size, 2, chance(0.5)), material);
        break;
      case 1:
        add_mesh(scene_, box(at, at + Vec3d(size, 0.2, size)), material);
        break;
      case 2:  // a needle
        add_mesh(scene_, triangle(at, at + direction() * size, at + direction() * 1e-6), material);
        break;
      default:
        add_mesh(scene_, quad(at, direction() * size, direction() * size), material);
    }
  }
  void add_any_light() {
    switch (one_of({0, 1, 2, 3})) {
      case 0:
        return add_light(scene_, description::PointLight{point(), Vec3d(strength())});
      case 1:
        return add_light(scene_, description::SpotLight{point(), direction(), Vec3d(strength()),
                                                        0.0, one_of({0.0, 1e-4, 1.0, pi_double})});
      case 2:
        return add_light(scene_, description::DirectionalLight{direction(), Vec3d(strength())});
      default: {
        const Vec3d a = point();
        add_light(scene_, description::TriangleLight{{a, a + direction(), a + direction() * 1e-6},
                                                     Vec3d(strength()),
                                                     chance(0.5)});
      }
    }
  }

  std::mt19937_64 random_;
  SceneDescription scene_;
};

TEST(Stress_RandomScenes, NothingIsInvalid) {
  const std::uint64_t count = is_heavy() ? 3000 : 40;
  std::uint64_t samples = 0;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const SceneDescription scene = RandomScene(seed).make();
    RenderSettings settings = settings_of(12, 8);
    settings.accelerator = seed % 2 == 0 ? AcceleratorKind::Auto : AcceleratorKind::Bvh;
    settings.options.max_depth = seed % 3 == 0 ? std::optional<int>(5) : std::nullopt;
    const std::string name = fmt::format("scene {}", seed);
    const Renders renders = renders_of(name, scene, settings, 1);  // expects no invalid ones
    settings.options.uses_general_kernel = true;
    const Renders general = renders_of(name, scene, settings, 1);
    EXPECT_EQ(renders.images[0].values, general.images[0].values) << name;
    samples += 2 * 12 * 12 * 8;
    settings.options.max_depth = std::nullopt;
    settings.options.replicates = 1;
    settings.options.samples_per_pixel = 1;
    for (const IntegratorKind integrator :
         {IntegratorKind::Whitted, IntegratorKind::Raster, IntegratorKind::Report}) {
      settings.options.integrator = integrator;
      (void)renders_of(name, scene, settings, 1);
      samples += 12 * 12;
    }
  }
  add_row("all",
          {{"scenes", static_cast<double>(count)}, {"samples", static_cast<double>(samples)}});
}

}  // namespace
}  // namespace candela
