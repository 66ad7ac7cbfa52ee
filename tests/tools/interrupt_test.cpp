// Ctrl-C and SIGTERM at every stage of a run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "renderer/image/image_io.h"
#include "tests/tools/run_program.h"
#include "tools/candela/interrupt.h"
#include "tools/candela/output_files.h"

namespace candela::cli_test {
namespace {

// Minutes of work, in tiles that take milliseconds.
std::vector<std::string> long_render(const std::string& folder) {
  return candela_words({"render", small_scene(), "-o", folder + "/a.exr", "-o", folder + "/a.png",
                        "--stats", folder + "/a.json", "--size", "1024x1024", "--spp", "256"});
}

class InterruptedRender : public testing::TestWithParam<int> {};

ProgramResult interrupted_after(useconds_t microseconds, int signal, const std::string& folder) {
  Program program(long_render(folder), ErrorStream::File);
  EXPECT_TRUE(program.wait_for_error_text("256 spp"));
  ::usleep(microseconds);
  program.send(signal);
  return program.finish();
}

TEST_P(InterruptedRender, WritesTheImageSoFarAndEndsWith130) {
  const std::string folder = fresh_folder("interrupt" + std::to_string(GetParam()));
  // Until there is a tile of one sample at least: soon, but not where sanitizers look on.
  ProgramResult result = interrupted_after(1'000'000, GetParam(), folder);
  if (result.error.find("before the first sample") != std::string::npos)
    result = interrupted_after(30'000'000, GetParam(), folder);
  EXPECT_EQ(result.exit_code, 130) << result.error;
  EXPECT_NE(result.error.find("interrupted; the picture holds "), std::string::npos)
      << result.error;
  EXPECT_NE(result.error.find(" of 256"), std::string::npos) << result.error;
  EXPECT_EQ(result.error.find("100 %"), std::string::npos) << result.error;
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"a.exr", "a.json", "a.png"}));
  const Result<Image> image = read_image(folder + "/a.exr");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 1024);
  EXPECT_GT(*std::max_element(image->values.begin(), image->values.end()), 0);
  EXPECT_TRUE(read_image(folder + "/a.png"));
  EXPECT_NE(file_text(folder + "/a.json").find("\"interrupted\": true"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Errors_Interrupt, InterruptedRender, testing::Values(SIGINT, SIGTERM));

TEST(Errors_Interrupt, WhileTheRayLimitIsMeasuredTheRestIsWritten) {
  const std::string folder = fresh_folder("interrupt_ray_limit");
  Program program(
      candela_words({"render", small_scene(), "-o", folder + "/a.exr", "--stats",
                     folder + "/a.json", "--size", "256x256", "--spp", "16", "--ray-limit"}),
      ErrorStream::File);
  ASSERT_TRUE(program.wait_for_error_text("wrote "));
  program.send(SIGINT);
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 130) << result.error;
  EXPECT_NE(result.error.find("the picture is complete"), std::string::npos) << result.error;
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"a.exr", "a.json"}));
  const std::string stats = file_text(folder + "/a.json");
  EXPECT_NE(stats.find("\"interrupted\": false"), std::string::npos) << stats;
  EXPECT_EQ(stats.find("ray_limit\":"), std::string::npos) << stats;
}

TEST(Errors_Interrupt, ASecondSignalEndsAtOnceWithoutFiles) {
  const std::string folder = fresh_folder("interrupt_twice");
  // One sample count so high that the running tiles alone take minutes.
  Program program(candela_words({"render", small_scene(), "-o", folder + "/a.exr", "--size",
                                 "64x64", "--spp", "1000000"}),
                  ErrorStream::File);
  ASSERT_TRUE(program.wait_for_error_text("1000000 spp"));
  program.send(SIGINT);
  program.send(SIGTERM);
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_NE(result.error.find("interrupted twice"), std::string::npos) << result.error;
  EXPECT_EQ(file_names(folder), std::vector<std::string>{});
}

