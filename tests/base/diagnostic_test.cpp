#include "renderer/base/diagnostic.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Unit_Diagnostic, NamesThePlaceThatIsKnown) {
  const auto file = std::make_shared<const std::string>("a.yaml");
  EXPECT_EQ(to_string({Severity::Error, {file, 3, 7}, "no", ""}), "a.yaml:3:7: error: no");
  EXPECT_EQ(to_string({Severity::Warning, {file, 0, 0}, "no", ""}), "a.yaml: warning: no");
  EXPECT_EQ(to_string({Severity::Note, {}, "no", "x\n^"}), "note: no\nx\n^");
}

TEST(Unit_Diagnostic, KeepsAtMostTwentyErrorsAndCountsTheRest) {
  Diagnostics diagnostics;
  for (int i = 0; i < 50; ++i) diagnostics.error({}, "again");
  diagnostics.warning({}, "still kept");
  EXPECT_EQ(diagnostics.error_count(), 50u);
  EXPECT_EQ(diagnostics.list().size(), Diagnostics::limit + 1);
}

TEST(Unit_Diagnostic, ReadersStopWhereErrorsAreCountedNoFurther) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::most_counted; ++i) {
    EXPECT_FALSE(diagnostics.is_full());
    diagnostics.error({}, "again");
  }
  EXPECT_TRUE(diagnostics.is_full());
}

TEST(Unit_Diagnostic, SuggestsOnlyNearNames) {
  EXPECT_EQ(nearest_name("Difuse", {"Diffuse", "Specular"}), "Diffuse");
  EXPECT_EQ(nearest_name("diffuse", {"Diffuse", "Specular"}), "Diffuse");
  EXPECT_EQ(nearest_name("Banana", {"Diffuse", "Specular"}), "");
  EXPECT_EQ(nearest_name("paht", {"path", "raster"}), "path") << "neighbours changed places";
  EXPECT_EQ(nearest_name("PAHT", {"path", "raster"}), "path");
  EXPECT_EQ(nearest_name("ptha", {"path", "raster"}), "") << "not neighbours";
  EXPECT_EQ(nearest_name("thpa", {"path"}), "");
}

}  // namespace
}  // namespace candela
