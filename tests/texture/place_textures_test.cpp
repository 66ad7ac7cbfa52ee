// Textures by the place in the world and by the normal, from the description to pictures.
#include <gtest/gtest.h>

#include "renderer/accel/alpha_test.h"
#include "renderer/math/constants.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/compile_textures.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::CheckerboardTexture;
using description::ColourInput;
using description::ImageTexture;
using description::MappingKind;
using description::SceneDescription;

// Red grows with the column, green with the row from the top.
Vec3f ramp(int x, int y) {
  return {static_cast<float>(x), static_cast<float>(y), 1};
}

// One texture, compiled for a scene that is moved and scaled on its way.
class Compiled {
 public:
  template <class Kind>
  explicit Compiled(const Kind& kind) {
    scene_.images.push_back(light_test::write_float_map("place", 8, 8, ramp));
    scene_.textures.push_back({"texture", {}, kind});
    TextureCompiler compiler(scene_, store, diagnostics_,
                             {Mat3d(1.0 / normalisation.scale), normalisation.centre});
    value = compiler.texture(description::TextureHandle(std::size_t{0}));
  }
  // At a place of the world.
  [[nodiscard]] Vec4f at(const Vec3d& p, const Vec3f& normal = {0, 0, 1}) const {
    const Vec3f position((p - normalisation.centre) * normalisation.scale);
    return store.lookup_at(value.texture, {Vec2f(0.37f), position, normal});
  }
  [[nodiscard]] Vec4f image_at(Vec2d uv) {
    const TextureHandle image = store.add(scene_.images[0], diagnostics_);
    return store.lookup(image, Vec2f(uv));
  }

  static constexpr double unit = 0.125;
  Normalisation normalisation{{100, -20, 7}, unit};
  TextureStore store;
  TextureValue value;

 private:
  SceneDescription scene_;
  Diagnostics diagnostics_;
};

const Transform turned{Mat3d(0, 2, 0, 0, 0, 2, 2, 0, 0), {0.5, -1, 0.25}};

template <class Expected>
void expect_image_mapped(MappingKind kind, const Expected& uv_of) {
  constexpr float factor = 0.125f;  // no colour of the image is above 1
  ImageTexture texture{description::ImageHandle(std::size_t{0}), {}, double{factor}, false};
  texture.mapping = {Vec2d(3, 2), Vec2d(0.125, 0.25), kind, turned};
  Compiled compiled(texture);
  EXPECT_TRUE(compiled.store.is_by_place(compiled.value.texture));
  for (int i = 0; i < 200; ++i) {
    const Vec3d p(std::sin(i * 1.7), std::cos(i * 2.9), std::sin(i * 0.77 + 1));
    const Vec2d uv = uv_of(turned.point(p)) * Vec2d(3, 2) + Vec2d(0.125, 0.25);
    const Vec4f expected = compiled.image_at(uv) * Vec4f(factor, factor, factor, 1);
    const Vec4f found = compiled.at(p);
    // Near edges of the repeated image rounding may choose the other side.
    const Vec2d to_edge = glm::abs(uv - glm::round(uv));
    if (std::min(to_edge.x, to_edge.y) < 0.07) continue;
    EXPECT_LT(length(found - expected), 3e-4f) << i;
  }
}

TEST(Unit_PlaceTextures, PlanarMappingsLookAlongZ) {
  expect_image_mapped(MappingKind::Planar, [](const Vec3d& p) { return Vec2d(p.x, p.y); });
}

TEST(Unit_PlaceTextures, SphericalMappingsAreAnglesFromZAndAboutIt) {
  expect_image_mapped(MappingKind::Spherical, [](const Vec3d& p) {
    const double about = std::atan2(p.y, p.x);
    return Vec2d(std::acos(p.z / length(p)) / pi_double,
                 (about < 0 ? about + 2 * pi_double : about) / (2 * pi_double));
  });
}

TEST(Unit_PlaceTextures, CylindricalMappingsAreTheAngleAboutZAndIt) {
  expect_image_mapped(MappingKind::Cylindrical, [](const Vec3d& p) {
    return Vec2d((pi_double + std::atan2(p.y, p.x)) / (2 * pi_double), p.z);
  });
}