// A mesh that takes a while to read.
void write_large_scene(const std::string& folder) {
  std::ofstream mesh(folder + "/mesh.obj");
  constexpr int side = 700;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) mesh << "v " << x << ' ' << y << " 0\n";
  for (int y = 1; y < side; ++y)
    for (int x = 1; x < side; ++x)
      mesh << "f " << y * side + x << ' ' << y * side + x + 1 << ' ' << (y - 1) * side + x << '\n';
  write_text(folder + "/scene.yaml",
             "Cameras:\n  - Eye: [0, 0, 900]\n    Target: [0, 0, 0]\n"
             "Materials:\n  - Name: m\nModels:\n  - Mesh: mesh.obj\n    Material: m\n");
}

TEST(Errors_Interrupt, WhileTheSceneIsReadNothingIsWritten) {
  const std::string folder = fresh_folder("interrupt_load");
  write_large_scene(folder);
  for (const std::string command : {"render", "info"}) {
    std::vector<std::string> arguments{command, folder + "/scene.yaml"};
    if (command == "render") arguments.insert(arguments.end(), {"-o", folder + "/a.exr"});
    Program program(candela_words(arguments), ErrorStream::File);
    ASSERT_TRUE(program.wait_for_handler());
    ::usleep(30'000);
    program.send(SIGINT);
    const ProgramResult result = program.finish();
    EXPECT_EQ(result.exit_code, 130) << command << result.error;
    EXPECT_EQ(result.output, "");
  }
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"mesh.obj", "scene.yaml"}));
}

TEST(Errors_Interrupt, ASignalThatTheParentIgnoresStaysIgnored) {
  const std::string path = fresh_folder("interrupt_ignored") + "/a.exr";
  const ProgramResult result =
      Program({"/bin/sh", "-c",
               "trap '' INT; \"$0\" render \"$1\" -o \"$2\" --size 256x256 --spp 16 & "
               "sleep 0.2; kill -INT $!; wait $!",
               CANDELA_PROGRAM, small_scene(), path},
              ErrorStream::File)
          .finish();
  EXPECT_EQ(result.exit_code, 0) << result.error;
}

// In a process of its own: a signal while files are written, then a second.
void signal_while_writing(const std::string& folder) {
  std::signal(SIGINT, SIG_DFL);  // an ignored one would stay ignored
  cli::install_signal_handlers();
  const cli::WritingGuard guard({folder + "/a.exr"});
  write_text(folder + "/" + cli::temporary_file_name(::getpid(), 0), "half");
  ::raise(SIGINT);
  write_text(folder + "/still_here", "");
  ::raise(SIGINT);
  write_text(folder + "/too_late", "");
}

TEST(Errors_Interrupt, ASecondSignalWhileWritingRemovesWhatIsHalfWritten) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const std::string folder = fresh_folder("interrupt_writing");
  EXPECT_EXIT(signal_while_writing(folder), testing::ExitedWithCode(130), "interrupted twice");
  EXPECT_EQ(file_names(folder), std::vector<std::string>{"still_here"});
}

// What the handler removes is what the writer makes: names that the folder saw while writing.
TEST(Unit_OutputFiles, TemporaryNamesAreTheWritersOwn) {
  const std::string folder = fresh_folder("temporary_names");
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ASSERT_GE(::inotify_add_watch(watch, folder.c_str(), IN_CREATE), 0);
  ASSERT_FALSE(write_file_atomically(folder + "/a", "bytes").has_errors());
  alignas(inotify_event) char buffer[4096];
  ASSERT_GT(::read(watch, buffer, sizeof buffer), 0);
  const std::string name = reinterpret_cast<const inotify_event*>(buffer)->name;
  ::close(watch);
  bool is_foreseen = false;
  for (unsigned i = 0; i < 10'000 && !is_foreseen; ++i)
    is_foreseen = name == cli::temporary_file_name(::getpid(), i);
  EXPECT_TRUE(is_foreseen) << name;
}

}  // namespace
}  // namespace candela::cli_test
