// Rooms with dense things in them: walls by a list, the rest by a tree behind boxes.
#include "renderer/accel/few_faces.h"

#include <gtest/gtest.h>

#include "integrators/ray_bench/ray_bench.h"
#include "renderer/accel/bvh_accel.h"
#include "renderer/accel/embree_accel.h"
#include "renderer/base/parallel.h"
#include "tests/accel/block_agreement.h"
#include "tests/accel/brute_force.h"
#include "tests/accel/ray_sets.h"

namespace candela {
namespace {

using test::Soup;

// A box around [-1.5, 1.5]^3.
Soup walls() {
  Soup soup;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.5f, 1.5f}) {
      const auto corner = [&](float u, float v) {
        Vec3f p;
        p[axis] = side;
        p[(axis + 1) % 3] = 1.5f * u;
        p[(axis + 2) % 3] = 1.5f * v;
        return p;
      };
      soup.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
      soup.push_back({corner(1, 1), corner(-1, 1), corner(-1, -1)});
    }
  return soup;
}

// With a camera in a corner that looks across.
Scene room_with(const Soup& things) {
  Scene scene =
      test::scene_of(std::vector<Geometry>{test::geometry_of(things), test::geometry_of(walls())});
  Camera camera;
  camera.eye = {1.4f, 1.4f, 1.4f};
  camera.look = normalize(Vec3f(-1, -1, -1));
  camera.right = normalize(Vec3f(1, 0, -1));
  camera.up = normalize(Vec3f(-1, 2, -1));
  scene.cameras = {camera};
  scene.plain_models.assign(2, PlainModel::Diffuse);
  return scene;
}

// A geometry of so many.
void add_spheres(Scene& scene, std::size_t count, bool has_cutouts = false) {
  Geometry geometry;
  geometry.material = MaterialHandle(0);
  geometry.has_cutouts = has_cutouts;
  test::RayRandom random(static_cast<std::uint32_t>(count));
  for (std::size_t i = 0; i < count; ++i) geometry.spheres.push_back(test::random_sphere(random));
  scene.world.geometries.emplace_back(scene.geometries.size());
  scene.geometries.push_back(std::move(geometry));
  scene.plain_models.push_back(PlainModel::Diffuse);
}

Soup scaled_soup(float factor) {
  return test::scaled(test::random_soup(200, 0.3f, 1), factor);
}

TEST(Unit_FewFaces, WallsAreListedAndTheRestIsNot) {
  const Scene scene = room_with(scaled_soup(0.2f));
  const FewFaces few = find_few_faces(scene);
  EXPECT_EQ(few.faces.size(), 6u);
  ASSERT_EQ(few.rest.size(), 1u);
  EXPECT_EQ(few.rest[0].index, 0u);
  EXPECT_EQ(few.boxes.size(), BoxList::most_boxes);
}

TEST(Unit_FewFaces, ScenesOfFewAltogetherHaveNoRest) {
  const Scene scene = test::scene_of(walls());
  const FewFaces few = find_few_faces(scene);
  EXPECT_EQ(few.faces.size(), 6u);
  EXPECT_TRUE(few.rest.empty());
  EXPECT_TRUE(few.boxes.is_empty());
}

TEST(Unit_FewFaces, OtherScenesHaveNone) {
  Scene with_instance = room_with(scaled_soup(0.2f));
  test::add_instances(with_instance, test::random_soup(100, 0.1f, 1),
                      {test::placement({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0})});
  EXPECT_TRUE(find_few_faces(with_instance).faces.is_empty());
  const Scene dense = test::scene_of(test::random_soup(1000, 0.1f, 1));
  EXPECT_TRUE(find_few_faces(dense).faces.is_empty());
  EXPECT_TRUE(find_few_faces(dense).rest.empty());
}

// Cut-outs are no faces, however large.
TEST(Unit_FewFaces, CutoutsAreOfTheRest) {
  Scene scene = room_with(scaled_soup(0.2f));
  test::add_cutout(scene, {{Vec3f(-1.4f), Vec3f(1.4f, -1.4f, 0), Vec3f(0, 1.4f, 0)}}, 0.5f);
  const FewFaces few = find_few_faces(scene);
  EXPECT_EQ(few.faces.size(), 6u);
  EXPECT_EQ(few.rest.size(), 2u);
}

TEST(Unit_FewFaces, SpheresAreListedWhereTheyAreFew) {
  const auto few_of = [](std::size_t spheres, bool has_cutouts) {
    Scene scene = test::scene_of(walls());
    add_spheres(scene, spheres, has_cutouts);
    return find_few_faces(scene);
  };
  EXPECT_EQ(few_of(16, false).spheres.size(), 16u);
  EXPECT_TRUE(few_of(16, false).rest.empty());
  EXPECT_EQ(few_of(17, false).rest.size(), 1u);
  EXPECT_TRUE(few_of(17, false).spheres.is_empty());
  EXPECT_EQ(few_of(1, true).rest.size(), 1u) << "with holes";
  // Of faces and spheres together there are as many as of faces alone.
  Soup faces = test::random_soup(20, 0.2f, 1);
  for (const std::size_t spheres : {12u, 13u}) {
    Scene scene = test::scene_of(faces);
    add_spheres(scene, spheres);
    EXPECT_EQ(find_few_faces(scene).spheres.is_empty(), spheres > 12);
  }
}

