#include "renderer/scene/compile_quad_lights.h"

#include <gtest/gtest.h>

#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

Scene compiled_with(const SceneDescription& scene, LightSampling light_sampling) {
  RenderOptions options;
  options.light_sampling = light_sampling;
  return compiled(scene, options);
}

std::vector<std::uint32_t> quads_of(const Scene& scene) {
  std::vector<std::uint32_t> quads;
  for (const Light& light : scene.lights) quads.push_back(light.quad);
  return quads;
}

SceneDescription lamp_of(description::Mesh mesh) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, std::move(mesh), add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0)));
  set_camera(scene, {0, 0, 5}, {0, 0, 0});
  return scene;
}

TEST(Unit_QuadLights, TwoTrianglesOfAParallelogramArePickedAsOne) {
  const SceneDescription scene = lamp_of(quad({0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}));
  const Scene paired = compiled_with(scene, LightSampling::Area);
  ASSERT_EQ(paired.lights.size(), 3u);
  EXPECT_EQ(quads_of(paired), (std::vector<std::uint32_t>{2, 2, Light::none}));
  const Light& light = paired.lights[2];
  EXPECT_EQ(light.kind, LightKind::Quad);
  EXPECT_FLOAT_EQ(light.area, paired.lights[0].area + paired.lights[1].area);
  EXPECT_EQ(light.near_distance2, 0);
  EXPECT_EQ(paired.light_sampler.probability(2), 1);
  EXPECT_EQ(paired.light_sampler.probability(0), 0);
  const Scene apart = compiled_with(scene, LightSampling::Triangles);
  EXPECT_EQ(quads_of(apart), (std::vector<std::uint32_t>{Light::none, Light::none}));
  EXPECT_EQ(apart.light_sampler.probability(0), 0.5f);
}

TEST(Unit_QuadLights, RectanglesAreSampledBySolidAngleWhereThatIsAskedFor) {
  const SceneDescription scene = lamp_of(quad({0, 0, 0}, {2, 0, 0}, {0, 1, 0}));
  EXPECT_GT(compiled_with(scene, LightSampling::SolidAngle).lights[2].near_distance2, 0);
  EXPECT_EQ(compiled_with(scene, LightSampling::Area).lights[2].near_distance2, 0);
}

TEST(Unit_QuadLights, OtherTrianglesAreSampledBySolidAngleWhereThatIsAskedFor) {
  const SceneDescription scene = lamp_of(quad({0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}));
  const Scene skew = compiled_with(scene, LightSampling::SolidAngle);
  ASSERT_EQ(skew.lights.size(), 2u);
  EXPECT_EQ(quads_of(skew), (std::vector<std::uint32_t>{0, 1})) << "themselves";
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(skew.lights[i].kind, LightKind::NearTriangle);
    EXPECT_EQ(skew.light_sampler.probability(i), 0.5f);
  }
}

// Every point of both triangles is a point of the quad, and the sides agree, whichever corner the
// file begins with.
TEST(Unit_QuadLights, CoverTheirTriangles) {
  for (std::uint32_t first = 0; first < 3; ++first)
    for (std::uint32_t second = 0; second < 3; ++second) {
      description::Mesh mesh = quad({1, 2, 3}, {2, 0, 1}, {0, 1, 1});
      const auto turned = [](std::array<std::uint32_t, 3> t, std::uint32_t by) {
        return std::array<std::uint32_t, 3>{t[by % 3], t[(by + 1) % 3], t[(by + 2) % 3]};
      };
      mesh.triangles = {turned(mesh.triangles[0], first), turned(mesh.triangles[1], second)};
      const Scene scene = compiled_with(lamp_of(mesh), LightSampling::Area);
      ASSERT_EQ(scene.lights.size(), 3u);
      const Light& light = scene.lights[2];
      for (const Vec3f& p : scene.geometries[0].positions) {
        int corners = 0;
        for (const float s : {0.0f, 1.0f})
          for (const float t : {0.0f, 1.0f})
            corners += length(light.position + light.edge1 * s + light.edge2 * t - p) < 1e-6f;
        EXPECT_EQ(corners, 1);
      }
      EXPECT_NEAR(dot(light.normal, scene.lights[0].normal), 1, 1e-6);
    }
}

TEST(Unit_QuadLights, OthersStayTriangles) {
  description::Mesh opposed = quad({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  std::swap(opposed.triangles[1][0], opposed.triangles[1][1]);
  description::Mesh trapezium = quad({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  trapezium.positions[2].x += 0.01;
  description::Mesh bent = quad({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  bent.positions[2].z += 0.01;
  for (const description::Mesh& mesh : {opposed, trapezium, bent})
    EXPECT_EQ(compiled_with(lamp_of(mesh), LightSampling::SolidAngle).lights.size(), 2u);
}

// Where the image is bright is a matter of the triangles' own uvs.
TEST(Unit_QuadLights, LampsWithImagesStayTriangles) {
  SceneDescription scene = lamp_of(quad({0, 0, 0}, {2, 0, 0}, {0, 1, 0}));
  scene.images.push_back(
      light_test::write_float_map("quad_light", 2, 2, [](int, int) { return Vec3f(1); }));
  scene.materials[0].emission_map = description::ImageHandle(std::size_t{0});
  EXPECT_EQ(compiled_with(scene, LightSampling::SolidAngle).lights.size(), 2u);
}

}  // namespace
}  // namespace candela
