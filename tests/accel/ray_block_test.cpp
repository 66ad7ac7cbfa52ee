// Blocks of rays: the answers of single rays, whatever the lanes and their neighbours.
#include "renderer/accel/ray_block.h"

#include <gtest/gtest.h>

#include <random>

#include "renderer/accel/any_accel.h"
#include "tests/accel/ray_sets.h"
#include "tests/scenes/coincident_walls.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/soups.h"

namespace candela {
namespace {

bool are_equal(const Hit& a, const Hit& b) {
  return a.t == b.t && a.u == b.u && a.v == b.v && a.geometry == b.geometry &&
         a.triangle == b.triangle && a.instance == b.instance;
}

// Blocks of rays from one point in nearly one direction, as of a pixel.
std::vector<RayBlock> pixel_blocks(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<RayBlock> blocks(count);
  for (RayBlock& block : blocks) {
    const Vec3f origin = test::uniform_in_cube(random) * 3.0f;
    const Vec3f through = test::uniform_in_cube(random);
    for (std::size_t i = 0; i < block_size; ++i)
      block.set(i, {origin, normalize(through + test::uniform_in_cube(random) * 0.02f - origin),
                    infinity});
  }
  return blocks;
}

// Blocks of rays that have nothing to do with each other, some of them short.
std::vector<RayBlock> scattered_blocks(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<RayBlock> blocks(count);
  for (RayBlock& block : blocks)
    for (std::size_t i = 0; i < block_size; ++i) {
      const Vec3f origin = test::uniform_in_cube(random) * 3.0f;
      const Vec3f direction = normalize(test::uniform_in_cube(random) - origin);
      block.set(i, {origin, direction, random() % 2 == 0 ? infinity : 2.0f});
    }
  return blocks;
}

// Every lane's answer, for lanes at random, against the single ray's.
template <Accelerator A>
void expect_single_answers(const A& accelerator, const std::vector<RayBlock>& blocks,
                           Coherence coherence) {
  std::mt19937 random(7);
  int hits = 0;
  for (const RayBlock& rays : blocks) {
    const LaneMask lanes = random() % 4 == 0 ? all_lanes : random() & all_lanes;
    const HitBlock found = accelerator.intersect(rays, lanes, coherence);
    const LaneMask occluded = accelerator.occluded(rays, lanes);
    EXPECT_EQ(occluded & ~lanes, 0u);
    for_each_lane(lanes, [&](std::uint32_t i) {
      const Hit single = accelerator.intersect(rays[i]);
      hits += single.is_hit();
      ASSERT_TRUE(are_equal(found[i], single)) << "lane " << i << " of " << lanes;
      ASSERT_EQ((occluded >> i & 1) != 0, single.is_hit()) << "lane " << i << " of " << lanes;
    });
    for_each_lane(all_lanes, [&](std::uint32_t i) {
      ASSERT_EQ((found.met >> i & 1) != 0, found[i].is_hit());
      ASSERT_EQ((found.instanced >> i & 1) != 0, found[i].is_instanced());
    });
    EXPECT_EQ(found.met & ~lanes, 0u);
  }
  EXPECT_GT(hits, 2000);
}

TEST(Unit_RayBlock, LanesAreVisitedFromTheLowest) {
  std::vector<std::uint32_t> visited;
  for_each_lane(0b1000000000010110u, [&](std::uint32_t i) { visited.push_back(i); });
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{1, 2, 4, 15}));
  for_each_lane(0, [](std::uint32_t) { ADD_FAILURE(); });
}

TEST(Unit_RayBlock, EmbreeAnswersAsForSingleRays) {
  const Scene scene = test::scene_of_all_kinds();
  for (const bool robust : {false, true}) {
    const EmbreeAccel embree(scene, {.robust = robust});
    expect_single_answers(embree, pixel_blocks(2000, 1), Coherence::Coherent);
    expect_single_answers(embree, scattered_blocks(2000, 2), Coherence::Incoherent);
    expect_single_answers(embree, scattered_blocks(500, 3), Coherence::Coherent);
  }
}

// Of surfaces in one place a packet may meet another one than its rays do one by one.
TEST(Unit_RayBlock, WithoutPacketsEmbreeAnswersOneByOne) {
  const Scene scene = test::compiled(test::walls_of_two_colours(), {});
  const EmbreeAccel embree(scene, {.packets = false});
  for (const RayBlock& rays : pixel_blocks(2000, 8)) {
    const HitBlock found = embree.intersect(rays, all_lanes, Coherence::Coherent);
    for_each_lane(all_lanes, [&](std::uint32_t i) {
      ASSERT_TRUE(are_equal(found[i], embree.intersect(rays[i])));
    });
  }
}

TEST(Unit_RayBlock, TheOwnTreeAnswersAsForSingleRays) {
  const Scene scene = test::scene_of_all_kinds();
  expect_single_answers(BvhAccel(scene), pixel_blocks(1000, 4), Coherence::Coherent);
}

// A lane that does not count may hold anything.
TEST(Unit_RayBlock, LanesThatDoNotCountChangeNothing) {
  const Scene scene = test::scene_of_all_kinds();
  const EmbreeAccel embree(scene);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (RayBlock rays : scattered_blocks(200, 5)) {
    constexpr LaneMask lanes = 0b0101010101010101u;
    const HitBlock before = embree.intersect(rays, lanes, Coherence::Incoherent);
    for_each_lane(all_lanes & ~lanes, [&](std::uint32_t i) {
      rays.set(i, {Vec3f(nan), Vec3f(1e20f), nan});
    });
    const HitBlock after = embree.intersect(rays, lanes, Coherence::Incoherent);
    const LaneMask occluded = embree.occluded(rays, lanes);
    for_each_lane(lanes, [&](std::uint32_t i) {
      EXPECT_TRUE(are_equal(before[i], after[i]));
      EXPECT_EQ((occluded >> i & 1) != 0, before[i].is_hit());
    });
  }
}

TEST(Unit_RayBlock, CountsLanes) {
  for (LaneMask lanes = 0; lanes <= all_lanes; ++lanes)
    ASSERT_EQ(lane_count(lanes), static_cast<std::uint32_t>(std::popcount(lanes)));
}

}  // namespace
}  // namespace candela
