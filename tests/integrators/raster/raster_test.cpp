// raster: whitted's light without shadows and further rays, holes left out.
#include "tests/image/crafted_files.h"
#include "tests/integrators/whitted/lab_scenes.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

Rgb seen_by_raster(const SceneDescription& scene) {
  return seen(scene, lab_settings(IntegratorKind::Raster));
}

TEST(Unit_Raster, NothingCastsAShadow) {
  SceneDescription scene = floor_seen_from(1, diffuse({0.2, 0.5, 0.8}));
  add_lab_point_light(scene, {0, 4, 0}, 16);
  add_sheet(scene, 2, add_material(scene, diffuse(Vec3d(0.5))));
  expect_near(seen_by_raster(scene), {0.2, 0.5, 0.8});
  expect_near(seen_by_whitted(scene), Vec3d(0.0));
}

TEST(Unit_Raster, HolesAreLeftOutAndTheRestIsOpaque) {
  for (const double alpha : {0.0, 0.199, 0.201, 0.5, 1.0}) {
    SceneDescription scene = floor_seen_from(4, diffuse(Vec3d(0.25)));
    scene.lab_ambient = Vec3d(1.0);
    add_sheet(scene, 2, add_cutout(scene, 0.75, alpha));
    add_sheet(scene, 3, add_cutout(scene, 0.75, 0.1));
    expect_near(seen_by_raster(scene), Vec3d(alpha < 0.2 ? 0.25 : 0.75));
  }
}

TEST(Unit_Raster, NothingIsMirrored) {
  SceneDescription scene = floor_seen_from(4, diffuse(Vec3d(0.0)));
  scene.lab_ambient = Vec3d(1.0);
  description::LabMaterial shiny = highlight_only(1.0, 32);
  shiny.diffuse.factor = Vec3d(1.0);
  add_sheet(scene, 1, add_material(scene, shiny));
  add_sheet(scene, 8, add_material(scene, diffuse(Vec3d(0.125))));
  expect_near(seen_by_raster(scene), Vec3d(1.0));
  expect_near(seen_by_whitted(scene), Vec3d(0.5 + 0.5 * 0.125));
}

// Also where vertex normals are interpolated as the lab's code does.
TEST(Unit_Raster, MapsTiltTheNormalsOfAnyKind) {
  const TemporaryFolder folder;
  const std::string map = folder.put(
      "map.png", crafted::png_rgba(8, 8, [](int x, int, int) { return 17u * unsigned(x); }));
  SceneDescription scene = floor_seen_from(4, diffuse(Vec3d(0.5)));
  scene.meshes[0].normals.assign(scene.meshes[0].positions.size(), Vec3f(0.28f, 0.96f, 0));
  add_light(scene, description::DirectionalLight{{0.6, 0.8, 0}, Vec3d(pi_double)});
  RenderSettings with_lab_normals = lab_settings(IntegratorKind::Raster);
  with_lab_normals.options.lab_normals = true;
  const Rgb smooth = seen(scene, with_lab_normals);
  expect_near(smooth, Vec3d(0.5 * (0.6 * 0.28 + 0.8 * 0.96)));
  scene.images.push_back(
      {map, description::Encoding::Linear, description::Wrap::Repeat, SourceSpan{}});
  scene.materials[0].height = description::ImageHandle(0);
  scene.materials[0].height_scale = 0.5;
  const Rgb mapped = seen_by_raster(scene);
  EXPECT_GT(std::abs(mapped.x - smooth.x), 0.05f);
  expect_near(seen(scene, with_lab_normals), Vec3d(mapped));
}

TEST(Unit_Raster, ItsSamplesFollowNoFurtherRays) {
  const RenderResult result = rendered(small_room(), lab_settings(IntegratorKind::Raster, 16, 4));
  EXPECT_EQ(result.statistics.rays.camera, 16u * 16 * 4);
  EXPECT_EQ(result.statistics.rays.indirect, 0u);
  EXPECT_EQ(result.statistics.rays.shadow, 0u);
  EXPECT_EQ(result.statistics.kernel, "raster");
}

}  // namespace
}  // namespace candela
