// Every way to end but success, through the built program.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "tests/address_space.h"
#include "tests/tools/run_program.h"
#include "tools/candela/guarded.h"
#include "tools/candela/output_files.h"
#include "tools/candela/parse_arguments.h"

namespace candela::cli_test {
namespace {

using cli::ExitCode;

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& sentence) {
  const ProgramResult result = run_candela(arguments);
  EXPECT_EQ(result.exit_code, 2) << result.error;
  EXPECT_EQ(result.output, "");
  EXPECT_NE(result.error.find(sentence), std::string::npos) << result.error;
}

// Without a process.
void expect_refused(const std::vector<std::string>& words, const std::string& sentence) {
  const cli::ParsedArguments parsed = cli::parse_arguments(words);
  EXPECT_FALSE(parsed.arguments);
  EXPECT_EQ(parsed.exit_code, ExitCode::Usage);
  EXPECT_EQ(parsed.output, "");
  EXPECT_NE(parsed.error.find(sentence), std::string::npos) << parsed.error;
}

TEST(Errors_CommandLine, UsageErrorsEndWithTwo) {
  expect_usage_error({},
                     "candela: expected a command: render, info, check, compare, convert, bench");
  expect_usage_error({"render", "s.yaml", "--integrator", "pth"},
                     "candela render: --integrator: unknown integrator 'pth', did you mean 'path'? "
                     "Known: path");
}

TEST(Errors_CommandLine, UsageErrorsAreSentencesWithSuggestions) {
  expect_refused({"rendr", "s.yaml"}, "unknown command 'rendr', did you mean 'render'?");
  expect_refused({"--verson"}, "unknown option '--verson', did you mean '--version'?");
  expect_refused({"render"}, "candela render: SCENE is missing");
  expect_refused({"compare", "a.exr"}, "candela compare: REFERENCE is missing");
  expect_refused({"render", "s.yaml", "--thread", "2"},
                 "unknown option '--thread', did you mean '--threads'?");
  expect_refused({"render", "s.yaml", "--sppp=2"},
                 "unknown option '--sppp', did you mean '--spp'?");
  expect_refused({"render", "s.yaml", "-z"}, "unknown option '-z'");
  expect_refused({"render", "s.yaml", "t.yaml"}, "unexpected 't.yaml'");
  expect_refused({"render", "s.yaml", "--spp"}, "--spp needs a value");
  expect_refused({"render", "s.yaml", "-o"}, "--output needs a value");
  expect_refused({"render", "s.yaml", "--spp", "0"},
                 "--spp: expected a whole number from 1 to 1073741824, found '0'");
  expect_refused({"render", "s.yaml", "--filter", "gausian"}, "did you mean 'gaussian'?");
  expect_refused({"render", "s.yaml", "--accel", "embre"}, "did you mean 'embree'?");
  expect_refused({"render", "s.yaml", "--tonemap", "acess"}, "did you mean 'aces'?");
  expect_refused({"render", "s.yaml", "--size", "640"}, "such as 640x480");
  for (const char* word : {"--quiet=maybe", "--quiet=0", "--transparent=5", "--strict=false"})
    expect_refused({"render", "s.yaml", "-q", word},
                   fmt::format("candela render: {} takes no value\n",
                               std::string_view(word).substr(0, std::string_view(word).find('='))));
  expect_refused({"info", "s.yaml", "--spp", "3"}, "unknown option '--spp'");
  expect_refused({"--spp", "3", "render", "s.yaml"},
                 "candela render: '--spp' stands before the command; its options come behind it");
  expect_refused({"-q", "render", "s.yaml"},
                 "candela render: '-q' stands before the command; its options come behind it");
  expect_refused({"-q", "info", "s.yaml"}, "candela info: unknown option '-q'");
}

TEST(Errors_CommandLine, WhatTheSceneDoesNotHaveIsAUsageError) {
  const std::string image = fresh_folder("usage_scene") + "/a.exr";
  expect_usage_error({"render", small_scene(), "-o", image, "--camera", "7"},
                     "--camera 7: the scene has only camera 0");
  EXPECT_FALSE(std::filesystem::exists(image));
}

TEST(Errors_CommandLine, AbsentAndBrokenScenesEndWithThree) {
  const std::string folder = fresh_folder("broken_scene");
  write_text(folder + "/broken.yaml", "Cameras: [\n");
  write_text(folder + "/scene.unknown", "");
  const auto expect_three = [&](const std::string& command, const std::string& name) {
    std::vector<std::string> arguments{command, folder + name};
    if (command == "render") arguments.insert(arguments.end(), {"-o", folder + "/a.exr"});
    const ProgramResult result = run_candela(arguments);
    EXPECT_EQ(result.exit_code, 3) << command << name << result.error;
    EXPECT_NE(result.error.find("error: "), std::string::npos) << result.error;
  };
  for (const char* name : {"/broken.yaml", "/absent.yaml", "/scene.unknown"})
    expect_three("render", name);
  for (const char* command : {"info", "check", "bench"}) expect_three(command, "/broken.yaml");
  EXPECT_FALSE(std::filesystem::exists(folder + "/a.exr"));
}

TEST(Errors_CommandLine, StrictTurnsWarningsIntoErrors) {
  const std::string folder = fresh_folder("strict");
  write_text(folder + "/unknown_key.yaml", file_text(small_scene()) + "\nNonsense: 1\n");
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(small_scene()).parent_path()))
    if (file.path().extension() == ".obj") std::filesystem::copy(file.path(), folder);
  const std::string scene = folder + "/unknown_key.yaml";
  const std::vector<std::string> words{"render", scene, "-o",    folder + "/a.exr",
                                       "--size", "4x4", "--spp", "1"};
  const ProgramResult lenient = run_candela(words);
  EXPECT_EQ(lenient.exit_code, 0) << lenient.error;
  EXPECT_NE(lenient.error.find("warning"), std::string::npos);
  std::filesystem::remove(folder + "/a.exr");

  std::vector<std::string> strict = words;
  strict.push_back("--strict");
  const ProgramResult refused = run_candela(strict);
  EXPECT_EQ(refused.exit_code, 3) << refused.error;
  EXPECT_FALSE(std::filesystem::exists(folder + "/a.exr"));

  EXPECT_EQ(run_candela({"check", scene, "--strict"}).exit_code, 3);
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"info", scene}, {"convert", scene, folder + "/a.pbrt"}}) {
    std::vector<std::string> strict_words = other;
    strict_words.push_back("--strict");
    const ProgramResult result = run_candela(strict_words);
    EXPECT_EQ(result.exit_code, 3) << result.error;
    EXPECT_NE(result.error.find("error: --strict: 1 warning about"), std::string::npos)
        << result.error;
  }
}

