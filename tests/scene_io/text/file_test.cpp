#include "scene_io/text/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "renderer/base/thread_clock.h"
#include "scene_io/text/path.h"
#include "tests/scene_io/gzip.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::text {
namespace {

std::string message_of(const Result<std::string>& result) {
  EXPECT_FALSE(result);
  return result.diagnostics.list().empty() ? "" : result.diagnostics.list()[0].message;
}

TEST(Unit_TextFile, ReadsWholeFiles) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\nc", 5);
  EXPECT_EQ(*read_file(folder.put("a", bytes)), bytes);
  EXPECT_EQ(*read_file(folder.put("empty", std::string())), "");
}

TEST(Unit_TextFile, NamesWithoutTheExtensionOfGzip) {
  EXPECT_EQ(without_gzip_extension("a/b.yaml.gz"), "a/b.yaml");
  EXPECT_EQ(without_gzip_extension("b.ply.GZ"), "b.ply");
  EXPECT_EQ(without_gzip_extension("b.gz.ply"), "b.gz.ply");
  EXPECT_EQ(without_gzip_extension(".gz"), ".gz");
}

TEST(Unit_TextFile, InflatesGzipOfSeveralMembers) {
  const TemporaryFolder folder;
  const std::string text(100'000, 'x');
  EXPECT_EQ(*read_file(folder.put("a.gz", gzip(text))), text);
  EXPECT_EQ(*read_file(folder.put("b.GZ", gzip(text) + gzip("tail"))), text + "tail");
  EXPECT_EQ(*read_file(folder.put("empty.gz", gzip(""))), "");
}

// As gzip itself takes them.
TEST(Unit_TextFile, GzipMayBePaddedWithZeros) {
  const TemporaryFolder folder;
  EXPECT_EQ(*read_file(folder.put("a.gz", gzip("text") + std::string(700, '\0'))), "text");
  EXPECT_FALSE(read_file(folder.put("b.gz", gzip("text") + std::string(700, '\0') + "x")));
}

// What inflates far more than scenes do is refused before it fills the memory.
TEST(Errors_TextFile, GzipThatInflatesTooOften) {
  const TemporaryFolder folder;
  const std::string path = folder.put("a.gz", gzip(std::string(1'000'000, 'x')));
  EXPECT_TRUE(read_file(path));  // within what is small
  FileLimits limits;
  limits.small_bytes = 10'000;
  EXPECT_TRUE(message_of(read_file(path, limits)).ends_with(" bytes; no more is read"));
  limits.inflation = 2000;
  EXPECT_TRUE(read_file(path, limits));
}

// However large a bomb is, it is known before it has filled much more than what is small.
TEST(Errors_TextFile, LargeBombsAreKnownByTheirBeginning) {
  const std::string bomb = gzip(std::string(50'000'000, 'x'));
  const FileLimits limits{.small_bytes = 1'000'000};
  const std::string message = message_of(inflate_gzip(bomb, "bomb.gz", limits));
  EXPECT_EQ(message, "inflates to more than 1000000 bytes; no more is read");
}

TEST(Errors_TextFile, GzipThatIsBrokenCutOrABomb) {
  const TemporaryFolder folder;
  const std::string packed = gzip(std::string(1'000'000, 'x'));
  EXPECT_EQ(message_of(read_file(folder.put("a.gz", packed.substr(0, packed.size() / 2)))),
            "ends in the middle of its gzip data");
  EXPECT_EQ(message_of(read_file(folder.put("a.gz", std::string("plain text")))),
            "is not a sound gzip file");
  EXPECT_EQ(message_of(read_file(folder.put("a.gz", std::string()))),
            "ends in the middle of its gzip data");
  FileLimits limits;
  limits.inflated_bytes = 999'999;
  EXPECT_EQ(message_of(read_file(folder.put("a.gz", packed), limits)),
            "inflates to more than 999999 bytes; no more is read");
  limits.inflated_bytes = 1'000'000;
  EXPECT_TRUE(read_file(folder.file("a.gz"), limits));
}

TEST(Errors_TextFile, WhatIsNoRegularFileOrTooLarge) {
  const TemporaryFolder folder;
  FileLimits limits;
  limits.bytes = 3;
  EXPECT_EQ(message_of(read_file(folder.put("a", std::string("four")), limits)),
            "holds 4 bytes; at most 3 are read");
  EXPECT_EQ(message_of(read_file(folder.file("absent"))),
            "cannot be opened: No such file or directory");
  EXPECT_EQ(message_of(read_file("")), "cannot be opened: No such file or directory");
  EXPECT_EQ(message_of(read_file(folder.path())), "is a folder; expected a regular file");
  EXPECT_EQ(message_of(read_file("/dev/null")), "is a device; expected a regular file");
  EXPECT_EQ(message_of(read_file(std::string("a\0b", 3))), "is not the name of a file");
  ASSERT_EQ(::mkfifo(folder.file("fifo").c_str(), 0600), 0);
  EXPECT_EQ(message_of(read_file(folder.file("fifo"))), "is a FIFO; expected a regular file");
  EXPECT_TRUE(message_of(read_file(std::string(10'000, 'x'))).starts_with("cannot be opened: "));
}

class ResolvePath : public ::testing::Test {
 protected:
  ResolvePath() {
    std::filesystem::create_directories(folder_.file("Textures/Deep"));
    folder_.put("Textures/Deep/Brick.PNG", std::string("x"));
    folder_.put("a b.png", std::string("x"));
    folder_.put("both.png", std::string("x"));
    folder_.put("BOTH.png", std::string("x"));
  }
  [[nodiscard]] ResolvedPath resolve(std::string_view name) const {
    return resolve_path(folder_.file("scene.mtl"), name);
  }
  TemporaryFolder folder_;
};

using Unit_ResolvePath = ResolvePath;

TEST_F(Unit_ResolvePath, FindsFilesBesideTheReferrer) {
  const ResolvedPath found = resolve("Textures/Deep/Brick.PNG");
  EXPECT_EQ(found.path, folder_.file("Textures/Deep/Brick.PNG"));
  EXPECT_TRUE(found.is_found);
  EXPECT_FALSE(found.has_other_case);
  EXPECT_EQ(resolve(" a b.png\r").path, folder_.file("a b.png"));
  EXPECT_EQ(resolve("\"a b.png\"").path, folder_.file("a b.png"));
  EXPECT_TRUE(resolve(folder_.file("a b.png")).is_found);
  EXPECT_TRUE(resolve("Textures/../a b.png").is_found);
}

TEST_F(Unit_ResolvePath, TakesBackSlashesAndOtherLetterCase) {
  const ResolvedPath found = resolve("textures\\DEEP\\.\\brick.png");
  EXPECT_TRUE(found.is_found);
  EXPECT_TRUE(found.has_other_case);
  EXPECT_EQ(found.path, folder_.file("Textures/Deep/./Brick.PNG"));
  EXPECT_EQ(resolve("both.PNG").path, folder_.file("BOTH.png"));
  EXPECT_EQ(resolve("both.png").path, folder_.file("both.png"));
}

TEST_F(Unit_ResolvePath, LooksForForeignAbsoluteNamesByTheirLastPart) {
  EXPECT_EQ(resolve("C:\\Users\\me\\a b.png").path, folder_.file("a b.png"));
  EXPECT_EQ(resolve("/home/me/A B.png").path, folder_.file("a b.png"));
  EXPECT_FALSE(resolve("D:\\absent.png").is_found);
}

TEST_F(Unit_ResolvePath, SaysWhatIsTakenForAnother) {
  const auto described = [&](std::string_view name) {
    const ResolvedPath found = resolve(name);
    return found.is_substitute() ? describe_substitute(found, name) : "";
  };
  const auto taken = [&](std::string_view file, std::string_view rest) {
    return fmt::format("file '{}' is taken for {}", folder_.file(std::string(file)), rest);
  };
  EXPECT_EQ(described("/no/a b.png"), taken("a b.png", "'/no/a b.png', which does not exist"));
  EXPECT_EQ(described("/no/A b.png"), taken("a b.png", "'/no/A b.png', which does not exist"));
  EXPECT_EQ(described("A b.png"), taken("a b.png", "'A b.png': letter case differs"));
  EXPECT_EQ(described("a b.png"), "");
  EXPECT_EQ(described(folder_.file("a b.png")), "");
  EXPECT_EQ(described("/no/such.png"), "");
}

TEST_F(Unit_ResolvePath, SaysWhereAMissingFileWasExpected) {
  const ResolvedPath missing = resolve("no\\such.png");
  EXPECT_FALSE(missing.is_found);
  EXPECT_EQ(missing.path, folder_.file("no/such.png"));
  EXPECT_FALSE(resolve("").is_found);
  EXPECT_FALSE(resolve(std::string_view("a b.png\0x", 9)).is_found);
  EXPECT_FALSE(resolve("both.png/x").is_found);
}

TEST_F(Unit_ResolvePath, KnowsOfFilesThatComeLater) {
  EXPECT_FALSE(resolve("LATER.png").is_found);
  folder_.put("later.png", std::string("x"));
  EXPECT_EQ(resolve("LATER.png").path, folder_.file("later.png"));
  std::filesystem::remove(folder_.file("later.png"));
  EXPECT_FALSE(resolve("LATER.png").is_found);
}

// One listing of the folder each took a minute.
TEST_F(Unit_ResolvePath, ThousandsOfMissingFilesTakeNoTime) {
  constexpr int count = 6000;
  for (int i = 0; i < count; ++i) std::ofstream(folder_.file(fmt::format("{}.ply", i)));
  std::filesystem::last_write_time(
      folder_.path(), std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  const double start = process_cpu_seconds();
  for (int i = 0; i < count; ++i) EXPECT_FALSE(resolve(fmt::format("{}.png", i)).is_found);
  EXPECT_LT(process_cpu_seconds() - start, 5);
  EXPECT_EQ(resolve("7.PLY").path, folder_.file("7.ply"));
}

TEST(Unit_FolderOf, EndsWithItsSlash) {
  EXPECT_EQ(folder_of("a/b/c.obj"), "a/b/");
  EXPECT_EQ(folder_of("c.obj"), "");
}

}  // namespace
}  // namespace candela::text
