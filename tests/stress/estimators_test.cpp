// Each estimator of a lamp's or a sky's light on a surface against a second one that shares nothing
// with it: the formulas in double, integrated over what shines. All materials, both accelerators;
// reflected and refracted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "renderer/bsdf/dispatch.h"
#include "renderer/sampling/equal_area.h"
#include "tests/bsdf/reference_bsdf.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/statistics/replicates.h"
#include "tests/stress/closed_form.h"
#include "tests/stress/material_cases.h"
#include "tests/stress/row.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

struct Surface {
  std::string name;
  decltype(description::Material::model) model;
  bool is_lit_through = false;  // the lamp lies below it
};

template <class Model>
Surface rough(const std::string& name, Model model, double roughness, bool is_lit_through = false) {
  model.roughness.factor = roughness;
  return {fmt::format("{} of roughness {}", name, roughness), model, is_lit_through};
}

std::vector<Surface> surfaces() {
  description::CookTorranceMaterial smith;
  smith.geometry = description::GeometryModel::Smith;
  description::CookTorranceMaterial exact = smith;
  exact.ior = 1.5;
  exact.fresnel = description::FresnelModel::Exact;
  description::CookTorranceMaterial compensated = smith;
  compensated.energy_compensation = true;
  compensated.f0 = Vec3d(0.6);
  description::LabMaterial lab;
  lab.diffuse.factor = Vec3d(0.8);
  lab.specular.factor = Vec3d(0.3);
  lab.shininess = 32;
  description::ConductorMaterial metal;
  metal.eta = Vec3d(0.92);
  metal.k = Vec3d(2.45);
  description::DielectricMaterial tinted;
  tinted.transmittance = Vec3d(0.7);
  description::DielectricMaterial heavy;
  heavy.ior = 2.4;
  return {{"diffuse", diffuse(Vec3d(0.6))},
          {"lab", lab},
          rough("cook_torrance", description::CookTorranceMaterial{}, 0.3),
          rough("cook_torrance, smith", smith, 0.2),
          rough("cook_torrance, exact", exact, 0.5),
          rough("cook_torrance, compensated", compensated, 0.7),
          rough("conductor", metal, 0.15),
          rough("conductor", metal, 1),
          rough("glass", tinted, 0.3),
          rough("glass", tinted, 0.2, true),
          rough("glass", heavy, 0.6, true)};
}

// The surface about the origin, a lamp of radiance 1 (from 0.2 to 1.4 in x, z within 0.6, at a
// height of 1 above or below) and a far, narrow camera at 45 degrees on the other side in x.
const Vec3d lamp_corner(0.2, 1, -0.6);
constexpr double lamp_side = 1.2;
const Vec3d to_camera(-std::sqrt(0.5), std::sqrt(0.5), 0);

SceneDescription lit(const Surface& surface) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), add_material(scene, surface.model));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
  const Vec3d x(lamp_side, 0, 0), z(0, 0, lamp_side);
  if (surface.is_lit_through)
    add_mesh(scene, quad(lamp_corner * Vec3d(1, -1, 1), z, x), lamp);  // shines up
  else
    add_mesh(scene, quad(lamp_corner, x, z), lamp);  // shines down
  set_camera(scene, to_camera * 6.0, {0, 0, 0}, 0.01);
  return scene;
}

// f |cos| in the surface's frame: x is z there. The compensated model is a table, which has no
// second form: of it this test sees how it is sampled.
double value(const Bsdf& bsdf, const Vec3d& wi) {
  const auto local = [](const Vec3d& w) { return Vec3d(w.z, w.x, w.y); };
  if (bsdf.model == BsdfModel::CompensatedCookTorrance)
    return double{evaluate_bsdf(bsdf, Vec3f(local(to_camera)), Vec3f(local(wi))).value.y};
  return tests::reference_value(bsdf, local(to_camera), local(wi));
}

