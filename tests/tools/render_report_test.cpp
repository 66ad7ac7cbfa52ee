#include "tools/candela/render_report.h"

#include <gtest/gtest.h>

namespace candela::cli {
namespace {

TEST(Unit_RenderReport, ADepthLimitBiasesWhatFollowsPaths) {
  RenderOptions options;
  options.max_depth = 3;
  for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Report}) {
    options.integrator = integrator;
    EXPECT_EQ(biases_of(options), std::vector<std::string>{"max depth 3"});
  }
  options.integrator = IntegratorKind::Whitted;
  EXPECT_TRUE(biases_of(options).empty());
}

TEST(Unit_RenderReport, TellsOfPicturesThatEndedByTheirOwnError) {
  RenderReport report;
  EXPECT_TRUE(biases_of(report).empty());
  report.statistics.stop = StopReason::Error;
  EXPECT_EQ(biases_of(report), std::vector<std::string>{"ended by its own error"});
}

// The most samples that can be asked for stand for no limit beside another rule alone.
TEST(Unit_RenderReport, TheMostSamplesAreALimitWhereNothingElseIs) {
  RenderReport report;
  report.options.samples_per_pixel = max_samples_per_pixel;
  EXPECT_TRUE(report.has_sample_limit());
  report.options.time_limit_seconds = 1;
  EXPECT_FALSE(report.has_sample_limit());
}

}  // namespace
}  // namespace candela::cli
