// docs/library.md shows the very program that the package's test builds and runs.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string text_of(const std::string& path) {
  std::ifstream stream(std::string(CANDELA_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Unit_LibraryPage, ShowsTheConsumerThatIsTested) {
  const std::string page = text_of("docs/library.md");
  const std::string folder = "tests/package/consumer/";
  for (const std::string file : {"consumer.cpp", "CMakeLists.txt"}) {
    std::string shown = text_of(folder + file);
    ASSERT_FALSE(shown.empty()) << file;
    if (shown.starts_with("//")) shown = shown.substr(shown.find('\n') + 1);
    EXPECT_NE(page.find(shown), std::string::npos) << folder << file;
  }
}

}  // namespace