TEST(Errors_CommandLine, StrictRefusesWhatOptionsAreWarnedOf) {
  const std::string folder = fresh_folder("strict_options");
  const auto run = [&](const std::string& image, const std::vector<std::string>& options) {
    std::vector<std::string> words = {"render",  small_scene(), "--size", "2x2",
                                      "--spp",   "1",           "-o",     folder + "/" + image,
                                      "--strict"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = run_candela(words);
    if (result.exit_code != 0) {
      EXPECT_NE(result.error.find("--strict: 1 warning about"), std::string::npos) << result.error;
    }
    return result.exit_code;
  };
  EXPECT_EQ(run("a.png", {"--clamp", "1"}), 3);
  EXPECT_EQ(run("a.png", {"--aov", "albedo"}), 3);
  EXPECT_TRUE(file_names(folder).empty());
  EXPECT_EQ(run("a.Exr", {"--aov", "albedo"}), 0);
}

TEST(Errors_CommandLine, OutputsAreCheckedByFolderExtensionAndName) {
  const std::string folder = fresh_folder("outputs");
  std::filesystem::create_directory(folder + "/folder.exr");
  const auto check = [&](const std::vector<std::string>& images,
                         const std::optional<std::string>& stats) {
    const cli::OutputCheck result = cli::check_outputs(images, stats);
    EXPECT_EQ(result.diagnostics.has_errors(), result.exit_code != ExitCode::Done);
    return result.exit_code;
  };
  EXPECT_EQ(check({folder + "/none/a.exr"}, {}), ExitCode::Output);
  EXPECT_EQ(check({folder + "/a.xyz"}, {}), ExitCode::Output);
  EXPECT_EQ(check({folder + "/a"}, {}), ExitCode::Output);
  EXPECT_EQ(check({"/proc/a.exr"}, {}), ExitCode::Output);  // nobody may write there, root included
  EXPECT_EQ(check({folder + "/folder.exr"}, {}), ExitCode::Output);
  EXPECT_EQ(check({folder + "/a.exr"}, folder + "/none/s.json"), ExitCode::Output);
  EXPECT_EQ(check({folder + "/a.exr"}, ""), ExitCode::Output);
  EXPECT_EQ(check({folder + "/a.exr", folder + "/./a.exr"}, {}), ExitCode::Usage);
  EXPECT_EQ(check({"none.exr", "./none.exr"}, {}), ExitCode::Usage);
  EXPECT_EQ(check({"none.exr"}, std::filesystem::current_path() / "none.exr"), ExitCode::Usage);
  EXPECT_EQ(check({folder + "/a.exr", folder + "/a.png"}, folder + "/s"), ExitCode::Done);
  EXPECT_EQ(file_names(folder), std::vector<std::string>{"folder.exr"});
  std::filesystem::create_symlink("a.exr", folder + "/link.exr");  // to what is not there yet
  EXPECT_EQ(check({folder + "/a.exr", folder + "/link.exr"}, {}), ExitCode::Usage);
}

// The scene does not exist: had it been looked for first, the code would be 3.
TEST(Errors_CommandLine, OutputsAreCheckedBeforeTheScene) {
  const ProgramResult result =
      run_candela({"render", "/absent.yaml", "-o", fresh_folder("outputs_first") + "/none/a.exr"});
  EXPECT_EQ(result.exit_code, 4) << result.error;
}

TEST(Errors_CommandLine, FoldersWithoutPermissionAreRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const std::string folder = fresh_folder("read_only");
  ::chmod(folder.c_str(), 0500);
  EXPECT_EQ(run_candela({"render", "absent.yaml", "-o", folder + "/a.exr"}).exit_code, 4);
  ::chmod(folder.c_str(), 0700);
}

TEST(Errors_CommandLine, AFailedWriteIsNotCalledDone) {
  const std::string folder = fresh_folder("full_disk");
  std::filesystem::create_symlink("/dev/full", folder + "/full.png");
  const ProgramResult result =
      run_candela({"render", small_scene(), "--size", "4x4", "--spp", "1", "-o",
                   folder + "/full.png", "-o", folder + "/whole.exr"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.error.find("100 %"), std::string::npos) << result.error;
  EXPECT_TRUE(std::filesystem::exists(folder + "/whole.exr"));
}

// Else a file that is opened would become the stream that messages go to.
TEST(Errors_CommandLine, ClosedStreamsKeepTheirPlaces) {
  const std::string image = fresh_folder("closed_streams") + "/a.exr";
  const std::string script =
      "\"$0\" render \"$1\" -o \"$2\" --size 1024x1024 --spp 4096 <&- 2>&- & "
      "for i in $(seq 1000); do readlink /proc/$!/fd/2 && break; sleep 0.01; done; "
      "readlink /proc/$!/fd/0; kill -KILL $!";
  const ProgramResult result =
      Program({"/bin/sh", "-c", script, CANDELA_PROGRAM, small_scene(), image}, ErrorStream::File)
          .finish();
  EXPECT_EQ(result.output, "/dev/null\n/dev/null\n");
}

TEST(Errors_CommandLine, FilesOfTheSceneAreNotOverwritten) {
  const std::string folder = fresh_folder("overwrite");
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(CANDELA_SOURCE_DIR) + "/assets/cutouts"))
    std::filesystem::copy(file.path(), folder);
  const std::string before = file_text(folder + "/leaf.png");
  const ProgramResult result = run_candela({"render", folder + "/cutouts.yaml", "-o",
                                            folder + "/leaf.png", "--size", "4x4", "--spp", "1"});
  EXPECT_EQ(result.exit_code, 4) << result.error;
  EXPECT_EQ(file_text(folder + "/leaf.png"), before);
}