TEST(Unit_PlaceTextures, SolidCheckerboardsAreCubes) {
  const Compiled compiled(description::SolidCheckerboardTexture{
      turned, ColourInput{Vec3d(1.0), {}, {}}, ColourInput{Vec3d(0.0), {}, {}}});
  int even_count = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3d p(3 * std::sin(i * 1.7), 3 * std::cos(i * 2.9), 3 * std::sin(i * 0.77 + 1));
    const Vec3d cell = glm::floor(turned.point(p));
    const Vec3d inside = turned.point(p) - cell;
    if (min_component(glm::min(inside, 1.0 - inside)) < 1e-3) continue;
    const bool is_even = static_cast<int>(cell.x + cell.y + cell.z) % 2 == 0;
    EXPECT_EQ(compiled.at(p).x, is_even ? 1 : 0) << i;
    even_count += is_even ? 1 : 0;
  }
  EXPECT_NEAR(even_count, 200, 60);
}

TEST(Unit_PlaceTextures, DirectionMixesByTheCosine) {
  description::DirectionMixTexture mix{
      ColourInput{Vec3d(3.0), {}, {}}, ColourInput{Vec3d(1.0), {}, {}}, {0, 0, 1}};
  const Compiled compiled(mix);
  for (const float z : {-1.0f, -0.5f, 0.0f, 0.25f, 1.0f}) {
    const Vec3f n(std::sqrt(1 - z * z), 0, z);
    EXPECT_NEAR(compiled.at({0, 0, 0}, n).x, 1 + 2 * std::abs(z), 1e-6);
  }
}

SceneDescription checked(const description::Mesh& mesh) {
  SceneDescription scene = empty_scene();
  CheckerboardTexture squares;
  squares.mapping.kind = MappingKind::Planar;
  squares.even.factor = Vec3d(0.75);
  scene.textures.push_back({"squares", {}, squares});
  description::DiffuseMaterial material;
  material.reflectance.texture = description::TextureHandle(std::size_t{0});
  add_mesh(scene, mesh, add_material(scene, material));
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), false});
  set_camera(scene, {0, 0, 9}, {0, 0, 0}, 0.001);
  return scene;
}

double seen_at(SceneDescription& scene, double x, double y) {
  set_camera(scene, {x, y, 9}, {x, y, 0}, 0.001);
  RenderSettings settings = settings_of(1, 256);
  settings.options.max_depth = 1;
  return double{rendered(scene, settings).film.to_image(false).pixel(0, 0)[0]};
}

// Places are the world's, of all instances of a mesh, wherever it lies and without uvs.
TEST(Unit_PlaceTextures, InstancesAreSeenAtTheirPlaces) {
  description::Mesh tile = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  tile.uvs.clear();
  SceneDescription scene = checked(tile);
  add_instance(scene, description::MeshHandle(std::size_t{0}), {Mat3d(1.0), {1, 0, 0}});
  add_instance(scene, description::MeshHandle(std::size_t{0}), {Mat3d(1.0), {1, 1, 0}});
  ASSERT_FALSE(compiled(scene, {}).instances.empty());
  EXPECT_NEAR(seen_at(scene, 0.5, 0.5), 0.75, 0.02);
  EXPECT_NEAR(seen_at(scene, 1.5, 0.5), 0, 1e-3);
  EXPECT_NEAR(seen_at(scene, 1.5, 1.5), 0.75, 0.02);
}

// Coverage by place: rays pass where the pattern has holes, by both accelerators.
TEST(Unit_PlaceTextures, HolesAreWhereTheWorldHasThem) {
  SceneDescription scene = checked(quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}));
  scene.materials[0].model = diffuse(Vec3d(0.0));
  scene.materials[0].opacity.texture = description::TextureHandle(std::size_t{0});
  std::get<CheckerboardTexture>(scene.textures[0].kind).even.factor = Vec3d(1.0);
  const Scene compiled_scene = compiled(scene, {});
  for (const AcceleratorKind kind :
       {AcceleratorKind::Auto, AcceleratorKind::Embree, AcceleratorKind::Bvh}) {
    set_camera(scene, {0.5, 0.5, 9}, {0.5, 0.5, 0}, 0.001);
    RenderSettings settings = settings_of(1, 16);
    settings.accelerator = kind;
    EXPECT_EQ(rendered(scene, settings).film.to_image(true).pixel(0, 0)[3], 1);
    set_camera(scene, {-0.5, 0.5, 9}, {-0.5, 0.5, 0}, 0.001);
    EXPECT_EQ(rendered(scene, settings).film.to_image(true).pixel(0, 0)[3], 0);
  }
}

}  // namespace
}  // namespace candela
