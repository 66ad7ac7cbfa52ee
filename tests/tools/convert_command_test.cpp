// `candela convert` through the built program: scenes of all formats come back with the same bits.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "tests/scene_io/shared_scenes.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

namespace fs = std::filesystem;

std::string asset(const std::string& name, const std::string& extension = ".yaml") {
  return fmt::format("{}/assets/{}/{}{}", CANDELA_SOURCE_DIR, name, name, extension);
}

// Small, and of few samples: the random numbers are the same ones.
std::string picture_of(const std::string& scene, const std::string& folder,
                       const std::string& name) {
  const std::string picture = fmt::format("{}/{}.exr", folder, name);
  const ProgramResult rendered =
      run_candela({"render", scene, "-o", picture, "--size", "48x36", "--spp", "2", "-q"});
  EXPECT_EQ(rendered.exit_code, 0) << rendered.error;
  return picture;
}

void expect_same_picture(const std::string& scene, const std::string& name) {
  SCOPED_TRACE(scene);
  const std::string folder = fresh_folder("convert_" + name);
  const std::string converted = folder + "/back.pbrt";
  const ProgramResult result = run_candela({"convert", scene, converted});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const std::string before = picture_of(scene, folder, "before");
  const std::string after = picture_of(converted, folder, "after");
  const ProgramResult compared = run_candela({"compare", after, before, "--max-relmse", "0"});
  EXPECT_EQ(compared.exit_code, 0) << compared.output;
}

class Agreement_ConvertedAsset : public testing::TestWithParam<const char*> {};

TEST_P(Agreement_ConvertedAsset, RendersTheSameBits) {
  const std::string yaml = asset(GetParam());
  expect_same_picture(fs::exists(yaml) ? yaml : asset(GetParam(), ".pbrt"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(, Agreement_ConvertedAsset,
                         testing::Values("cornell_box", "cornell_box_diffuse", "cutouts",
                                         "glass_and_metal", "pbrt_lights", "pbrt_materials",
                                         "pbrt_mixtures", "pbrt_place_textures", "pbrt_shapes",
                                         "pbrt_textured_lights"),
                         [](const auto& info) { return std::string(info.param); });

// Skies of two mappings and a constant, and a film with a balance.
TEST(Agreement_Convert, SeveralSkiesRenderTheSameBits) {
  const std::string folder = fresh_folder("convert_skies_source");
  const std::string map = fmt::format("{}/assets/glass_and_metal/studio.hdr", CANDELA_SOURCE_DIR);
  const std::string square = folder + "/square.exr";
  const std::string scene = folder + "/skies.pbrt";
  write_text(folder + "/sky.pbrt", fmt::format(R"(Camera "spherical"
    Film "rgb" "integer xresolution" 32 "integer yresolution" 32
    WorldBegin
    LightSource "infinite" "string mapname" "{}")",
                                               map));
  ASSERT_EQ(
      run_candela({"render", folder + "/sky.pbrt", "-o", square, "--spp", "1", "-q"}).exit_code, 0);
  write_text(scene, fmt::format(R"(LookAt 0 2 -4  0 0 0  0 1 0
    Camera "perspective" "float fov" 40
    Film "rgb" "float whitebalance" 4000
    WorldBegin
    LightSource "infinite" "string filename" "square.exr" "float scale" .5
    AttributeBegin
      Rotate 30 1 2 3
      LightSource "infinite" "string mapname" "{}"
    AttributeEnd
    LightSource "infinite" "rgb L" [ .1 .2 .3 ]
    Shape "sphere")",
                                map));
  expect_same_picture(scene, "skies");
}

TEST(Agreement_Convert, SharedScenesRenderTheSameBits) {
  if (std::getenv("CANDELA_HEAVY") == nullptr) GTEST_SKIP() << "needs CANDELA_HEAVY";
  if (!shared_scene("lab3")) GTEST_SKIP() << "the shared scenes are not here";
  for (const char* kind : {"lab3", "pbrt"})
    for (const fs::directory_entry& folder : fs::directory_iterator(*shared_scene(kind)))
      for (const fs::directory_entry& file : fs::directory_iterator(folder.path())) {
        const std::string extension = file.path().extension().string();
        if (extension == ".yaml" || extension == ".pbrt")
          expect_same_picture(file.path().string(), folder.path().stem().string());
      }
}

TEST(Unit_Convert, WritesTheSameBytesAgainAndNothingElse) {
  const std::string folder = fresh_folder("convert_again");
  for (const char* name : {"/a.pbrt", "/b/a.pbrt"}) {
    fs::create_directories(folder + "/b");
    const ProgramResult result = run_candela({"convert", asset("glass_and_metal"), folder + name});
    ASSERT_EQ(result.exit_code, 0) << result.error;
    EXPECT_EQ(result.output, "");
  }
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"a.pbrt", "a_files", "b"}));
  const std::vector<std::string> files = file_names(folder + "/a_files");
  EXPECT_EQ(files, file_names(folder + "/b/a_files"));
  EXPECT_GE(files.size(), 7u);
  for (const std::string& file : files)
    EXPECT_TRUE(file_text(folder + "/a_files/" + file) == file_text(folder + "/b/a_files/" + file))
        << file;
  EXPECT_EQ(file_text(folder + "/a.pbrt"), file_text(folder + "/b/a.pbrt"));
}

