// Ctrl-C and SIGTERM at every stage of a run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "renderer/image/image_io.h"
#include "renderer/image/temporary_file.h"
#include "tests/tools/run_program.h"
#include "tools/candela/interrupt.h"

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

// In a process of its own.
void signal_that_is_ignored() {
  std::signal(SIGINT, SIG_IGN);
  cli::install_signal_handlers();
  ::raise(SIGINT);
  std::exit(cli::was_interrupted() ? 1 : 0);
}

TEST(Errors_Interrupt, ASignalThatTheParentIgnoresStaysIgnored) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(signal_that_is_ignored(), testing::ExitedWithCode(0), "");
}

// In a process of its own: a signal while a file is written, then a second.
void signal_while_writing(const std::string& folder) {
  std::signal(SIGINT, SIG_DFL);  // an ignored one would stay ignored
  cli::install_signal_handlers();
  cli::set_interrupt_mode(cli::InterruptMode::Finish);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(TemporaryFile(folder).error(), 0);
  TemporaryFile half(folder);
  half.fill("half");
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

// A pipe that has room for `room` bytes, and then stops who writes into it until it is emptied.
class NarrowPipe {
 public:
  NarrowPipe(const std::string& path, std::size_t room) {
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    reader_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const int writer = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    const auto size = static_cast<std::size_t>(::fcntl(writer, F_SETPIPE_SZ, 4096));
    const std::string filling(size - room, '.');
    EXPECT_EQ(::write(writer, filling.data(), filling.size()),
              static_cast<ssize_t>(filling.size()));
    ::close(writer);
  }
  NarrowPipe(const NarrowPipe&) = delete;
  NarrowPipe& operator=(const NarrowPipe&) = delete;
  ~NarrowPipe() { ::close(reader_); }

  [[nodiscard]] std::string empty_it() const {
    std::string text(1 << 16, ' ');
    const ssize_t count = ::read(reader_, text.data(), text.size());
    return text.substr(0, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }

 private:
  int reader_ = -1;
};

void wait_for_file(const std::string& path) {
  for (int i = 0; i < 6000 && !std::filesystem::exists(path); ++i) ::usleep(10'000);
}

// The program hangs in the line that says what was written, before it writes the statistics.
TEST(Errors_Interrupt, BetweenPictureAndStatisticsBothAreWritten) {
  const std::string folder = fresh_folder("interrupt_stats");
  const std::vector<std::string> words = {"render",  small_scene(),
                                          "-o",      folder + "/a.exr",
                                          "--stats", folder + "/a.json",
                                          "--size",  "8x8",
                                          "--spp",   "1",
                                          "-t",      "1"};
  const std::string lines = run_candela(words).error;
  std::filesystem::remove(folder + "/a.exr");
  std::filesystem::remove(folder + "/a.json");
  const std::string pipe = folder + "/messages";
  const NarrowPipe messages(pipe, lines.find('\n') + 20);  // for the first line alone
  std::vector<std::string> in_shell = {"/bin/sh", "-c", "exec \"$0\" \"$@\" 2> " + pipe};
  for (const std::string& word : candela_words(words)) in_shell.push_back(word);
  Program program(in_shell, ErrorStream::File);
  wait_for_file(folder + "/a.exr");
  ::usleep(200'000);
  program.send(SIGTERM);
  ::usleep(50'000);
  std::string text = messages.empty_it();
  EXPECT_EQ(program.finish().exit_code, 0);
  text += messages.empty_it();
  EXPECT_NE(text.find("; wrote "), std::string::npos) << text;
  EXPECT_EQ(text.find("nothing was written"), std::string::npos) << text;
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"a.exr", "a.json", "messages"}));
}

// It hangs in the first of its files.
TEST(Errors_Interrupt, AConversionEndsAfterTheFileThatItIsAt) {
  const std::string folder = fresh_folder("interrupt_convert");
  const std::vector<std::string> words = {"convert", small_scene(), folder + "/a.pbrt"};
  ASSERT_EQ(run_candela(words).exit_code, 0);
  ASSERT_GT(file_names(folder + "/a_files").size(), 2u);
  std::filesystem::remove_all(folder + "/a_files");
  std::filesystem::remove(folder + "/a.pbrt");
  std::filesystem::create_directory(folder + "/a_files");
  const NarrowPipe first(folder + "/a_files/room.ply", 10);
  Program program(candela_words(words), ErrorStream::File);
  ASSERT_TRUE(program.wait_for_handler());
  ::usleep(1'000'000);
  program.send(SIGINT);
  ::usleep(50'000);
  std::thread emptying([&] {  // what comes after the signal
    for (int i = 0; i < 100; ++i) {
      static_cast<void>(first.empty_it());
      ::usleep(10'000);
    }
  });
  const ProgramResult result = program.finish();
  emptying.join();
  EXPECT_EQ(result.exit_code, 130) << result.error;
  EXPECT_NE(result.error.find("a.pbrt' was not written"), std::string::npos) << result.error;
  EXPECT_EQ(file_names(folder), std::vector<std::string>{"a_files"});
  EXPECT_EQ(file_names(folder + "/a_files"), std::vector<std::string>{"room.ply"});
}

}  // namespace
}  // namespace candela::cli_test
