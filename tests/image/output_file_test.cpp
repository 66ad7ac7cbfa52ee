// Outputs are whole or not there, and what stands in their way is a sentence.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <functional>

#include "renderer/image/image_io.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

std::string first_message(const Diagnostics& diagnostics) {
  return diagnostics.list().empty() ? "" : diagnostics.list().front().message;
}

// Runs `body` in a process of its own, whose limits and identity it may change; true where it
// returned true there.
bool holds_in_child(const std::function<bool()>& body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body() ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(Unit_OutputFile, HoldsExactlyTheBytesAndNothingElseIsLeft) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\xff", 4);
  EXPECT_FALSE(write_file_atomically(folder.file("x.bin"), bytes).has_errors());
  EXPECT_EQ(contents_of(folder.file("x.bin")), bytes);
  EXPECT_FALSE(write_file_atomically(folder.file("x.bin"), "").has_errors());
  EXPECT_EQ(contents_of(folder.file("x.bin")), "");
  EXPECT_EQ(folder.entries(), 1u);
}

// Of an earlier process of the same number, as there are in containers, that was killed.
TEST(Unit_OutputFile, WhatAKilledProcessLeftIsNotInTheWay) {
  const TemporaryFolder folder;
  constexpr int left = 400;  // more than this process has written
  for (int i = 0; i < left; ++i)
    folder.put(fmt::format(".candela-{}-{}.tmp", ::getpid(), i), std::string("left"));
  EXPECT_FALSE(write_file_atomically(folder.file("x.bin"), "new").has_errors());
  EXPECT_EQ(contents_of(folder.file("x.bin")), "new");
  EXPECT_EQ(folder.entries(), left + 1u);
}

TEST(Unit_OutputFile, KeepsTheModeOfTheFileItReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.bin", std::string("old"));
  ::chmod(path.c_str(), 0640);
  EXPECT_FALSE(write_file_atomically(path, "new").has_errors());
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(Unit_OutputFile, FollowsLinksInsteadOfReplacingThem) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("inner"));
  std::filesystem::create_symlink("inner/real.bin", folder.file("link.bin"));
  EXPECT_FALSE(check_writable_file(folder.file("link.bin")).has_errors());
  EXPECT_FALSE(write_file_atomically(folder.file("link.bin"), "through").has_errors());
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.bin")));
  EXPECT_EQ(contents_of(folder.file("inner/real.bin")), "through");
}

TEST(Unit_OutputFile, TakesNamesAsLongAsTheFileSystemDoes) {
  const TemporaryFolder folder;
  const std::string longest(255, 'x');
  EXPECT_FALSE(write_file_atomically(folder.file(longest), "1").has_errors());
  const Diagnostics found = write_file_atomically(folder.file(longest + "x"), "1");
  EXPECT_NE(first_message(found).find("File name too long"), std::string::npos);
}