// What would only be found when the picture is there.
TEST(Errors_CommandLine, OutputsThatCannotHoldThePictureAreFoundBefore) {
  const std::string folder = fresh_folder("late_outputs");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"-o", folder + "/a.jpg", "--size", "65536x2"},
        std::vector<std::string>{"-o", folder + "/a.png", "--size", "2x2", "--stats", ""}}) {
    std::vector<std::string> arguments = {"render", small_scene(), "--spp", "1"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ProgramResult result = run_candela(arguments);
    EXPECT_EQ(result.exit_code, 4) << result.error;
    EXPECT_NE(result.error.find("cannot be written: "), std::string::npos) << result.error;
    EXPECT_EQ(result.error.find("triangles"), std::string::npos) << result.error;
    EXPECT_TRUE(file_names(folder).empty());
  }
}

TEST(Errors_CommandLine, PicturesBeyondTheMemoryEndWithFive) {
  const std::string image = fresh_folder("giant") + "/a.exr";
  const ProgramResult result =
      run_candela({"render", small_scene(), "--size", "65536x65536", "-o", image});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_NE(result.error.find("GB of memory"), std::string::npos) << result.error;
}

TEST(Errors_CommandLine, CheckEndsAsRenderDoes) {
  const std::string scene = fresh_folder("giant_scene") + "/a.pbrt";
  const std::string film =
      "Film \"rgb\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\n";
  write_text(scene, film + "WorldBegin\nLightSource \"infinite\" Shape \"sphere\"\n");
  EXPECT_EQ(run_candela({"check", scene}).exit_code, 5);
  write_text(scene, film + "WorldBegin\nShape \"plymesh\" \"string filename\" \"none.ply\"\n");
  EXPECT_EQ(run_candela({"check", scene}).exit_code, 3);
}