double exact_radiance(const Bsdf& bsdf, bool is_lit_through) {
  constexpr int steps = 200;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      Vec3d to_lamp = lamp_corner + Vec3d((i + 0.5) / steps, 0, (j + 0.5) / steps) * lamp_side;
      if (is_lit_through) to_lamp.y = -to_lamp.y;
      const double distance = length(to_lamp);
      const double cos_lamp = std::abs(to_lamp.y) / distance;
      sum += value(bsdf, to_lamp / distance) * cos_lamp / square(distance);
    }
  return sum * square(lamp_side / steps);
}

struct Estimator {
  const char* name;
  SamplingStrategy sampling;
  Heuristic heuristic = Heuristic::Power;
  AcceleratorKind accelerator = AcceleratorKind::Auto;
  bool is_heavy = false;  // not in the default suite
};

constexpr Estimator estimators[] = {
    {"mis", SamplingStrategy::Mis},
    {"mis, balance", SamplingStrategy::Mis, Heuristic::Balance},
    {"mis, BVH", SamplingStrategy::Mis, Heuristic::Power, AcceleratorKind::Bvh},
    {"light", SamplingStrategy::Light},
    {"light, BVH", SamplingStrategy::Light, Heuristic::Power, AcceleratorKind::Bvh, true},
    {"bsdf", SamplingStrategy::Bsdf},
    {"bsdf, BVH", SamplingStrategy::Bsdf, Heuristic::Power, AcceleratorKind::Bvh, true},
};

// `exact`: of the first material's.
template <class Exact>
void expect_all_find(const std::string& name, const SceneDescription& scene, const Exact& exact,
                     double allowed_relative) {
  RenderSettings settings = settings_of(4, is_heavy() ? 2048 : 128);
  settings.options.max_depth = 1;
  const Scene as_compiled = compiled(scene, settings.options);
  const double expected = exact(bsdf_at(as_compiled.materials[0], {}, {}, true));
  for (const Estimator& estimator : estimators) {
    if (estimator.is_heavy && !is_heavy()) continue;
    settings.options.sampling = estimator.sampling;
    settings.options.heuristic = estimator.heuristic;
    settings.accelerator = estimator.accelerator;
    expect_mean(renders_of(fmt::format("{}, {}", name, estimator.name), scene, settings), expected,
                {.allowed_relative = allowed_relative, .resolution = 0.04, .level = 1e-4});
  }
}

TEST(Stress_Estimators, EachFindsTheIntegralOverTheLamp) {
  for (const Surface& surface : surfaces())
    expect_all_find(
        surface.name, lit(surface),
        [&](const Bsdf& bsdf) { return exact_radiance(bsdf, surface.is_lit_through); }, 1e-4);
}

// A grey sky with a bright spot above and a fainter one below.
double sky_radiance(const Vec3d& d) {
  const Vec3d above = normalize(Vec3d(0.9, 1, -0.3)), below = normalize(Vec3d(0.5, -1, 0.2));
  return 0.5 + 20 * std::exp(25 * (dot(d, above) - 1)) + 5 * std::exp(10 * (dot(d, below) - 1));
}

double exact_radiance_of_sky(const Bsdf& bsdf) {
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const double y = 1 - 2 * (i + 0.5) / steps;
      const double azimuth = pi_double * (j + 0.5) / steps;
      const double r = std::sqrt(1 - y * y);
      const Vec3d d(r * std::cos(azimuth), y, r * std::sin(azimuth));
      const bool is_dark = d.y < 0 && bsdf.model != BsdfModel::Dielectric;
      if (!is_dark) sum += value(bsdf, d) * sky_radiance(d);
    }
  return sum * 2 * pi_double / square(double{steps});
}

Vec3d lat_long_direction(double u, double v) {
  const double azimuth = 2 * pi_double * (u - 0.5), theta = pi_double * v;
  return {std::sin(theta) * std::sin(azimuth), std::cos(theta),
          -std::sin(theta) * std::cos(azimuth)};
}