// The scene names its meshes by where it lies.
TEST(Unit_Convert, WritesBesideWhatALinkLeadsTo) {
  const std::string folder = fresh_folder("convert_link");
  fs::create_directories(folder + "/real");
  fs::create_symlink("real/b.pbrt", folder + "/a.pbrt");
  const ProgramResult result = run_candela({"convert", asset("cornell_box"), folder + "/a.pbrt"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"a.pbrt", "real"}));
  EXPECT_EQ(file_names(folder + "/real"), (std::vector<std::string>{"b.pbrt", "b_files"}));
  EXPECT_EQ(run_candela({"check", folder + "/real/b.pbrt"}).exit_code, 0);
}

TEST(Unit_Convert, NamesWhatIsLostForPbrt) {
  const std::string folder = fresh_folder("convert_lost");
  const ProgramResult result = run_candela({"convert", asset("cornell_box"), folder + "/a.pbrt"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.error.find("cornell_box.yaml:28:5: warning: material 'brushed_steel': lost for "
                              "pbrt: "),
            std::string::npos)
      << result.error;
}

TEST(Errors_Convert, EndWithTheirCodesAndWriteNothing) {
  const std::string folder = fresh_folder("convert_errors");
  const std::string out = folder + "/a.pbrt";
  const auto expect_code = [](const std::vector<std::string>& words, int code,
                              const std::string& sentence) {
    const ProgramResult result = run_candela(words);
    EXPECT_EQ(result.exit_code, code) << result.error;
    EXPECT_NE(result.error.find(sentence), std::string::npos) << result.error;
  };
  expect_code({"convert", small_scene()}, 2, "OUT is missing");
  expect_code({"convert", small_scene(), folder + "/a.yaml"}, 2,
              "expected a name and .pbrt behind it");
  expect_code({"convert", small_scene(), out, "--camera", "3"}, 2, "only camera 0");
  expect_code({"convert", folder + "/none.yaml", out}, 3, "none.yaml");
  expect_code({"convert", asset("cornell_box"), out, "--strict"}, 3, "lost for pbrt");
  expect_code({"convert", small_scene(), folder + "/no/a.pbrt"}, 4, "no");
  EXPECT_EQ(file_names(folder).size(), 0u);
  write_text(folder + "/a_files", "a file where the folder should be");
  expect_code({"convert", small_scene(), out}, 4, "a_files");
  EXPECT_EQ(file_names(folder), std::vector<std::string>{"a_files"});
}

// As candela draws it. The header is whole, so that only decoding finds it.
TEST(Unit_Convert, AnImageThatBreaksOffIsMagenta) {
  const std::string folder = fresh_folder("convert_broken");
  fs::copy(fs::path(asset("cutouts")).parent_path(), folder, fs::copy_options::recursive);
  const std::string scene = folder + "/cutouts.yaml";
  const std::string picture = folder + "/tiles.jpg";  // which becomes a PNG for pbrt
  ASSERT_EQ(
      run_candela({"render", scene, "-o", picture, "--size", "64x64", "--spp", "1"}).exit_code, 0);
  const std::string image = file_text(picture);
  write_text(picture, image.substr(0, image.size() / 2));
  std::string text = file_text(scene);
  text.replace(text.find("tiles.png"), 9, "tiles.jpg");
  write_text(scene, text);
  const std::string converted = folder + "/a.pbrt";
  const auto expect_told = [&](const ProgramResult& result, int code) {
    EXPECT_EQ(result.exit_code, code) << result.error;
    EXPECT_NE(result.error.find("cutouts.yaml:"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("tiles.jpg"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("; it is magenta"), std::string::npos) << result.error;
  };
  expect_told(run_candela({"convert", scene, converted, "--strict"}), 3);
  EXPECT_FALSE(fs::exists(converted));
  EXPECT_FALSE(fs::exists(folder + "/a_files"));
  expect_told(run_candela({"convert", scene, converted}), 0);
  const ProgramResult compared =
      run_candela({"compare", picture_of(converted, folder, "after"),
                   picture_of(scene, folder, "before"), "--max-relmse", "0"});
  EXPECT_EQ(compared.exit_code, 0) << compared.output;
}

TEST(Errors_Convert, SparesTheSceneItReads) {
  const std::string folder = fresh_folder("convert_spares");
  const std::string scene = folder + "/a.pbrt";
  ASSERT_EQ(run_candela({"convert", asset("cutouts"), scene}).exit_code, 0);
  const std::string before = file_text(scene);
  const ProgramResult result = run_candela({"convert", scene, scene});
  EXPECT_EQ(result.exit_code, 4) << result.error;
  EXPECT_NE(result.error.find("would be overwritten"), std::string::npos) << result.error;
  EXPECT_EQ(file_text(scene), before);
}

}  // namespace
}  // namespace candela::cli_test
