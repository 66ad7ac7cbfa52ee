#include "tests/structure/source_rules.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace candela::structure {
namespace {

struct Room {
  std::string_view folder;
  int level;
};

// A file includes its own room and rooms of a lower level. Longer names come first.
constexpr std::array rooms = {
    Room{"renderer/base/", 0},
    Room{"renderer/math/", 1},
    Room{"renderer/sampling/", 2},
    Room{"renderer/image/", 2},
    Room{"renderer/geometry/", 3},
    Room{"renderer/texture/", 3},
    Room{"renderer/description/", 2},
    Room{"renderer/bsdf/", 3},
    Room{"renderer/camera/", 3},
    Room{"renderer/film/", 3},
    Room{"renderer/material/", 4},
    Room{"renderer/light/", 4},
    Room{"renderer/medium/", 4},
    Room{"renderer/scene/", 5},
    Room{"renderer/accel/", 6},
    Room{"scene_io/", 3},
    Room{"integrators/", 7},
    Room{"tools/", 8},
    Room{"tests/", 9},
};

// The folders within rooms, likewise; what lies beside them may be seen by all and see all.
constexpr std::array inner_rooms = {
    Room{"scene_io/text/", 0},        Room{"scene_io/mesh/", 1},
    Room{"scene_io/obj/", 2},         Room{"scene_io/ply/", 2},
    Room{"scene_io/lab3/", 3},        Room{"scene_io/pbrt/", 3},
    Room{"integrators/guiding/", 0},  Room{"integrators/ray_bench/", 0},
    Room{"integrators/path/", 1},     Room{"integrators/whitted/", 1},
    Room{"integrators/raster/", 2},   Room{"integrators/ray_limit/", 2},
    Room{"integrators/report/", 2},   Room{"integrators/reuse/", 2},
    Room{"integrators/roulette/", 2},
};

template <std::size_t N>
const Room* room_of(std::string_view path, const std::array<Room, N>& among) {
  const auto found = std::find_if(among.begin(), among.end(),
                                  [&](const Room& room) { return path.starts_with(room.folder); });
  return found == among.end() ? nullptr : &*found;
}

// Beside the levels: the readers see the description and what it is made of, no more; and nobody
// but the tools and the tests sees the readers.
bool may_include(const Room& from, const Room& to) {
  if (from.folder == to.folder) return true;
  if (to.folder == "scene_io/") return from.level >= 8;
  if (from.folder == "scene_io/") return to.folder == "renderer/description/" || to.level < 2;
  return to.level < from.level;
}

struct Library {
  std::string_view prefix;   // of the included name
  std::string_view allowed;  // pattern of the paths that may include it
};

constexpr std::array libraries = {
    Library{"tbb/", R"(renderer/base/parallel\.cpp)"},
    Library{"oneapi/", R"(renderer/base/parallel\.cpp)"},
    Library{"embree", R"(renderer/accel/embree_api\.h)"},
    Library{"glm/", R"(renderer/math/vec\.h)"},
    Library{"OpenImageIO/", R"((renderer|tests)/image/openimageio/[^/]*)"},
    Library{"Imf", R"(renderer/image/formats/((de|en)code_exr\.cpp|exr_slices\.h)|tests/.*\.cpp)"},
    Library{"Iex", R"(renderer/image/formats/((de|en)code_exr\.cpp|exr_slices\.h)|tests/.*\.cpp)"},
    Library{"Imath",
            R"(renderer/image/formats/((de|en)code_exr\.cpp|exr_slices\.h)|tests/.*\.cpp)"},
    Library{"png.h", R"(renderer/image/formats/(de|en)code_png\.cpp)"},
    Library{"jpeglib.h", R"(renderer/image/formats/decode_jpeg\.cpp)"},
    Library{"jerror.h", R"(renderer/image/formats/decode_jpeg\.cpp)"},
    Library{"half.h", R"(tests/.*\.cpp)"},
    Library{"CLI/", R"(tools/candela/[^/]*\.cpp)"},
    Library{"nlohmann/", R"((tools/candela|tests)/.*\.cpp|tests/tools/python_questions\.h)"},
    Library{"yaml-cpp/", R"((scene_io|tests)/.*\.cpp)"},
    Library{"zlib.h", R"((scene_io|tests)/.*\.cpp|renderer/image/formats/(guard|encode)_png\.cpp)"},
    Library{"xxhash.h", R"(.*\.cpp)"},
    Library{"tiny_obj_loader.h", R"(tests/.*\.cpp)"},
    Library{"gtest/", R"(tests/.*)"},
};

constexpr std::size_t longest_file = 400;

std::string sentence(const SourceFile& file, int line, const std::string& what) {
  return file.path + ":" + std::to_string(line) + ": " + what;
}

}  // namespace

