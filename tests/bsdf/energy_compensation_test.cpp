// `energy_compensation`: a white surface of microfacets gives back all light, whatever its
// roughness, and stays reciprocal.
#include <gtest/gtest.h>

#include "renderer/bsdf/dispatch.h"
#include "renderer/material/bsdf_at.h"
#include "tests/bsdf/bsdf_cases.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/direction_sampling.h"

namespace candela {
namespace {

using tests::compensated;
using tests::direction_of;

Bsdf white(float a) {
  return compensated(a, Rgb{0}, Rgb{1}, Rgb{1});
}

double ggx_lobe(const Bsdf& bsdf, const Vec3f& wo, const Vec3f& wi, float* pdf = nullptr) {
  const auto ggx = reflect_microfacets(GeometryTerm::Smith, ggx_width(bsdf.alpha), wo, wi);
  if (pdf) *pdf = ggx.pdf;
  return double{cook_torrance_fresnel(bsdf, ggx.cos_half).y} * double{ggx.value};
}

// Over the square of the sampler's numbers, where no roughness makes the lobe narrow.
double ggx_albedo(const Bsdf& bsdf, const Vec3f& wo) {
  constexpr int steps = 192;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const Vec2f u{(static_cast<float>(i) + 0.5f) / steps, (static_cast<float>(j) + 0.5f) / steps};
      const Vec3f wi = sample_ggx_reflection(wo, ggx_width(bsdf.alpha), u);
      float pdf = 0;
      const double value = ggx_lobe(bsdf, wo, wi, &pdf);
      if (wi.z > 0) sum += value / double{pdf};
    }
  return sum / (steps * steps);
}

// What is more in f cos than that lobe depends on the cosine c alone: 2 pi times its integral, over
// log(c), since narrow lobes lose light about c = a.
double smooth_albedo(const Bsdf& bsdf, const Vec3f& wo) {
  constexpr int steps = 2000;
  const double lowest = std::log(1e-7);
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double c = std::exp(lowest * (i + 0.5) / steps);
    const Vec3f wi = direction_of(static_cast<float>(c), 2);  // away from the mirror direction
    sum += c * (double{evaluate_bsdf(bsdf, wo, wi).value.y} - ggx_lobe(bsdf, wo, wi));
  }
  return 2 * pi_double * sum * -lowest / steps;
}

double albedo(const Bsdf& bsdf, float cos_o) {
  const Vec3f wo = direction_of(cos_o, 0.3f);
  return ggx_albedo(bsdf, wo) + smooth_albedo(bsdf, wo);
}

const std::vector<float>& widths() {
  static const std::vector<float> grid = {1e-4f,  3e-4f, 1e-3f, 3e-3f, 0.01f, 0.02f, 0.03f,
                                          0.045f, 0.07f, 0.1f,  0.15f, 0.2f,  0.3f,  0.42f,
                                          0.5f,   0.6f,  0.71f, 0.8f,  0.9f,  0.96f, 1.0f};
  return grid;
}
const std::vector<float>& cosines() {
  static const std::vector<float> grid = {1.0f,  0.97f, 0.8f,  0.6f,  0.5f,  0.4f,  0.25f,
                                          0.15f, 0.1f,  0.05f, 0.03f, 0.01f, 0.003f};
  return grid;
}

TEST(Unit_EnergyCompensation, WhiteSurfacesReturnAllLight) {
  for (const float a : widths())
    for (const float cos_o : cosines()) {
      const double found = albedo(white(a), cos_o);
      EXPECT_NEAR(found, 1, 1e-3) << "a " << a << " cosine " << cos_o;
    }
}

// Without it a rough one keeps 1 - ln 2 of what comes from straight above, and the quadrature
// agrees with that over directions.
TEST(Unit_EnergyCompensation, SeesWhatOneBounceLoses) {
  const Bsdf one_bounce = tests::cook_torrance(1, Rgb{0}, Rgb{1}, Rgb{1}, GeometryTerm::Smith);
  for (const Bsdf& bsdf : {one_bounce, white(1), white(0.3f)}) {
    const Vec3f wo = direction_of(0.6f, 0.3f);
    const double over_directions = statistics::integrate_sphere(
        [&](const Vec3f& wi) { return evaluate_bsdf(bsdf, wo, wi).value.y; }, {});
    EXPECT_NEAR(over_directions, albedo(bsdf, 0.6f), 2e-3);
  }
  EXPECT_NEAR(albedo(one_bounce, 1), 1 - std::log(2), 2e-3);  // in closed form
}

