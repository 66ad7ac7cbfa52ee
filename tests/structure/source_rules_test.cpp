// The sources keep to the design: dependencies point one way, each library has one door.
#include "tests/structure/source_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace candela::structure {
namespace {

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> files = read_sources(CANDELA_SOURCE_DIR);
  return files;
}

template <class Rule>
void expect_all_keep(const Rule& rule) {
  ASSERT_GT(sources().size(), 50u);
  for (const SourceFile& file : sources())
    for (const std::string& wrong : rule(file)) ADD_FAILURE() << wrong;
}

std::vector<std::string> paths_including(std::string_view prefix, std::string_view below) {
  std::vector<std::string> paths;
  for (const SourceFile& file : sources()) {
    if (!file.path.starts_with(below)) continue;
    const std::vector<Include> includes = includes_of(file);
    if (std::any_of(includes.begin(), includes.end(),
                    [&](const Include& i) { return i.target.starts_with(prefix); }))
      paths.push_back(file.path);
  }
  return paths;
}

TEST(Unit_Structure, NoIncludePointsUpward) {
  expect_all_keep(upward_includes);
}

TEST(Unit_Structure, QuotedIncludesExist) {
  for (const SourceFile& file : sources())
    for (const Include& include : includes_of(file))
      if (include.is_quoted) {
        EXPECT_TRUE(std::filesystem::exists(std::string(CANDELA_SOURCE_DIR) + "/" + include.target))
            << file.path << ":" << include.line << ": " << include.target;
      }
}

TEST(Unit_Structure, EveryLibraryIsIncludedInItsPlaceOnly) {
  expect_all_keep(misplaced_libraries);
}

TEST(Unit_Structure, TheHeaviestLibrariesAreIncludedOnce) {
  EXPECT_EQ(paths_including("CLI/", "").size(), 1u);
  EXPECT_EQ(paths_including("nlohmann/", "tools/").size(), 1u);
}

TEST(Unit_Structure, FilesKeepTheConventions) {
  expect_all_keep(broken_conventions);
}

// Loops over lanes become vectors only by options of their own.
TEST(Unit_Structure, FilesWithLanesAreCompiledForThem) {
  std::ifstream stream(std::string(CANDELA_SOURCE_DIR) + "/cmake/CompilerOptions.cmake");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t first = text.find("integrators/path/block_lanes.cpp");
  const std::string options = ' ' + text.substr(first, text.find("PROPERTIES", first) - first);
  int with_lanes = 0;
  for (const SourceFile& file : sources()) {
    if (!file.path.ends_with(".cpp") || file.text.find("\nCANDELA_LANES ") == std::string::npos)
      continue;
    ++with_lanes;
    EXPECT_NE(options.find(' ' + file.path), std::string::npos)
        << file.path << " is not named in cmake/CompilerOptions.cmake";
  }
  EXPECT_GT(with_lanes, 10);
}

// The rules themselves: what they must refuse and what they must let pass.

