// Every input of the fuzzers' corpora, those among them that once found a fault, in every build.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/fuzz/readers.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::fuzz {
namespace {

std::vector<std::filesystem::path> inputs_of(const Reader& reader) {
  std::vector<std::filesystem::path> paths;
  const auto folder = std::filesystem::path(CANDELA_SOURCE_DIR) / "tests/fuzz/corpus" / reader.name;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(Unit_FuzzCorpus, EveryInputEndsInASoundResultOrInErrors) {
  testing::internal::CaptureStderr();  // libpng and libtiff complain there
  for (const Reader& reader : readers) {
    const auto inputs = inputs_of(reader);
    EXPECT_GT(inputs.size(), 2u) << reader.name;
    for (const auto& input : inputs)
      EXPECT_EQ(reader.attempt(contents_of(input.string())), "") << input;
  }
  (void)testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace candela::fuzz
