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
  for (int i = 0; i < 50; ++i) diagnostics.error({}, std::to_string(i));
  diagnostics.warning({}, "still kept");
  EXPECT_EQ(diagnostics.error_count(), 50u);
  EXPECT_EQ(diagnostics.list().size(), Diagnostics::limit + 1);
}

TEST(Unit_Diagnostic, ReadersStopWhereErrorsAreCountedNoFurther) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::most_counted; ++i) {
    EXPECT_FALSE(diagnostics.is_full());
    diagnostics.error({}, std::to_string(i));
  }
  EXPECT_TRUE(diagnostics.is_full());
}

TEST(Unit_Diagnostic, TellsTheSameOfTheSamePlaceOnceWhereAsked) {
  const auto file = std::make_shared<const std::string>("a.yaml");
  const auto again = std::make_shared<const std::string>("a.yaml");
  const auto other = std::make_shared<const std::string>("b.yaml");
  Diagnostics diagnostics;
  const auto add = [&](Severity severity, const SourceSpan& span, const char* message) {
    diagnostics.add_once({severity, span, message, ""});
  };
  add(Severity::Error, {file, 3, 7}, "no");
  add(Severity::Error, {again, 3, 7}, "no");
  EXPECT_EQ(diagnostics.error_count(), 1u);
  add(Severity::Error, {file, 3, 8}, "no");
  add(Severity::Error, {file, 3, 7}, "neither");
  add(Severity::Error, {other, 3, 7}, "no");
  add(Severity::Warning, {file, 3, 7}, "no");
  EXPECT_EQ(diagnostics.error_count(), 4u);
  EXPECT_EQ(diagnostics.list().size(), 5u);
}

TEST(Unit_Diagnostic, NamesAllOfAFewWhereNoneIsNear) {
  EXPECT_EQ(nearest_or_all("Difuse", {"Diffuse", "Specular"}), ", did you mean 'Diffuse'?");
  EXPECT_EQ(nearest_or_all("x", {"point", "spot", "distant"}), ", expected point, spot or distant");
  EXPECT_EQ(nearest_or_all("x", {"rgb"}), ", expected rgb");
  EXPECT_EQ(nearest_or_all("x", {}), "");
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
