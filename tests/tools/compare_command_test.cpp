// `candela compare` through the built program.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "renderer/image/image_io.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

// Grey, one pixel brighter.
void write_grey(const std::string& path, int side, float bright) {
  Image image(side, side, {"R", "G", "B"});
  for (float& value : image.values) value = 0.5f;
  for (int c = 0; c < 3; ++c) image.pixel(1, 2)[c] = bright;
  ASSERT_FALSE(write_image(path, image, {}).has_errors());
}

class CompareCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder = fresh_folder("compare");
    write_grey(folder + "/a.exr", 4, 0.5f);
    write_grey(folder + "/b.exr", 4, 1.0f);
    write_grey(folder + "/small.exr", 3, 0.5f);
  }
  [[nodiscard]] ProgramResult compare(const std::string& image, const std::string& reference,
                                      const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"compare", folder + image, folder + reference};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_candela(arguments);
  }
  std::string folder;
};
using Unit_CompareCommand = CompareCommand;
using Errors_CompareCommand = CompareCommand;

TEST_F(Unit_CompareCommand, MeasuresAndDrawsTheDifference) {
  const ProgramResult result =
      compare("/b.exr", "/a.exr", {"--json", "--heatmap", folder + "/heat.png"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  auto json = nlohmann::json::parse(result.output);
  // One of 16 pixels is off by 0.5; epsilon is a hundredth of 0.5 squared.
  EXPECT_NEAR(json["relmse"].get<double>(), 0.25 / (0.25 * 1.01) / 16, 1e-6);
  EXPECT_NEAR(json["mean_ratio"][0].get<double>(), 17.0 / 16, 1e-6);
  EXPECT_EQ(json["worst_pixel"]["x"], 1);
  EXPECT_EQ(json["worst_pixel"]["y"], 2);
  const Result<Image> heatmap = read_image(folder + "/heat.png");
  ASSERT_TRUE(heatmap);
  EXPECT_GT(heatmap->pixel(1, 2)[0], heatmap->pixel(0, 0)[0]);
}

TEST_F(Unit_CompareCommand, PartsOfDifferentPlacesAreWarnedOf) {
  const Image image(4, 4, {"R", "G", "B"});
  WriteOptions options;
  options.offset_x = 2;
  options.offset_y = 3;
  options.full_width = options.full_height = 9;
  ASSERT_FALSE(write_image(folder + "/part.exr", image, options).has_errors());
  EXPECT_NE(compare("/part.exr", "/a.exr").error.find("are 2,3 and 0,0"), std::string::npos);
  EXPECT_EQ(compare("/part.exr", "/part.exr").error, "");
}

TEST_F(Unit_CompareCommand, EqualImagesPassAnyThreshold) {
  const ProgramResult result = compare("/a.exr", "/a.exr", {"--max-relmse", "0"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.output.find("relMSE          0\n"), std::string::npos) << result.output;
}

TEST_F(Errors_CompareCommand, AboveTheThresholdEndsWithSix) {
  const ProgramResult result = compare("/b.exr", "/a.exr", {"--max-relmse", "0.06"});
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_NE(result.error.find("is not within 0.06"), std::string::npos) << result.error;
}

TEST_F(Errors_CompareCommand, ImagesThatDoNotFitEndWithThreeAndLateOutputsWithFour) {
  EXPECT_EQ(compare("/small.exr", "/a.exr").exit_code, 3);
  EXPECT_EQ(compare("/absent.exr", "/a.exr").exit_code, 3);
  EXPECT_EQ(compare("/b.exr", "/a.exr", {"--heatmap", folder + "/none/heat.png"}).exit_code, 4);
}

TEST_F(Errors_CompareCommand, TheHeatmapTakesNoInputsPlace) {
  const std::string before = file_text(folder + "/a.exr");
  for (const char* path : {"/a.exr", "/./b.exr"}) {
    const ProgramResult result = compare("/b.exr", "/a.exr", {"--heatmap", folder + path});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.error.find("would be overwritten"), std::string::npos) << result.error;
  }
  EXPECT_EQ(file_text(folder + "/a.exr"), before);
}

TEST_F(Errors_CompareCommand, NotANumberPassesNoThreshold) {
  write_grey(folder + "/nan.exr", 4, std::nanf(""));
  const ProgramResult result = compare("/nan.exr", "/a.exr", {"--max-relmse", "1000"});
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_NE(result.error.find("3 values are not finite"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("relMSE trimmed not all of their pixels"), std::string::npos);
  EXPECT_NE(result.output.find("relMSE trimmed  inf"), std::string::npos) << result.output;
}

// Those that are fewer than it leaves out.
TEST_F(Errors_CompareCommand, TheTrimmedErrorLeavesOutAPixelThatIsNoNumber) {
  write_grey(folder + "/large.exr", 40, 0.5f);
  write_grey(folder + "/nan.exr", 40, std::nanf(""));
  const ProgramResult result = compare("/nan.exr", "/large.exr");
  EXPECT_NE(result.error.find("relMSE trimmed their pixels"), std::string::npos) << result.error;
  EXPECT_NE(result.output.find("relMSE trimmed  0 "), std::string::npos) << result.output;
}

}  // namespace
}  // namespace candela::cli_test