SceneDescription under_sky(const Surface& surface, bool is_lat_long) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), add_material(scene, surface.model));
  set_camera(scene, to_camera * 6.0, {0, 0, 0}, 0.01);
  // A quarter turn about x: the lat-long map's poles are on the horizon.
  const Mat3d world_from_map(1, 0, 0, 0, 0, 1, 0, -1, 0);
  const int height = 256, width = is_lat_long ? 2 * height : height;
  scene.images.push_back(
      light_test::write_float_map("estimators", width, height, [&](int x, int y) {
        const double u = (x + 0.5) / width, v = (y + 0.5) / height;
        const Vec3d direction = is_lat_long ? lat_long_direction(u, v)
                                            : Vec3d(square_to_equal_area_sphere(Vec2f(u, v)));
        return Vec3f(static_cast<float>(sky_radiance(world_from_map * direction)));
      }));
  const description::ImageHandle image(std::size_t{0});
  if (is_lat_long)
    add_light(scene, description::LatLongEnvironment{image, Vec3d(1.0), world_from_map});
  else
    add_light(scene, description::EqualAreaEnvironment{image, Vec3d(1.0), world_from_map});
  return scene;
}

// Texels 1/80 apart: what lies between them is off by some 1e-3 of a spot, and of both signs.
TEST(Stress_Estimators, EachFindsTheIntegralOverASky) {
  for (const Surface& surface : surfaces()) {
    if (surface.is_lit_through) continue;  // a sky is on both sides
    for (const bool is_lat_long : {true, false})
      expect_all_find(fmt::format("{} under {} sky", surface.name,
                                  is_lat_long ? "a lat-long" : "an equal-area"),
                      under_sky(surface, is_lat_long), exact_radiance_of_sky, 1e-3);
  }
}

// A path tracer of its own for the box |x|, |y|, |z| <= 1 of diffuse faces: double, independent
// random numbers, cosine-weighted directions, nothing else. Faces in the order -x +x -y +y -z +z.
struct BruteForceBox {
  std::array<double, 6> albedo{};
  std::array<double, 6> emission{};

  struct Exit {
    std::size_t face = 0;
    Vec3d position{0.0};
  };
  static Exit exit_of(const Vec3d& origin, const Vec3d& direction) {
    double nearest = std::numeric_limits<double>::infinity();
    Exit exit;
    for (int axis = 0; axis < 3; ++axis) {
      const double side = direction[axis] < 0 ? -1 : 1;
      const double t = (side - origin[axis]) / direction[axis];
      if (!(t < nearest)) continue;
      nearest = t;
      exit.face = static_cast<std::size_t>(2 * axis + (side > 0));
    }
    exit.position = origin + direction * nearest;
    exit.position[static_cast<int>(exit.face / 2)] = exit.face % 2 == 0 ? -1 : 1;
    return exit;
  }

  static Vec3d cosine_direction(std::size_t face, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit;
    const double r = std::sqrt(unit(random)), phi = 2 * pi_double * unit(random);
    const int axis = static_cast<int>(face / 2);
    Vec3d direction(0.0);
    direction[axis] = std::sqrt(1 - r * r) * (face % 2 == 0 ? 1 : -1);
    direction[(axis + 1) % 3] = r * std::cos(phi);
    direction[(axis + 2) % 3] = r * std::sin(phi);
    return direction;
  }

  // The path ends with the probability 1 - albedo, so its weight stays 1.
  double radiance(Vec3d origin, Vec3d direction, std::mt19937_64& random) const {
    std::uniform_real_distribution<double> unit;
    for (double sum = 0;;) {
      const Exit exit = exit_of(origin, direction);
      sum += emission[exit.face];
      if (unit(random) >= albedo[exit.face]) return sum;
      origin = exit.position;
      direction = cosine_direction(exit.face, random);
    }
  }
};

