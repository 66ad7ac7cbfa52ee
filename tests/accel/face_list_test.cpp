// Scenes of few faces, looked at one by one: what is known for certain is right, and the rest is
// left to Embree.
#include "renderer/accel/face_list.h"

#include <gtest/gtest.h>

#include "integrators/ray_bench/ray_bench.h"
#include "renderer/accel/any_accel.h"
#include "renderer/base/parallel.h"
#include "tests/accel/block_agreement.h"
#include "tests/accel/brute_force.h"
#include "tests/accel/ray_sets.h"

namespace candela {
namespace {

using test::Soup;

using Quad = std::array<Vec3f, 4>;

// As two triangles with vertices in common, along the diagonal from corner 0 or 1.
Geometry geometry_of(const std::vector<Quad>& quads) {
  Geometry geometry;
  std::vector<TriangleCorners> triangles;
  for (const Quad& quad : quads) {
    const auto first = static_cast<std::uint32_t>(geometry.positions.size());
    geometry.positions.insert(geometry.positions.end(), quad.begin(), quad.end());
    const std::uint32_t turn = first / 4 % 2;
    const auto corner = [&](std::uint32_t i) { return first + (i + turn) % 4; };
    triangles.push_back({corner(0), corner(1), corner(2)});
    triangles.push_back({corner(2), corner(3), corner(0)});
  }
  geometry.triangles = std::move(triangles);
  return geometry;
}

// Six walls, none of them along an axis, and no two alike.
std::vector<Quad> room() {
  const auto corner = [](float x, float y, float z) {
    return Vec3f(x + 0.2f * y - 0.1f * z, y + 0.3f * z, z - 0.15f * x);
  };
  const Vec3f c[2][2][2]{
      {{corner(-1, -1, -1), corner(-1, -1, 1)}, {corner(-1, 1, -1), corner(-1, 1, 1)}},
      {{corner(1, -1, -1), corner(1, -1, 1)}, {corner(1, 1, -1), corner(1, 1, 1)}}};
  return {{c[0][0][0], c[0][0][1], c[0][1][1], c[0][1][0]},
          {c[1][0][0], c[1][1][0], c[1][1][1], c[1][0][1]},
          {c[0][0][0], c[1][0][0], c[1][0][1], c[0][0][1]},
          {c[0][1][0], c[0][1][1], c[1][1][1], c[1][1][0]},
          {c[0][0][0], c[0][1][0], c[1][1][0], c[1][0][0]},
          {c[0][0][1], c[1][0][1], c[1][1][1], c[0][1][1]}};
}

std::size_t face_count(const Scene& scene) {
  return EmbreeAccel(scene, {.faces = true}).face_count();
}
std::size_t face_count(const std::vector<Quad>& quads) {
  return face_count(test::scene_of(std::vector<Geometry>{geometry_of(quads)}));
}

TEST(Unit_FaceList, TwoTrianglesOfAConvexPlaneAreOneFace) {
  EXPECT_EQ(face_count(room()), 6u);
  const Vec3f a(0, 0, 0), b(2, 0, 0), c(2, 2, 0);
  EXPECT_EQ(face_count({Quad{a, b, c, Vec3f(0, 2, 0)}}), 1u);
  EXPECT_EQ(face_count({Quad{a, b, c, Vec3f(1.5f, 0.5f, 0)}}), 2u) << "not convex";
  EXPECT_EQ(face_count({Quad{a, b, c, Vec3f(0, 2, 1e-4f)}}), 2u) << "not flat";
}

TEST(Unit_FaceList, FacesAreOfOneGeometry) {
  Geometry first = geometry_of({Quad{Vec3f(0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)}});
  Geometry second = first;
  first.triangles = first.triangles.prefix(1);
  second.triangles = {second.triangles[1]};
  EXPECT_EQ(face_count(test::scene_of(std::vector<Geometry>{first, second})), 2u);
}

TEST(Unit_FaceList, OtherScenesHaveNone) {
  const std::size_t most = FaceList::most_faces;
  EXPECT_EQ(face_count(test::scene_of(test::random_soup(most, 0.2f, 1))), most);
  EXPECT_EQ(face_count(test::scene_of(test::random_soup(most + 1, 0.2f, 1))), 0u);
  EXPECT_EQ(face_count(test::scene_of_all_kinds()), 0u);
  Scene with_cutouts = test::scene_of(std::vector<Geometry>{geometry_of(room())});
  with_cutouts.materials.emplace_back();
  with_cutouts.geometries[0].material = MaterialHandle(0);
  with_cutouts.geometries[0].has_cutouts = true;
  EXPECT_EQ(face_count(with_cutouts), 0u);
  const Scene scene = test::scene_of(std::vector<Geometry>{geometry_of(room())});
  EXPECT_EQ(EmbreeAccel(scene).face_count(), 0u) << "unless it is asked for";
}

// One ground plane out to the horizon, and rounding would leave all other meetings open.
TEST(Unit_FaceList, FacesOutToTheHorizonAreLeftToTheTree) {
  const auto with_ground = [](float reach) {
    return face_count({Quad{Vec3f(0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)},
                       Quad{Vec3f(-reach, -1, -reach), Vec3f(reach, -1, -reach),
                            Vec3f(reach, -1, reach), Vec3f(-reach, -1, reach)}});
  };
  EXPECT_EQ(with_ground(10), 2u);
  EXPECT_EQ(with_ground(1e6f), 0u);
}

TEST(Unit_FaceList, TrianglesWithoutAreaAreNoFaces) {
  Geometry geometry = geometry_of(room());
  const auto last = static_cast<std::uint32_t>(geometry.positions.size());
  geometry.positions.push_back(Vec3f(std::numeric_limits<float>::quiet_NaN()));
  std::vector<TriangleCorners> triangles(geometry.triangles.begin(), geometry.triangles.end());
  triangles.push_back({0, 1, 1});
  triangles.push_back({0, 1, last});
  geometry.triangles = std::move(triangles);
  EXPECT_EQ(face_count(test::scene_of(std::vector<Geometry>{geometry})), 6u);
}

// Rays of all sets, about soups that a list takes.
struct Case {
  std::string name;
  Scene scene;
  Soup soup;
};
std::vector<Case> cases() {
  std::vector<Case> made;
  const auto add = [&](const std::string& name, const Soup& soup) {
    made.push_back({name, test::scene_of(soup), soup});
  };
  add("random", test::random_soup(30, 0.7f, 1));
  add("slivers", test::sliver_soup(30, 2));
  add("duplicates", test::duplicate_soup(8, 3));
  add("coplanar", test::coplanar_soup(30, 4));
  add("mixed scales", test::mixed_scale_soup(30, 5));
  Soup walls;
  const Geometry geometry = geometry_of(room());
  for (const auto& [a, b, c] : geometry.triangles)
    walls.push_back({geometry.positions[a], geometry.positions[b], geometry.positions[c]});
  made.push_back({"room", test::scene_of(std::vector<Geometry>{geometry}), walls});
  return made;
}

TEST(Agreement_FaceList, SaysWhatTheReferenceTreeSays) {
  for (const Case& c : cases()) {
    const EmbreeAccel faces(c.scene, {.faces = true});
    ASSERT_GT(faces.face_count(), 0u) << c.name;
    const BvhAccel bvh(c.scene);
    const std::vector<Ray> rays = test::rays_of_all_sets(c.soup, 4000);
    with_threads(0, [&] {
      EXPECT_EQ(count_agreement(c.scene, faces, bvh, rays, false).disagreeing, 0u) << c.name;
      EXPECT_EQ(count_agreement(c.scene, faces, bvh, rays, true).disagreeing, 0u) << c.name;
    });
  }
}

TEST(Agreement_FaceList, SaysWhatBruteForceSays) {
  for (const Case& c : cases()) {
    const EmbreeAccel faces(c.scene, {.faces = true});
    for (const Ray& ray : test::rays_of_all_sets(c.soup, 1000))
      ASSERT_EQ(test::brute_force_complaint(c.scene, ray, faces.intersect(ray)), "") << c.name;
  }
}

// What the two tests before ask is mostly the list's own answer, not Embree's: slivers leave two
// random rays in nine open, faces of mixed scales one in seven, all others hardly any.
TEST(Unit_FaceList, AnswersItselfInAllOfTheseScenes) {
  for (const Case& c : cases()) {
    const FaceList faces(c.scene, c.scene.world.geometries);
    const std::vector<Ray> rays = test::random_rays(c.soup, 2000, 1);
    const auto known = std::count_if(
        rays.begin(), rays.end(), [&](const Ray& ray) { return faces.intersect(ray).has_value(); });
    EXPECT_GT(static_cast<double>(known) / static_cast<double>(rays.size()), 0.7) << c.name;
  }
}

TEST(Unit_FaceList, OfManyRaysAFewAreLeftOpen) {
  const Scene scene = test::scene_of(std::vector<Geometry>{geometry_of(room())});
  const FaceList faces(scene, scene.world.geometries);
  const Soup soup = cases().back().soup;
  const auto open_share = [&](const std::vector<Ray>& rays) {
    double open = 0;
    for (const Ray& ray : rays) open += faces.intersect(ray) ? 0 : 1;
    return open / static_cast<double>(rays.size());
  };
  EXPECT_LT(open_share(test::random_rays(soup, 20000, 1)), 1e-3);
  // Some go through diagonals, and some meet another wall first.
  EXPECT_GT(open_share(test::edge_rays(soup, 1000, 1)), 0.3);
}

// In any lane and beside any others a ray is told the same, and both questions have one answer.
TEST(Unit_FaceList, BlocksAreToldWhatRaysAre) {
  for (const Case& c : cases()) {
    const EmbreeAccel faces(c.scene, {.faces = true});
    const std::vector<Ray> rays = test::rays_of_all_sets(c.soup, 800);
    const std::size_t hits = test::expect_blocks_told_as_rays(
        faces, rays, {all_lanes, 0b0110100110010110u, 0b0000100000010010u}, c.name);
    EXPECT_GT(hits, 100u) << c.name;
    for (const Ray& ray : rays)
      ASSERT_EQ(faces.occluded(ray), faces.intersect(ray).is_hit()) << c.name;
  }
}

}  // namespace
}  // namespace candela
