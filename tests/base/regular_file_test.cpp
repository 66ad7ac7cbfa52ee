#include "renderer/base/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

TEST(Unit_RegularFile, IsOpenWithItsSize) {
  const TemporaryFolder folder;
  const std::string path = folder.put("a.txt", std::string("12345"));
  const std::string link = folder.path() + "/link";
  ASSERT_EQ(::symlink(path.c_str(), link.c_str()), 0);
  for (const std::string& name : {path, link}) {
    const RegularFile file = open_regular_file(name);
    ASSERT_TRUE(file.descriptor.is_open());
    EXPECT_EQ(file.error, 0);
    EXPECT_EQ(file.kind, "");
    EXPECT_EQ(file.size, 5u);
    std::string bytes(8, ' ');
    EXPECT_EQ(read_some(file.descriptor, bytes.data(), bytes.size()), 5);
    EXPECT_EQ(bytes, "12345   ");
    EXPECT_EQ(read_some(file.descriptor, bytes.data(), bytes.size()), 0);
  }
}

TEST(Errors_RegularFile, OthersAreNamedAndNotOpened) {
  const TemporaryFolder folder;
  const std::string fifo = folder.path() + "/fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const auto kind = [](const std::string& path) {
    const RegularFile file = open_regular_file(path);
    EXPECT_FALSE(file.descriptor.is_open()) << path;
    EXPECT_EQ(file.error, 0) << path;
    return file.kind;
  };
  EXPECT_EQ(kind(folder.path()), "a folder");
  EXPECT_EQ(kind(fifo), "a FIFO");
  EXPECT_EQ(kind("/dev/null"), "a device");
}

TEST(Errors_RegularFile, WhatIsNotThereHasTheSystemsError) {
  const RegularFile file = open_regular_file("no such file");
  EXPECT_FALSE(file.descriptor.is_open());
  EXPECT_EQ(file.error, ENOENT);
  EXPECT_EQ(file.kind, "");
}

}  // namespace
}  // namespace candela