TEST(Unit_OutputFile, WritesToDevicesAsTheyStand) {
  EXPECT_FALSE(write_file_atomically("/dev/null", "gone").has_errors());
  struct stat status {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

// As /dev/stdout is in a pipeline: a link to what has no name of its own.
TEST(Unit_OutputFile, WritesToPipesWithoutANameOfTheirOwn) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const std::string path = fmt::format("/proc/self/fd/{}", ends[1]);
  EXPECT_EQ(first_message(check_writable_file(path)), "");
  EXPECT_EQ(first_message(write_file_atomically(path, "light")), "");
  std::array<char, 8> read{};
  EXPECT_EQ(::read(ends[0], read.data(), read.size()), 5);
  EXPECT_EQ(std::string(read.data()), "light");
  for (const int end : ends) ::close(end);
}

// As /dev/stdout behind `>> log`: the file is someone else's, and has no name once it is unlinked.
TEST(Unit_OutputFile, WritesBehindWhatDescriptorsOfFilesHoldAlready) {
  const TemporaryFolder folder;
  const std::string log = folder.put("log", std::string("before "));
  const int descriptor = ::open(log.c_str(), O_RDWR | O_APPEND);
  ASSERT_GE(descriptor, 0);
  const std::string link = folder.file("link");
  std::filesystem::create_symlink(fmt::format("/dev/fd/{}", descriptor), link);
  for (const std::string& path : {fmt::format("/proc/self/fd/{}", descriptor), link}) {
    EXPECT_EQ(first_message(check_writable_file(path)), "");
    EXPECT_EQ(first_message(write_file_atomically(path, "light ")), "");
  }
  EXPECT_EQ(contents_of(log), "before light light ");
  std::filesystem::remove(log);
  EXPECT_EQ(first_message(write_file_atomically(link, "more")), "");
  struct stat status {};
  ASSERT_EQ(::fstat(descriptor, &status), 0);
  EXPECT_EQ(status.st_size, 23);
  EXPECT_EQ(folder.entries(), 1u);  // the link: nothing was written beside
  ::close(descriptor);
}

TEST(Errors_OutputFile, DescriptorsThatTakeNoBytesAreToldBeforeAndAfter) {
  const TemporaryFolder folder;
  const int descriptor = ::open(folder.put("x", std::string("x")).c_str(), O_RDONLY);
  const std::string path = fmt::format("/dev/fd/{}", descriptor);
  EXPECT_NE(first_message(check_writable_file(path)).find("not open for writing"),
            std::string::npos);
  EXPECT_TRUE(write_file_atomically(path, "x").has_errors());
  ::close(descriptor);
  EXPECT_NE(first_message(check_writable_file(path)).find("Bad file"), std::string::npos);
}

TEST(Errors_OutputFile, NamesMissingFoldersDirectoriesAndFullDevices) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& path) {
    return first_message(write_file_atomically(path, "bytes"));
  };
  EXPECT_NE(message(folder.file("none/x.bin")).find("does not exist"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("it is a folder"), std::string::npos);
  EXPECT_NE(message(folder.path() + "/").find("it names no file"), std::string::npos);
  EXPECT_NE(message("").find("it names no file"), std::string::npos);
  EXPECT_NE(message("/dev/full").find("No space left on device"), std::string::npos);
  const std::string file = folder.put("file", std::string("x"));
  EXPECT_NE(message(file + "/x.bin").find("is not a folder"), std::string::npos);
  EXPECT_NE(first_message(check_writable_file(folder.file("none/x"))).find("none"),
            std::string::npos);
}

TEST(Errors_OutputFile, DoesNotWaitForAReaderOfAFifo) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("fifo").c_str(), 0600), 0);
  EXPECT_TRUE(write_file_atomically(folder.file("fifo"), "x").has_errors());
}

TEST(Errors_OutputFile, AFullDiskLeavesTheOldFileWholeAndNothingBeside) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.bin", std::string("old"));
  EXPECT_TRUE(holds_in_child([&] {
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const Diagnostics found = write_file_atomically(path, std::string(100000, 'x'));
    return first_message(found).find("File too large") != std::string::npos;
  }));
  EXPECT_EQ(contents_of(path), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(Errors_OutputFile, ForbiddenFoldersAndFilesAreToldBeforeAndAfter) {
  const TemporaryFolder folder;
  const std::string locked = folder.put("locked.png", std::string("old"));
  ::chmod(locked.c_str(), 0444);
  std::filesystem::create_directory(folder.file("closed"));
  ::chmod(folder.file("closed").c_str(), 0555);
  std::filesystem::create_directory(folder.file("open"));
  ::chmod(folder.file("open").c_str(), 0777);
  EXPECT_TRUE(holds_in_child([&] {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::seteuid(nobody) != 0) return false;
    const auto is_denied = [](const Diagnostics& found) {
      return first_message(found).find("Permission denied") != std::string::npos;
    };
    return is_denied(check_writable_image(locked)) &&
           is_denied(write_file_atomically(locked, "")) &&
           is_denied(check_writable_image(folder.file("closed/x.png"))) &&
           is_denied(write_file_atomically(folder.file("closed/x.png"), "")) &&
           !check_writable_image(folder.file("open/x.png")).has_errors();
  }));
}

}  // namespace
}  // namespace candela
