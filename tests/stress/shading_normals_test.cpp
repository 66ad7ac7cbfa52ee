// Vertex normals that disagree with the faces: spheres of few triangles, shaded smooth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"
#include "tests/stress/row.h"
#include "tests/stress/undisturbed.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

struct Named {
  std::string name;
  description::Material material;
};

template <class Model>
Named named(const std::string& name, Model model) {
  description::Material material;
  material.name = name;
  material.model = std::move(model);
  return {name, material};
}

// White or nearly so: what they lose, normals lost.
std::vector<Named> opaque_materials() {
  description::ConductorMaterial rough;
  rough.eta = Vec3d(0.0);
  rough.k = Vec3d(100.0);
  rough.roughness.factor = 0.2;
  description::CookTorranceMaterial glossy;
  glossy.diffuse.factor = Vec3d(0.5);
  glossy.specular.factor = Vec3d(0.5);
  return {named("diffuse", diffuse(Vec3d(1.0))), named("mirror", description::MirrorMaterial{}),
          named("conductor of roughness .2", rough), named("cook_torrance", glossy)};
}

SceneDescription smooth_sphere(const Named& named, int subdivisions) {
  SceneDescription scene = empty_scene();
  scene.materials.push_back(named.material);
  add_mesh(scene, sphere({0, 0, 0}, 1, subdivisions, true), description::MaterialHandle(0));
  return scene;
}

// The largest angle between a vertex normal and a face that has it.
double largest_disagreement(int subdivisions) {
  const description::Mesh mesh = sphere({0, 0, 0}, 1, subdivisions, true);
  double least_cosine = 1;
  for (const auto& t : mesh.triangles) {
    const Vec3d& p = mesh.positions[t[0]];
    const Vec3d face = normalize(cross(mesh.positions[t[1]] - p, mesh.positions[t[2]] - p));
    for (const std::uint32_t v : t)
      least_cosine = std::min(least_cosine, dot(face, Vec3d(mesh.normals[v])));
  }
  return std::acos(least_cosine);
}

// How surely the brightest pixel is brighter than 1: the least p-value of its replicates, by chance
// as small in one of so many pixels.
double p_of_gain(const Renders& renders) {
  const Image& shape = renders.images[0];
  double least = 1;
  for (std::size_t i = 0; i < shape.pixel_count(); ++i) {
    statistics::Moments pixel;
    for (const Image& image : renders.images)
      pixel.add(double{image.values[i * image.channel_count()]});
    const double gain = pixel.mean() - 1 - 1e-6;  // of rounding
    if (gain <= 0) continue;
    const double t = gain / pixel.standard_error();
    least = std::min(least, statistics::t_two_sided(t, static_cast<double>(pixel.count() - 1)) / 2);
  }
  return statistics::sidak_p_value(least, static_cast<double>(shape.pixel_count()));
}

// In a white sky no spot of a sphere may be brighter than the sky.
TEST(Stress_ShadingNormals, NothingIsBrighterThanTheSkyAroundIt) {
  for (const int subdivisions : {0, 1, 2})
    for (const Named& material : opaque_materials()) {
      SceneDescription scene = smooth_sphere(material, subdivisions);
      add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
      set_camera(scene, {0, 0, 4}, {0, 0, 0}, 22);
      const Renders renders =
          renders_of(fmt::format("{} faces, {}", 20 << (2 * subdivisions), material.name), scene,
                     settings_of(16, is_heavy() ? 1024 : 64));
      statistics::Moments means;
      for (const Image& image : renders.images) means.add(mean_of(image));
      EXPECT_LT(means.mean(), 1 + 5 * means.standard_error() + 1e-6) << renders.name;
      const double p = p_of_gain(renders);
      EXPECT_GT(p, 1e-4) << renders.name;
      add_row(renders.name, {{"mean", means.mean()},
                             {"standard error", means.standard_error()},
                             {"p of a brighter pixel", p}});
    }
}

// A face that looks away from the sun is dark, though the normals on it may say that it is lit. So
// the terminator is jagged, by no more than the angle by which normals and faces disagree; all that
// lies farther inside the light is as bright as the normal says.
TEST(Stress_ShadingNormals, TheTerminatorIsDarkNoFartherThanFacesDisagree) {
  const Vec3d to_light = normalize(Vec3d(1, 0.2, 0.3));
  for (const int subdivisions : {0, 1, 2, 3}) {
    SceneDescription scene = smooth_sphere(named("diffuse", diffuse(Vec3d(0.5))), subdivisions);
    add_light(scene, description::DirectionalLight{to_light, Vec3d(1.0)});
    set_camera(scene, {0, 0, 5}, {0, 0, 0}, 25);
    RenderSettings settings = settings_of(is_heavy() ? 512 : 192, 1);
    settings.options.aovs = aov_bit(Aov::Normal);
    const Image image = rendered(scene, settings).film.to_image(true);
    double darkest = 0;  // cosine of what the normal calls lit and is black
    double worst = 0;    // error of the cosine where it is lit: that of unit vectors of floats
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const float* const pixel = image.pixel(x, y);
        const double cosine = dot(Vec3d(pixel[4], pixel[5], pixel[6]), to_light);
        if (pixel[3] < 1 || cosine <= 0) continue;
        if (pixel[0] == 0)
          darkest = std::max(darkest, cosine);
        else
          worst = std::max(worst, std::abs(pixel[0] / (0.5 / pi_double) - cosine));
      }
    const double bound = std::sin(largest_disagreement(subdivisions));
    EXPECT_LE(darkest, bound + 1e-5) << subdivisions;
    EXPECT_LT(worst, 0x1p-22) << subdivisions;
    add_row(fmt::format("{} faces", 20 << (2 * subdivisions)),
            {{"black up to a cosine of", darkest},
             {"bound", bound},
             {"worst error of the other cosines", worst}});
  }
}

double brightest(const SceneDescription& scene) {
  const RenderSettings settings = is_heavy() ? settings_of(48, 256) : settings_of(24, 16);
  const Image image = rendered(scene, settings).film.to_image(false);
  return *std::max_element(image.values.begin(), image.values.end());
}

// From within a closed surface lights outside are not seen, and the other way round.
TEST(Stress_ShadingNormals, NoLightComesThrough) {
  for (const int subdivisions : {0, 1, 2})
    for (const Named& material : opaque_materials()) {
      SceneDescription inside = smooth_sphere(material, subdivisions);
      add_light(inside, description::ConstantEnvironment{Vec3d(1e6), true});
      add_light(inside, description::DirectionalLight{normalize(Vec3d(1, 2, 3)), Vec3d(1e6)});
      set_camera(inside, {0.1, 0.2, 0.1}, {1, 0, 0}, 120);
      SceneDescription outside = smooth_sphere(material, subdivisions);
      add_light(outside, description::PointLight{{0.1, 0.1, 0}, Vec3d(1e6)});
      set_camera(outside, {0, 0, 4}, {0, 0, 0}, 40);
      const double within = brightest(inside);
      const double without = brightest(outside);
      EXPECT_EQ(within, 0) << material.name << ", " << subdivisions;
      EXPECT_EQ(without, 0) << material.name << ", " << subdivisions;
      add_row(fmt::format("{} faces, {}", 20 << (2 * subdivisions), material.name),
              {{"brightest inside", within}, {"brightest outside", without}});
    }
}

}  // namespace
}  // namespace candela