TEST(Unit_Structure, RulesRefuseUpwardAndSidewaysIncludes) {
  const auto refused = [](const char* path, const char* target) {
    return !upward_includes({path, "\n#include \"" + std::string(target) + "\"\n"}).empty();
  };
  EXPECT_TRUE(refused("renderer/math/ray.h", "renderer/geometry/geometry.h"));
  EXPECT_TRUE(refused("renderer/bsdf/ggx.h", "renderer/camera/camera.h"));
  EXPECT_TRUE(refused("renderer/scene/compile.cpp", "scene_io/load.h"));
  EXPECT_TRUE(refused("scene_io/load.cpp", "renderer/scene/compile.h"));
  EXPECT_TRUE(refused("integrators/render.cpp", "tools/candela/commands.h"));
  EXPECT_TRUE(refused("integrators/render.cpp", "scene_io/load.h"));
  EXPECT_TRUE(refused("integrators/guiding/training.cpp", "integrators/path/kernels.h"));
  EXPECT_TRUE(refused("integrators/reuse/choose_reuse.h", "integrators/roulette/walk.h"));
  EXPECT_TRUE(refused("scene_io/text/file.cpp", "scene_io/mesh/add_mesh.h"));
  EXPECT_TRUE(refused("scene_io/obj/read_obj.cpp", "scene_io/ply/read_ply.h"));
  EXPECT_TRUE(refused("scene_io/pbrt/lights.cpp", "scene_io/lab3/read_lab3.h"));
  EXPECT_TRUE(refused("renderer/math/ray.h", "vec.h"));
  EXPECT_TRUE(refused("renderer/math/ray.h", "../math/vec.h"));
  EXPECT_FALSE(refused("renderer/math/ray.h", "renderer/math/vec.h"));
  EXPECT_FALSE(refused("renderer/scene/scene.h", "renderer/light/light.h"));
  EXPECT_FALSE(refused("scene_io/load.cpp", "renderer/description/scene_description.h"));
  EXPECT_FALSE(refused("integrators/path/guide.h", "integrators/guiding/guiding_field.h"));
  EXPECT_FALSE(refused("integrators/path/context.h", "integrators/render_options.h"));
  EXPECT_FALSE(refused("integrators/render.cpp", "integrators/path/kernels.h"));
  EXPECT_FALSE(refused("scene_io/pbrt/lights.cpp", "scene_io/ply/read_ply.h"));
  EXPECT_FALSE(refused("tools/candela/main.cpp", "scene_io/load.h"));
}

TEST(Unit_Structure, RulesRefuseLibrariesOutsideTheirDoor) {
  const auto refused = [](const char* path, const char* target) {
    return !misplaced_libraries({path, "#include <" + std::string(target) + ">\n"}).empty();
  };
  EXPECT_TRUE(refused("renderer/film/film.cpp", "tbb/parallel_for.h"));
  EXPECT_TRUE(refused("integrators/path.cpp", "embree3/rtcore.h"));
  EXPECT_TRUE(refused("renderer/math/frame.h", "glm/glm.hpp"));
  EXPECT_TRUE(refused("renderer/image/decode.cpp", "OpenImageIO/imageio.h"));
  EXPECT_TRUE(refused("tests/image/read_image_test.cpp", "OpenImageIO/imageio.h"));
  EXPECT_FALSE(refused("renderer/base/parallel.cpp", "tbb/parallel_for.h"));
  EXPECT_TRUE(refused("renderer/accel/embree_accel.cpp", "embree4/rtcore.h"));
  EXPECT_FALSE(refused("renderer/accel/embree_api.h", "embree4/rtcore.h"));
  EXPECT_TRUE(refused("renderer/image/decode.cpp", "ImfInputFile.h"));
  EXPECT_TRUE(refused("renderer/image/decode.cpp", "png.h"));
  EXPECT_FALSE(refused("renderer/image/formats/encode_exr.cpp", "ImfHeader.h"));
  EXPECT_FALSE(refused("renderer/image/formats/decode_png.cpp", "png.h"));
  EXPECT_FALSE(refused("renderer/image/openimageio/decode_file.cpp", "OpenImageIO/imageio.h"));
  EXPECT_FALSE(refused("renderer/film/film.cpp", "vector"));
}

TEST(Unit_Structure, RulesRefuseBrokenConventions) {
  const auto refused = [](const char* path, const std::string& text) {
    return !broken_conventions({path, text}).empty();
  };
  EXPECT_TRUE(refused("renderer/math/a.h", "#pragma once\n"));
  EXPECT_TRUE(refused("renderer/math/a.h", "// what\n"));
  EXPECT_TRUE(refused("renderer/math/a.cpp",
                      "// TO"
                      "DO later\n"));
  EXPECT_TRUE(refused("renderer/math/a.cpp", std::string(401, '\n')));
  EXPECT_FALSE(refused("renderer/math/a.cpp", std::string(400, '\n')));
  EXPECT_FALSE(refused("renderer/math/a.h", "// what\n#pragma once\n"));
}

}  // namespace
}  // namespace candela::structure