// The same box as a scene, a mesh a face.
SceneDescription scene_of(const BruteForceBox& box) {
  SceneDescription scene = empty_scene();
  for (std::size_t face = 0; face < 6; ++face) {
    const int axis = static_cast<int>(face / 2);
    const double side = face % 2 == 0 ? -1 : 1;
    Vec3d corner(-1.0), u(0.0), v(0.0);
    corner[axis] = side;
    u[(axis + 1) % 3] = 2;
    v[(axis + 2) % 3] = 2;
    const auto material =
        add_material(scene, diffuse(Vec3d(box.albedo[face])), Vec3d(box.emission[face]));
    add_mesh(scene, side < 0 ? quad(corner, u, v) : quad(corner, v, u), material);
  }
  set_camera(scene, {0.2, -0.1, 0.7}, {0, 0, -1}, 80);
  return scene;
}

constexpr int brute_size = 16;

// A render with a box filter.
std::vector<double> brute_force_image(const BruteForceBox& box, int samples, std::uint64_t seed) {
  const Vec3d eye(0.2, -0.1, 0.7);
  const Vec3d look = normalize(Vec3d(0, 0, -1) - eye);
  const double half = std::tan(40 * pi_double / 180);
  const Vec3d right = normalize(cross(look, Vec3d(0, 1, 0)));
  const Vec3d up = cross(right, look);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit;
  std::vector<double> image;
  for (int y = 0; y < brute_size; ++y)
    for (int x = 0; x < brute_size; ++x) {
      double sum = 0;
      for (int i = 0; i < samples; ++i) {
        const double u = 2 * (x + unit(random)) / brute_size - 1;
        const double v = 1 - 2 * (y + unit(random)) / brute_size;
        sum += box.radiance(eye, normalize(look + (right * u + up * v) * half), random);
      }
      image.push_back(sum / samples);
    }
  return image;
}

TEST(Stress_Estimators, ABruteForceTracerOfABoxAgrees) {
  const BruteForceBox box{{0.8, 0.1, 0.9, 0.5, 0.3, 0.7}, {0, 0, 0, 2, 0, 0.1}};
  const int samples = is_heavy() ? 512 : 32;
  statistics::Replicates brute{"brute force", brute_size, brute_size, {}};
  for (std::uint64_t seed = 1; seed <= 16; ++seed)
    brute.images.push_back(brute_force_image(box, 4 * samples, seed));
  const SceneDescription scene = scene_of(box);
  for (const Estimator& estimator : estimators) {
    if (estimator.is_heavy && !is_heavy()) continue;
    RenderSettings settings = settings_of(brute_size, samples);
    settings.options.filter = FilterKind::Box;
    settings.options.sampling = estimator.sampling;
    settings.options.heuristic = estimator.heuristic;
    settings.accelerator = estimator.accelerator;
    statistics::Replicates path{estimator.name, brute_size, brute_size, {}};
    for (const Image& image : renders_of(estimator.name, scene, settings).images) {
      path.images.emplace_back();
      for (std::size_t i = 0; i < image.pixel_count(); ++i)
        path.images.back().push_back(double{image.values[i * image.channel_count()]});
    }
    // Where the lamp touches walls, 1 / distance^2 of its samples alone has no variance: the means
    // of such pixels are skewed, which t-tests of single pixels take for a difference.
    const bool has_heavy_tails = estimator.sampling == SamplingStrategy::Light;
    const auto agreement = compare_replicates(
        path, brute,
        {.level = 1e-3,
         .pixel_levels = has_heavy_tails ? std::vector<double>{} : std::vector{0.05, 0.01, 0.001}});
    EXPECT_TRUE(agreement.passed) << agreement.message;
    add_row(estimator.name, {{"p pixels", agreement.pixels_p_value},
                             {"p blocks", agreement.blocks_p_value},
                             {"p whole", agreement.whole_p_value},
                             {"ratio of means", agreement.whole_ratio}});
  }
}

}  // namespace
}  // namespace candela