// A conductor of F < 1 gets more than one bounce gives, less than white, and its colour deepens.
TEST(Unit_EnergyCompensation, ColoursSaturate) {
  Bsdf copper = tests::conductor(0.8f);
  const auto mean_colour = [](const Bsdf& bsdf) {
    Rgb sum{0};
    for (std::uint32_t i = 0; i < 4096; ++i)
      sum +=
          sample_bsdf(bsdf, direction_of(0.7f, 0), owen_sobol_1d(i, 3), owen_sobol_2d(i, 4)).weight;
    return sum / 4096.0f;
  };
  const Rgb before = mean_colour(copper);
  copper.model = BsdfModel::CompensatedCookTorrance;
  copper.fresnel = FresnelTerm::Conductor;
  copper.geometry = GeometryTerm::Smith;
  copper.specular = Rgb{1};
  const Rgb after = mean_colour(copper);
  EXPECT_GT(after.x, before.x + 0.1f);
  EXPECT_LT(after.x, 0.98f);
  EXPECT_GT(after.x / after.z, before.x / before.z);
}

TEST(Unit_EnergyCompensation, MaterialsBecomeTheModel) {
  Material metal;
  metal.model = MaterialModel::Conductor;
  metal.energy_compensation = true;
  metal.roughness.constant = 0.4f;
  EXPECT_EQ(bsdf_at(metal, {}, {}, true).model, BsdfModel::CompensatedCookTorrance);
  EXPECT_EQ(bsdf_at(metal, {}, {}, true).fresnel, FresnelTerm::Conductor);
  metal.roughness.constant = 0;  // polished: nothing is lost
  EXPECT_EQ(bsdf_at(metal, {}, {}, true).model, BsdfModel::Conductor);
  EXPECT_EQ(bsdf_models(metal),
            model_bit(BsdfModel::Conductor) | model_bit(BsdfModel::CompensatedCookTorrance));
}

// The furnace: a sphere of rough white metal vanishes in a white sky.
TEST(Statistical_EnergyCompensation, WhiteMetalVanishesInAWhiteSky) {
  description::SceneDescription scene;
  description::CookTorranceMaterial metal;
  metal.diffuse.factor = Vec3d(0);
  metal.specular.factor = Vec3d(1);
  metal.f0 = Vec3d(1);
  metal.roughness.factor = 0.8;
  metal.geometry = description::GeometryModel::Smith;
  metal.energy_compensation = true;
  const auto white_metal = test::add_material(scene, metal);
  test::add_mesh(scene, test::box({-1, -1, -1}, {1, 1, 1}), white_metal);
  test::add_light(scene, description::ConstantEnvironment{Vec3d(0.75), true});
  test::set_camera(scene, {2, 2, 3}, {0, 0, 0}, 20);
  const double mean =
      test::mean_of(test::rendered(scene, test::settings_of(16, 256)).film.to_image(false));
  EXPECT_NEAR(mean, 0.75, 0.0075);
}

TEST(Unit_EnergyCompensation, IsReciprocal) {
  for (const float a : {0.01f, 0.3f, 1.0f}) {
    const Bsdf bsdf = compensated(a, Rgb{0.2f}, Rgb{0.8f}, Rgb{0.6f});
    const Vec3f w1 = direction_of(0.9f, 0.4f);
    const Vec3f w2 = direction_of(0.1f, 2.0f);
    const float there = evaluate_bsdf(bsdf, w1, w2).value.y / w2.z;
    const float back = evaluate_bsdf(bsdf, w2, w1).value.y / w1.z;
    EXPECT_NEAR(there / back, 1, 1e-5) << a;
  }
}

}  // namespace
}  // namespace candela
