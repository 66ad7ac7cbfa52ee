// Embree and the reference BVH give the same answers: same primitive, or same distance within float
// error, and the same occlusion; where they differ rounding decides (compare_hits.h).
#include <gtest/gtest.h>

#include <cstdlib>

#include "integrators/ray_bench/ray_bench.h"
#include "renderer/base/parallel.h"
#include "tests/accel/ray_sets.h"

namespace candela {
namespace {

using test::Soup;

// Of each of five sets, for two questions (nearest hit, occlusion): 10 or 0.6 million answers.
std::size_t rays_a_set() {
  return std::getenv("CANDELA_HEAVY") ? 1'000'000 : 60'000;
}

AgreementCounts compare(const Scene& scene, const EmbreeAccel& embree, const BvhAccel& bvh,
                        const std::vector<Ray>& rays) {
  AgreementCounts counts = count_agreement(scene, embree, bvh, rays, false);
  counts += count_agreement(scene, embree, bvh, rays, true);
  return counts;
}

std::size_t hit_count(const BvhAccel& bvh, const std::vector<Ray>& rays) {
  std::size_t hits = 0;
  for (const Ray& ray : rays) hits += bvh.intersect(ray).is_hit();
  return hits;
}

// `rays_about`: the soup that rays are made for; the scene may hold more than it.
// `edge_share`: of random rays, how many may be left to rounding: the excuse must stay an
// exception.
void expect_agreement(const Scene& scene, const Soup& rays_about, const EmbreeOptions& options,
                      double edge_share) {
  const EmbreeAccel embree(scene, options);
  const BvhAccel bvh(scene);
  const std::size_t count = options.robust ? rays_a_set() / 10 : rays_a_set();
  const std::vector<Ray> ordinary = test::random_rays(rays_about, count, 1);
  const AgreementCounts counts = compare(scene, embree, bvh, ordinary);
  EXPECT_EQ(counts.disagreeing, 0u) << "random rays";
  EXPECT_LE(static_cast<double>(counts.at_edge), edge_share * static_cast<double>(counts.rays));
  EXPECT_GT(hit_count(bvh, ordinary), count / 20);

  EXPECT_EQ(compare(scene, embree, bvh, test::axis_rays(rays_about, count, 2)).disagreeing, 0u);
  EXPECT_EQ(compare(scene, embree, bvh, test::in_plane_rays(rays_about, count, 3)).disagreeing, 0u);
  EXPECT_EQ(compare(scene, embree, bvh, test::edge_rays(rays_about, count, 4)).disagreeing, 0u);
  EXPECT_EQ(compare(scene, embree, bvh, test::surface_rays(rays_about, count, 5)).disagreeing, 0u);
}

void expect_agreement(const Scene& scene, const Soup& rays_about, double edge_share = 1e-4) {
  with_threads(0, [&] {
    expect_agreement(scene, rays_about, {.robust = false}, edge_share);
    expect_agreement(scene, rays_about, {.robust = true}, edge_share);
  });
}

void expect_agreement(const Soup& soup, double edge_share = 1e-4) {
  expect_agreement(test::scene_of(soup), soup, edge_share);
}

TEST(Agreement_Accel, RandomTriangles) {
  expect_agreement(test::random_soup(2000, 0.2f, 1));
}

// Half of the random rays are aimed at triangles thinner than rounding.
TEST(Agreement_Accel, Slivers) {
  expect_agreement(test::sliver_soup(200, 2), 0.05);
}

TEST(Agreement_Accel, Duplicates) {
  expect_agreement(test::duplicate_soup(2000, 3));
}

TEST(Agreement_Accel, CoplanarFaces) {
  expect_agreement(test::coplanar_soup(1000, 4));
}

TEST(Agreement_Accel, ClosedSurface) {
  expect_agreement(test::closed_surface(4, 0.05f, 5));
}

// As with slivers: many of the triangles that are aimed at are smaller than an ulp of their place.
TEST(Agreement_Accel, SizesOverNineOrdersOfMagnitude) {
  expect_agreement(test::mixed_scale_soup(600, 6), 0.2);
}

TEST(Agreement_Accel, TinyAndHugeScenes) {
  const Soup soup = test::random_soup(500, 0.3f, 7);
  for (const float scale : {0x1p-20f, 0x1p20f}) expect_agreement(test::scaled(soup, scale));
}

}  // namespace
}  // namespace candela