TEST(Errors_CommandLine, WhoMakesNoPictureNeedsNoMemoryForIt) {
  const std::string folder = fresh_folder("giant_told");
  write_text(folder + "/a.pbrt",
             "Film \"rgb\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\n"
             "WorldBegin\nLightSource \"infinite\" Shape \"sphere\"\n");
  EXPECT_EQ(run_candela({"info", folder + "/a.pbrt"}).exit_code, 0);
  EXPECT_EQ(run_candela({"convert", folder + "/a.pbrt", folder + "/b.pbrt"}).exit_code, 0);
}

TEST(Errors_CommandLine, RunningOutOfMemoryEndsWithFive) {
  if (!test::can_limit_address_space)
    GTEST_SKIP() << "the address sanitizer needs more address space than the limit";
  const std::string image = fresh_folder("memory") + "/a.exr";
  std::vector<std::string> words{"/bin/sh", "-c", "ulimit -v 1500000; exec \"$0\" \"$@\""};
  for (const std::string& word :
       candela_words({"render", small_scene(), "--size", "8192x8192", "-t", "1", "-o", image}))
    words.push_back(word);
  const ProgramResult result = Program(words, ErrorStream::File).finish();
  EXPECT_EQ(result.exit_code, 5) << result.error;
  EXPECT_NE(result.error.find("out of memory"), std::string::npos) << result.error;
  EXPECT_FALSE(std::filesystem::exists(image));
}

TEST(Errors_CommandLine, WhatNobodyCaughtIsABug) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(cli::guarded([]() -> ExitCode { throw std::runtime_error("surprise"); }),
            ExitCode::Bug);
  EXPECT_EQ(cli::guarded([]() -> ExitCode { throw 1; }), ExitCode::Bug);
  EXPECT_EQ(cli::guarded([]() -> ExitCode { throw std::bad_alloc(); }), ExitCode::Limit);
  const auto lacks_threads = []() -> ExitCode {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  };
  EXPECT_EQ(cli::guarded(lacks_threads), ExitCode::Limit);
  const auto as_onetbb_says = []() -> ExitCode {
    throw std::runtime_error("pthread_create has failed: Resource temporarily unavailable");
  };
  EXPECT_EQ(cli::guarded(as_onetbb_says), ExitCode::Limit);
  EXPECT_EQ(cli::guarded([] { return ExitCode::Comparison; }), ExitCode::Comparison);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("bug in candela: surprise"),
            std::string::npos);
}

TEST(Errors_CommandLine, AClosedPipeAndAFullDiskAreOutputErrors) {
  const std::string code_path = fresh_folder("closed_pipe") + "/code";
  const auto shell = [&](const std::string& command) {
    return Program({"/bin/sh", "-c", command, CANDELA_PROGRAM, small_scene(), code_path},
                   ErrorStream::File)
        .finish();
  };
  const ProgramResult full = shell("exec \"$0\" info \"$1\" >/dev/full");
  EXPECT_EQ(full.exit_code, 4);
  EXPECT_NE(full.error.find("cannot be written"), std::string::npos);
  const ProgramResult limited = shell(
      "ulimit -f 1; head -c 1000 /dev/zero >>\"$2\"; exec \"$0\" info \"$1\" --json >>\"$2\"");
  EXPECT_EQ(limited.exit_code, 4);
  EXPECT_NE(limited.error.find("cannot be written"), std::string::npos);
  const ProgramResult closed = shell("{ \"$0\" info \"$1\"; echo $? >\"$2\"; } | true");
  EXPECT_EQ(file_text(code_path), "4\n");
  EXPECT_EQ(closed.error, "");
}

}  // namespace
}  // namespace candela::cli_test
