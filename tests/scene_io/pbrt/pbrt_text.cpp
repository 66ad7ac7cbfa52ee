#include "tests/scene_io/pbrt/pbrt_text.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene_io/pbrt/read_pbrt.h"
#include "tests/scenes/folder_guard.h"

namespace candela::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 "
    "0 1 2\n";

std::string make_folder() {
  const fs::path folder =
      fs::path(CANDELA_TEST_OUTPUT) / fmt::format("pbrt_text_{}", static_cast<long>(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder / "folder");
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  };
  write("triangle.ply", triangle_ply);
  write("quad.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n-2 -2 0\n2 "
        "-2 0\n2 2 0\n-2 2 0\n4 0 1 2 3\n");
  write("broken.ply",
        "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n");
  write("white.spd", "# constant\n300 1\n900 1\n");
  write("world.pbrt", "Shape \"disk\"\n");
  write("state.pbrt", "Material \"conductor\"\nTranslate 1 0 0\nShape \"disk\"\n");
  write("self.pbrt", "Include \"self.pbrt\"\n");
  write("broken.pbrt", "Foo\n");
  write("quoted.spd", "300 .2 500 .2\n\"oops\" 600 .8 900 .8\n");
  write("marked.pbrt", "\xef\xbb\xbfShape \"disk\"\n");
  write("wide.pbrt", std::string("\xff\xfe"
                                 "S\0h\0a\0p\0e\0",
                                 12));
  write("spot.pbrt", "LightSource \"spot\" \"point from\" [ 0 0 1 ] \"point to\" [ 0 0 ]\n");
  write("mesh.pbrt",
        "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ -1 ]\n");
  write("unclosed.pbrt", "AttributeBegin\nShape \"disk\"\n");
  for (const char* picture : {"picture.png", "picture.exr"})
    write(picture, "not looked into by the reader");
  for (int i = 0; i < 1000; ++i)
    write(fmt::format("deep{}.pbrt", i).c_str(), fmt::format("Include \"deep{}.pbrt\"\n", i + 1));
  mkfifo((folder / "pipe").c_str(), 0600);
  return folder.string() + "/";
}

std::string without_file(const Diagnostic& diagnostic) {
  if (diagnostic.span.line == 0) return diagnostic.message;
  return fmt::format("{}:{}: {}", diagnostic.span.line, diagnostic.span.column, diagnostic.message);
}

// Of any severity where none is given.
std::string only_one(std::optional<Severity> severity, std::string_view text) {
  std::vector<std::string> found;
  const auto scene = parse_pbrt_text(text);
  for (const Diagnostic& diagnostic : scene.diagnostics.list())
    if (!severity || diagnostic.severity == *severity) found.push_back(without_file(diagnostic));
  return found.size() == 1 ? found[0]
                           : fmt::format("{} of them: {}", found.size(), fmt::join(found, " | "));
}

std::string in_world(std::string_view text) {
  return "WorldBegin\n" + std::string(text);
}

}  // namespace

const std::string& pbrt_folder() {
  static const FolderGuard folder{make_folder()};
  return folder.path;
}

Result<description::SceneDescription> parse_pbrt_text(std::string_view text) {
  return pbrt::parse_pbrt(pbrt_folder() + "scene.pbrt", std::string(text));
}

description::SceneDescription pbrt_scene(std::string_view text) {
  Result<description::SceneDescription> scene = parse_pbrt_text(text);
  for (const Diagnostic& diagnostic : scene.diagnostics.list())
    if (diagnostic.severity == Severity::Error) ADD_FAILURE() << to_string(diagnostic);
  return scene ? std::move(*scene) : description::SceneDescription{};
}

description::SceneDescription pbrt_world(std::string_view text) {
  return pbrt_scene(in_world(text));
}

std::string pbrt_error(std::string_view text) {
  return only_one(Severity::Error, text);
}
std::string pbrt_warning(std::string_view text) {
  return only_one(Severity::Warning, text);
}
std::string pbrt_message(std::string_view text) {
  return only_one(std::nullopt, text);
}
std::string pbrt_world_message(std::string_view text) {
  return pbrt_message(in_world(text));
}
std::string pbrt_world_error(std::string_view text) {
  return pbrt_error(in_world(text));
}
std::string pbrt_world_warning(std::string_view text) {
  return pbrt_warning(in_world(text));
}

void expect_near(const Vec3d& vector, const Vec3d& expected) {
  EXPECT_LT(length(vector - expected), 1e-9) << vector.x << " " << vector.y << " " << vector.z;
}

}  // namespace candela::test
