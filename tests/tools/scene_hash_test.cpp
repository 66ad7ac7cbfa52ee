#include "tools/candela/scene_hash.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/tools/run_program.h"

namespace candela::cli {
namespace {

using cli_test::fresh_folder;
using cli_test::write_text;

std::string hash_of(const std::vector<std::string>& files, const std::vector<std::string>& images) {
  description::SceneDescription description;
  description.files = files;
  for (const std::string& path : images) {
    description.images.emplace_back();
    description.images.back().path = path;
  }
  return scene_hash(description);
}

TEST(Unit_SceneHash, DependsOnContentsAndNotOnPaths) {
  const std::string a = fresh_folder("hash_a");
  const std::string b = fresh_folder("hash_b");
  write_text(a + "/scene", "scene");
  write_text(a + "/image", "image");
  write_text(b + "/other_name", "scene");
  write_text(b + "/picture", "image");
  const std::string hash = hash_of({a + "/scene"}, {a + "/image"});
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash, hash_of({b + "/other_name"}, {b + "/picture"}));

  write_text(b + "/picture", "imagf");
  EXPECT_NE(hash, hash_of({b + "/other_name"}, {b + "/picture"}));
  write_text(b + "/picture", "image");
  write_text(b + "/other_name", "scene ");
  EXPECT_NE(hash, hash_of({b + "/other_name"}, {b + "/picture"}));
}

TEST(Unit_SceneHash, SeesFilesSwappedMissingAndSplitElsewhere) {
  const std::string folder = fresh_folder("hash_swap");
  write_text(folder + "/a", "aaaa");
  write_text(folder + "/b", "bb");
  write_text(folder + "/aa", "aa");
  write_text(folder + "/aabb", "aabb");
  const std::string hash = hash_of({}, {folder + "/a", folder + "/b"});
  EXPECT_NE(hash, hash_of({}, {folder + "/b", folder + "/a"}));
  EXPECT_NE(hash, hash_of({}, {folder + "/a", folder + "/absent"}));
  EXPECT_NE(hash, hash_of({}, {folder + "/aa", folder + "/aabb"}));
}

TEST(Unit_SceneHash, ReadsRegularFilesOnly) {
  const std::string folder = fresh_folder("hash_fifo");
  ASSERT_EQ(::mkfifo((folder + "/fifo").c_str(), 0600), 0);
  const std::string absent = hash_of({}, {folder + "/absent"});
  EXPECT_EQ(hash_of({}, {folder + "/fifo"}), absent);
  EXPECT_EQ(hash_of({}, {"/dev/zero"}), absent);
  EXPECT_EQ(hash_of({}, {folder}), absent);
}

}  // namespace
}  // namespace candela::cli
