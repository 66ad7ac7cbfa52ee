#include "tests/fuzz/scene_folder.h"
#include "tests/scenes/folder_guard.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace candela::fuzz {
namespace {

namespace fs = std::filesystem;

std::string make_folder() {
  const fs::path folder =
      fs::temp_directory_path() / ("candela_fuzz_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  };
  write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nf 1/1 2/2 3/1\n");
  write("triangle.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
        "0\n0 1 0\n3 0 1 2\n");
  write("with.obj",
        "mtllib with.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf "
        "2 3 4\n");
  write("with.mtl", "newmtl red\nKd 1 0 0\nKe 2 0 0\nnewmtl blue\nKd 0 0 1\nmap_Kd picture.png\n");
  write("part.pbrt", "Translate 1 0 0\nShape \"disk\" \"float phimax\" 20\n");
  write("white.spd", "300 1\n900 1\n");
  write("picture.png", "no PNG: a scene's reader does not look, and rendering makes it magenta");
  write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\nabcdefgh");
  return folder.string() + "/";
}

}  // namespace

const std::string& scene_folder() {
  static const test::FolderGuard folder{make_folder()};
  return folder.path;
}

}  // namespace candela::fuzz
