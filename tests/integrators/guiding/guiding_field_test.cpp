// What records teach: targets, shares, cells.
#include <gtest/gtest.h>

#include "integrators/guiding/fit_cell.h"
#include "integrators/guiding/fit_targets.h"
#include "integrators/guiding/guiding_field.h"
#include "renderer/sampling/hash.h"
#include "renderer/sampling/warp.h"

namespace candela {
namespace {

using Records = std::vector<TrainingRecord>;

float random_number(std::uint64_t i, std::uint64_t dimension) {
  return unit_float(static_cast<std::uint32_t>(hash_combine(i, dimension)));
}

// By the cosine off a floor, with the light of a sky that is `bright` within 0.2 of the direction
// (0, 0.6, 0.8) and 1 elsewhere.
Records floor_records(std::size_t count, float bright) {
  Records records;
  for (std::uint64_t i = 0; i < count; ++i) {
    TrainingRecord record;
    record.position = {random_number(i, 1), random_number(i, 2), 0};
    record.receiving_normal = {0, 0, 1};
    const Vec3f wi = square_to_cosine_hemisphere({random_number(i, 3), random_number(i, 4)});
    record.pdf = record.bsdf_pdf = cosine_hemisphere_pdf(wi.z);
    record.target = record.position + wi * 1000.0f;
    record.weight = length(wi - Vec3f(0, 0.6f, 0.8f)) < 0.2f ? bright : 1;
    record.throughput = 1;
    records.push_back(record);
  }
  return records;
}

float density(const TargetMixture& mixture, const Vec3f& from, const Vec3f& wi) {
  return TargetsSeen(mixture, from).pdf(wi);
}

TEST(Unit_FitTargets, FindsWhereTheLightIs) {
  Records records = floor_records(256, 1000);
  const TargetMixture mixture = fit_targets(records);
  const Vec3f bright{0, 0.6f, 0.8f};
  EXPECT_GT(density(mixture, {0.5f, 0.5f, 0}, bright), 3);  // on average 1 / (4 pi)
  EXPECT_LT(density(mixture, {0.5f, 0.5f, 0}, {0.8f, 0, 0.6f}), 0.1f);
  float sum = 0;
  for (std::size_t i = 0; i < mixture_size; ++i) sum += mixture.weight[i];
  EXPECT_NEAR(sum, 1, 1e-5);
}

TEST(Unit_FitTargets, TakesOneRecordAndEqualOnes) {
  for (const std::size_t count : {1u, 100u}) {
    Records records(count, floor_records(1, 1)[0]);
    const TargetMixture mixture = fit_targets(records);
    EXPECT_EQ(mixture.weight[0], 1);
    EXPECT_TRUE(std::isfinite(mixture.inverse_spread2[0]));
  }
}

TEST(Unit_FitCell, FollowsTheGuideOnlyWhereItPays) {
  Records sky = floor_records(256, 1);
  EXPECT_EQ(fit_cell(sky).share, 0) << "the cosine is the best there is";
  Records lamp = floor_records(256, 1000);
  EXPECT_GE(fit_cell(lamp).share, 0.5f);
  Records single = floor_records(1, 1);
  EXPECT_EQ(fit_cell(single).share, 0);
}

TEST(Unit_GuidingField, CellsHaveTheirOwnTargets) {
  Records records = floor_records(1000, 1000);
  for (TrainingRecord record : floor_records(1000, 1000)) {
    record.position.x -= 5;
    record.target = {-5, 0, 1};
    records.push_back(record);
  }
  const GuidingField field(records);
  EXPECT_EQ(field.cells(), 8u);  // of at most 256 records
  EXPECT_GT(field.bytes(), 8 * sizeof(TargetMixture));
  const Vec3f up{0, 0, 1};
  const TargetMixture* right = field.mixture_at({0.5f, 0.5f, 0}, up);
  const TargetMixture* left = field.mixture_at({-4.5f, 0.5f, 0}, up);
  ASSERT_TRUE(left != nullptr && right != nullptr && left != right);
  const Vec3f towards = normalize(Vec3f(-5, 0, 1) - Vec3f(-4.5f, 0.5f, 0));
  EXPECT_GT(density(*left, {-4.5f, 0.5f, 0}, towards), 3);
  EXPECT_LT(density(*right, {0.5f, 0.5f, 0}, towards), 1);
}

TEST(Unit_GuidingField, KnowsNothingOfSidesWithoutRecords) {
  const GuidingField field(floor_records(1000, 1));
  EXPECT_NE(field.mixture_at(Vec3f(0.5f), {0.1f, -0.2f, 0.9f}), nullptr);
  for (const Vec3f normal : {Vec3f(0, 0, -1), Vec3f(1, 0, 0), Vec3f(0, -1, 0), Vec3f(0)})
    EXPECT_EQ(field.mixture_at(Vec3f(0.5f), normal), nullptr);
  EXPECT_EQ(GuidingField(floor_records(31, 1)).cells(), 0u) << "too few";
  EXPECT_EQ(GuidingField().mixture_at(Vec3f(0), {0, 0, 1}), nullptr);
}

}  // namespace
}  // namespace candela