std::vector<Include> includes_of(const SourceFile& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> found;
  std::istringstream lines(file.text);
  std::string text;
  for (int line = 1; std::getline(lines, text); ++line) {
    std::smatch match;
    if (std::regex_search(text, match, pattern))
      found.push_back({match[2].str(), line, match[1].str() == "\""});
  }
  return found;
}

std::vector<std::string> upward_includes(const SourceFile& file) {
  std::vector<std::string> wrong;
  const Room* from = room_of(file.path, rooms);
  const Room* inner_from = room_of(file.path, inner_rooms);
  if (from == nullptr) return {sentence(file, 1, "lies in no room that the order of rooms names")};
  for (const Include& include : includes_of(file)) {
    if (!include.is_quoted) continue;
    const Room* to = room_of(include.target, rooms);
    const Room* inner_to = room_of(include.target, inner_rooms);
    if (to == nullptr)
      wrong.push_back(sentence(file, include.line,
                               "\"" + include.target + "\" does not start at the project's root"));
    else if (!may_include(*from, *to) ||
             (inner_from != nullptr && inner_to != nullptr && !may_include(*inner_from, *inner_to)))
      wrong.push_back(sentence(file, include.line,
                               "\"" + include.target + "\" lies above or beside this room"));
  }
  return wrong;
}

std::vector<std::string> misplaced_libraries(const SourceFile& file) {
  std::vector<std::string> wrong;
  for (const Include& include : includes_of(file)) {
    if (include.is_quoted) continue;
    for (const Library& library : libraries) {
      if (!include.target.starts_with(library.prefix)) continue;
      if (!std::regex_match(file.path, std::regex(std::string(library.allowed))))
        wrong.push_back(sentence(
            file, include.line,
            "<" + include.target + "> belongs to " + std::string(library.allowed) + " alone"));
    }
  }
  return wrong;
}

std::vector<std::string> broken_conventions(const SourceFile& file) {
  std::vector<std::string> wrong;
  const bool is_header = file.path.ends_with(".h");
  if (is_header && !file.text.starts_with("//"))
    wrong.push_back(sentence(file, 1, "a header opens with a few lines about what lives in it"));
  if (is_header && file.text.find("\n#pragma once\n") == std::string::npos)
    wrong.push_back(sentence(file, 1, "a header has #pragma once"));
  static const std::regex promise(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X|HA"
      "CK)\\b");
  if (std::regex_search(file.text, promise))
    wrong.push_back(sentence(file, 1, "promises work instead of being done"));
  const auto lines = static_cast<std::size_t>(std::count(file.text.begin(), file.text.end(), '\n'));
  if (lines > longest_file)
    wrong.push_back(sentence(file, static_cast<int>(lines), "has more than 400 lines"));
  return wrong;
}

std::vector<SourceFile> read_sources(const std::string& root) {
  namespace fs = std::filesystem;
  std::vector<SourceFile> files;
  for (const char* top : {"renderer", "scene_io", "integrators", "tools", "tests"}) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(root) / top)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      files.push_back({fs::relative(entry.path(), root).generic_string(),
                       {std::istreambuf_iterator<char>(stream), {}}});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace candela::structure