// Things in the middle that few rays come near, and things that fill the room.
TEST(Unit_FewFaces, AreUsedWhereFewRaysEnterABox) {
  const auto boxes = [](const Scene& scene) {
    return EmbreeAccel(scene, {.faces = true}).box_count();
  };
  EXPECT_GT(boxes(room_with(scaled_soup(0.15f))), 0u);
  const Scene full = room_with(scaled_soup(1.3f));
  EXPECT_EQ(boxes(full), 0u);
  EXPECT_EQ(EmbreeAccel(full, {.faces = true}).face_count(), 0u);
  EXPECT_GT(EmbreeAccel(full, {.faces = true, .faces_always = true}).box_count(), 0u);
  EXPECT_TRUE(pays(10, 0.2));
  EXPECT_FALSE(pays(10, 0.5));
  EXPECT_TRUE(pays(30, 0.2));
  EXPECT_FALSE(pays(30, 0.4));
}

// Whatever is in the room, paid or not.
struct Case {
  std::string name;
  Scene scene;
  Soup soup;
  std::size_t boxes;  // around the rest, at least

  [[nodiscard]] std::vector<Ray> rays(std::size_t count) const {
    std::vector<Ray> made = test::rays_of_all_sets(soup, count);
    for (const Geometry& geometry : scene.geometries) {
      if (geometry.spheres.empty()) continue;
      const std::vector<Ray> more = test::sphere_rays(geometry.spheres, 4 * count, 1);
      made.insert(made.end(), more.begin(), more.end());
    }
    return made;
  }
};
std::vector<Case> cases() {
  std::vector<Case> made;
  const auto add = [&](const std::string& name, const Soup& things) {
    Soup all = things;
    for (const test::Triangle& triangle : walls()) all.push_back(triangle);
    made.push_back({name, room_with(things), all, 1});
  };
  add("small", scaled_soup(0.2f));
  add("full", scaled_soup(1.3f));
  add("through the walls", scaled_soup(2));
  add("slivers", test::sliver_soup(200, 2));
  add("coplanar", test::coplanar_soup(200, 3));
  add("mixed scales", test::mixed_scale_soup(200, 4));
  return made;
}

// Beside things, alone with the walls, and too many for a list.
std::vector<Case> cases_with_spheres() {
  std::vector<Case> made;
  const auto add = [&](const std::string& name, Scene scene, std::size_t spheres,
                       std::size_t boxes) {
    add_spheres(scene, spheres);
    made.push_back({name, std::move(scene), walls(), boxes});
  };
  add("spheres and things", room_with(scaled_soup(0.5f)), 9, 1);
  add("spheres", test::scene_of(walls()), 16, 0);
  add("many spheres", test::scene_of(walls()), 60, 1);
  return made;
}

void expect_reference_answers(const Case& c) {
  const EmbreeAccel faces(c.scene, {.faces = true, .faces_always = true});
  ASSERT_GT(faces.face_count(), 0u) << c.name;
  ASSERT_GE(faces.box_count(), c.boxes) << c.name;
  const BvhAccel bvh(c.scene);
  const std::vector<Ray> rays = c.rays(4000);
  with_threads(0, [&] {
    EXPECT_EQ(count_agreement(c.scene, faces, bvh, rays, false).disagreeing, 0u) << c.name;
    EXPECT_EQ(count_agreement(c.scene, faces, bvh, rays, true).disagreeing, 0u) << c.name;
  });
}

TEST(Agreement_FewFaces, SayWhatTheReferenceTreeSays) {
  for (const Case& c : cases()) expect_reference_answers(c);
}

TEST(Agreement_FewFaces, SoTheyDoWithSpheres) {
  for (const Case& c : cases_with_spheres()) expect_reference_answers(c);
}

TEST(Agreement_FewFaces, SayWhatBruteForceSays) {
  for (const Case& c : cases()) {
    const EmbreeAccel faces(c.scene, {.faces = true, .faces_always = true});
    for (const Ray& ray : test::rays_of_all_sets(c.soup, 1000))
      ASSERT_EQ(test::brute_force_complaint(c.scene, ray, faces.intersect(ray)), "") << c.name;
  }
}

// Incoherent ones, in any lane and beside any others: so that blocks may share them.
TEST(Agreement_FewFaces, BlocksAreToldWhatRaysAre) {
  std::vector<Case> all = cases();
  for (Case& c : cases_with_spheres()) all.push_back(std::move(c));
  for (const Case& c : all) {
    const EmbreeAccel faces(c.scene, {.faces = true, .faces_always = true});
    EXPECT_TRUE(faces.allows_any_company());
    EXPECT_FALSE(EmbreeAccel(c.scene).allows_any_company());
    const std::size_t hits = test::expect_blocks_told_as_rays(
        faces, c.rays(1600), {all_lanes, 0b0110100110010110u}, c.name);
    EXPECT_GT(hits, 100u) << c.name;
  }
}

}  // namespace
}  // namespace candela
