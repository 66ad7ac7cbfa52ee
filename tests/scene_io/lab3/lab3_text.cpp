#include "tests/scene_io/lab3/lab3_text.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "scene_io/lab3/read_lab3.h"
#include "tests/scenes/folder_guard.h"

namespace candela::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* quad_obj = "v 0 -2 0\nv 1 -2 0\nv 1 -2 1\nv 0 -2 1\nf 1 2 3 4\n";
constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 "
    "0 1 2\n";
constexpr const char* with_mtl_obj =
    "mtllib with.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 2 3 "
    "4\n";
constexpr const char* with_mtl = "newmtl red\nKd 1 0 0\nKe 2 0 0\nnewmtl blue\nKd 0 0 1\n";

std::string make_folder() {
  const fs::path folder =
      fs::path(CANDELA_TEST_OUTPUT) / fmt::format("lab3_text_{}", static_cast<long>(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder / "folder");
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  };
  write("triangle.obj", triangle_obj);
  write("quad.obj", quad_obj);
  write("triangle.ply", triangle_ply);
  write("with_mtl.obj", with_mtl_obj);
  write("with.mtl", with_mtl);
  for (const char* picture : {"picture.png", "other.png", "rt.png", "lt.png", "up.png", "dn.png",
                              "ft.png", "bk.png", "sky.hdr", "sky.exr"})
    write(picture, "not looked into by the reader");
  mkfifo((folder / "pipe").c_str(), 0600);
  return folder.string() + "/";
}

std::string without_file(const Diagnostic& diagnostic) {
  if (diagnostic.span.line == 0) return diagnostic.message;
  return fmt::format("{}:{}: {}", diagnostic.span.line, diagnostic.span.column, diagnostic.message);
}

std::string only_one(const std::vector<std::string>& sentences) {
  return sentences.size() == 1
             ? sentences[0]
             : fmt::format("{} of them: {}", sentences.size(), fmt::join(sentences, " | "));
}

}  // namespace

const std::string& lab3_folder() {
  static const FolderGuard folder{make_folder()};
  return folder.path;
}

Result<description::SceneDescription> parse_lab3_text(std::string_view text,
                                                      const LoadOptions& options) {
  return lab3::parse_lab3(lab3_folder() + "scene.yaml", text, options);
}

description::SceneDescription scene_of(std::string_view text, const LoadOptions& options) {
  Result<description::SceneDescription> scene = parse_lab3_text(text, options);
  for (const Diagnostic& diagnostic : scene.diagnostics.list())
    if (diagnostic.severity == Severity::Error) ADD_FAILURE() << to_string(diagnostic);
  return scene ? std::move(*scene) : description::SceneDescription{};
}

std::vector<std::string> said(Severity severity, std::string_view text,
                              const LoadOptions& options) {
  const Result<description::SceneDescription> scene = parse_lab3_text(text, options);
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : scene.diagnostics.list())
    if (diagnostic.severity == severity) found.push_back(without_file(diagnostic));
  return found;
}

std::string error_in(std::string_view text, const LoadOptions& options) {
  return only_one(said(Severity::Error, text, options));
}

std::string warning_in(std::string_view text, const LoadOptions& options) {
  const Result<description::SceneDescription> scene = parse_lab3_text(text, options);
  EXPECT_FALSE(scene.diagnostics.has_errors()) << error_in(text, options);
  return only_one(said(Severity::Warning, text, options));
}

}  // namespace candela::test
