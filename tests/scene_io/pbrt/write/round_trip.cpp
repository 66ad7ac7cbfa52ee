#include "tests/scene_io/pbrt/write/round_trip.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene_io/pbrt/read_pbrt.h"
#include "tests/scenes/folder_guard.h"

namespace candela::test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

RoundTrip round_trip(const description::SceneDescription& scene, const pbrt::ImageFacts& facts) {
  static const FolderGuard folder{
      (fs::path(CANDELA_TEST_OUTPUT) / fmt::format("pbrt_write_{}", static_cast<long>(getpid())))
          .string()};
  fs::remove_all(folder.path);
  fs::create_directories(folder.path + "/files");
  RoundTrip trip;
  auto written = pbrt::write_pbrt(scene, {"files", "picture.exr", 0, [&](const std::string&) {
                                            return std::optional<pbrt::ImageFacts>(facts);
                                          }});
  trip.diagnostics = written.diagnostics;
  trip.written = *written;
  for (const pbrt::WrittenFile& mesh : trip.written.meshes)
    write(folder.path + "/" + mesh.name, mesh.bytes);
  for (const pbrt::WrittenImage& image : trip.written.images)
    write(folder.path + "/" + image.name, "");
  const std::string path = folder.path + "/scene.pbrt";
  write(path, trip.written.text);
  auto read = pbrt::read_pbrt(path);
  for (const Diagnostic& d : read.diagnostics.list()) ADD_FAILURE() << to_string(d);
  EXPECT_TRUE(read) << trip.written.text;
  if (read) trip.scene = std::move(*read);
  return trip;
}

}  // namespace candela::test
