// `candela render` end to end on small pictures.
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "renderer/image/compare.h"
#include "renderer/image/decode.h"
#include "renderer/image/display_transform.h"
#include "renderer/image/image_io.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

Image image_at(const std::string& path) {
  Result<Image> image = read_image(path);
  EXPECT_TRUE(image) << path;
  return image ? std::move(*image) : Image{};
}

Image rendered_of(const std::string& scene, const std::string& path,
                  const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"render", scene,   "-q",    "-o", path,
                                     "--size", "20x14", "--spp", "2"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = run_candela(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return image_at(path);
}

Image rendered(const std::string& path, const std::vector<std::string>& more) {
  return rendered_of(small_scene(), path, more);
}

bool are_same_bits(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels &&
         std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

TEST(Unit_RenderCommand, TheSameSeedGivesTheSameBitsForAnyThreads) {
  const std::string folder = fresh_folder("seed");
  const Image first = rendered(folder + "/a.exr", {"--seed", "5", "-t", "1"});
  const Image again = rendered(folder + "/b.exr", {"--seed", "5", "-t", "3"});
  const Image other = rendered(folder + "/c.exr", {"--seed", "6"});
  EXPECT_TRUE(are_same_bits(first, again));
  EXPECT_FALSE(are_same_bits(first, other));
}

TEST(Unit_RenderCommand, ACropHasThePixelsOfTheWhole) {
  const std::string folder = fresh_folder("crop");
  const Image whole = rendered(folder + "/whole.exr", {});
  const Image crop = rendered(folder + "/crop.exr", {"--crop", "3,5,17,11"});
  ASSERT_EQ(crop.width, 14);
  ASSERT_EQ(crop.height, 6);
  for (int y = 0; y < crop.height; ++y)
    EXPECT_EQ(std::memcmp(crop.pixel(0, y), whole.pixel(3, y + 5), 14 * 3 * sizeof(float)), 0) << y;
  const Imf::InputFile file((folder + "/crop.exr").c_str());
  EXPECT_TRUE(file.isComplete());
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({3, 5}, {16, 10}));
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {19, 13}));
}

// By what the system's loader says that it looks for.
TEST(Unit_RenderCommand, LoadsOpenImageIOOnlyForWhatItAloneWrites) {
  const std::string folder = fresh_folder("codecs");
  const auto loads = [&](const std::string& output) {
    const ProgramResult result =
        Program({"/bin/sh", "-c",
                 R"(LD_DEBUG=libs exec "$0" render "$1" -q -o "$2" --size 2x2 --spp 1)",
                 CANDELA_PROGRAM, small_scene(), folder + output},
                ErrorStream::File)
            .finish();
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_NE(result.error.find("find library=libembree"), std::string::npos) << result.error;
    EXPECT_FALSE(std::regex_search(result.error, std::regex("trying file=[^/]")))
        << "looks for libraries in the working folder";
    return result.error.find("find library=libOpenImageIO") != std::string::npos;
  };
  EXPECT_FALSE(loads("/a.exr"));
  EXPECT_FALSE(loads("/a.png"));
  EXPECT_TRUE(loads("/a.hdr"));
}

TEST(Unit_RenderCommand, WritesSeveralOutputsAtOnce) {
  const std::string folder = fresh_folder("several");
  rendered(folder + "/a.exr", {"-o", folder + "/a.png", "-o", folder + "/a.hdr"});
  EXPECT_EQ(file_names(folder), (std::vector<std::string>{"a.exr", "a.hdr", "a.png"}));
  for (const char* name : {"/a.exr", "/a.png", "/a.hdr"}) {
    const Image image = image_at(folder + name);
    EXPECT_EQ(image.width, 20);
    EXPECT_EQ(image.height, 14);
  }
}

TEST(Unit_RenderCommand, ADefaultOutputIsNamedAfterTheScene) {
  const std::string folder = fresh_folder("default_output");
  const ProgramResult result =
      Program({"/bin/sh", "-c", "cd \"$1\" && exec \"$0\" render \"$2\" --size 2x2 --spp 1",
               CANDELA_PROGRAM, folder, small_scene()},
              ErrorStream::File)
          .finish();
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(file_names(folder), std::vector<std::string>{"cornell_box_diffuse.exr"});
}

TEST(Unit_RenderCommand, LayersAreInTheExr) {
  const Image image = rendered(fresh_folder("layers") + "/a.exr",
                               {"--aov", "albedo,normal,depth,position,material_id,samples"});
  for (const char* name :
       {"R", "G", "B", "albedo.R", "albedo.G", "albedo.B", "normal.X", "normal.Y", "normal.Z",
        "depth.Z", "position.X", "position.Y", "position.Z", "material_id.V", "samples.V"})
    EXPECT_GE(image.channel_index(name), 0) << name;
  EXPECT_EQ(image.pixel(10, 7)[image.channel_index("samples.V")], 2);
}

TEST(Unit_RenderCommand, LayersWithoutAnExrAreWarnedOf) {
  const std::string path = fresh_folder("layers_png") + "/a.png";
  const ProgramResult result = run_candela(
      {"render", small_scene(), "-q", "-o", path, "--size", "4x4", "--spp", "1", "--aov", "depth"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.error.find("warning: --aov: only an EXR"), std::string::npos) << result.error;
}

// A white square, which takes the middle of the picture, before a bright sky.
constexpr const char* square_before_a_sky = R"(
LookAt 0 0 4  0 0 0  0 1 0
Camera "perspective" "float fov" 60
Film "rgb" "integer xresolution" 20 "integer yresolution" 14
WorldBegin
LightSource "infinite" "rgb L" [5 5 5]
Material "diffuse" "rgb reflectance" [.5 .5 .5]
Shape "bilinearmesh" "point3 P" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]
)";

TEST(Unit_RenderCommand, TransparencyIsAlpha) {
  const std::string folder = fresh_folder("alpha");
  write_text(folder + "/sky.pbrt", square_before_a_sky);
  const auto picture = [&](const std::vector<std::string>& more) {
    return rendered_of(folder + "/sky.pbrt", folder + "/a.exr", more);
  };
  EXPECT_EQ(picture({}).channel_index("A"), -1);
  EXPECT_NEAR(picture({}).pixel(0, 0)[0], 5, 1e-5);
  const Image image = picture({"--transparent"});
  ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  for (int c = 0; c < 4; ++c) EXPECT_EQ(image.pixel(0, 0)[c], 0) << c;
  EXPECT_EQ(image.pixel(10, 7)[3], 1);
  EXPECT_GT(image.pixel(10, 7)[0], 0);
  int partial = 0;
  for (int x = 0; x < image.width; ++x)
    if (const float alpha = image.pixel(x, 7)[3]; alpha > 0 && alpha < 1) ++partial;
  EXPECT_GT(partial, 0) << "no edge";
}

TEST(Unit_RenderCommand, TransparencyThatNoOutputHoldsIsWarnedOf) {
  const std::string folder = fresh_folder("no_alpha");
  write_text(folder + "/sky.pbrt", square_before_a_sky);
  const auto messages = [&](const char* also) {
    return run_candela({"render", folder + "/sky.pbrt", "--size", "4x4", "--spp", "1",
                        "--transparent", "-q", "-o", folder + "/a.jpg", "-o", folder + also})
        .error;
  };
  EXPECT_NE(messages("/a.hdr").find("--transparent: no output can hold alpha"), std::string::npos);
  EXPECT_EQ(messages("/a.png").find("--transparent"), std::string::npos);
}

TEST(Unit_RenderCommand, ExposureAndToneMapReachTheBytes) {
  const std::string folder = fresh_folder("display");
  const Image linear = rendered(
      folder + "/a.exr", {"-o", folder + "/a.png", "--exposure", "-1.5", "--tonemap", "aces"});
  const std::string file = file_text(folder + "/a.png");
  const Result<DecodedImage> shown = decode_image("a.png", Bytes(file.begin(), file.end()), {});
  ASSERT_TRUE(shown);
  ASSERT_EQ(shown->header.sample_type, SampleType::U8);
  const auto* bytes = reinterpret_cast<const unsigned char*>(shown->samples.get());
  const std::vector<std::uint8_t> expected = display_bytes(linear, {ToneMap::Aces, -1.5}, true);
  ASSERT_EQ(shown->header.sample_count(), expected.size());
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), bytes));
  EXPECT_NE(expected, display_bytes(linear, {ToneMap::Srgb, -1.5}, true));
  EXPECT_NE(expected, display_bytes(linear, {ToneMap::Aces, 0}, true));
}

TEST(Unit_RenderCommand, QuietIsSilent) {
  const std::string path = fresh_folder("quiet") + "/a.exr";
  const ProgramResult result =
      run_candela({"render", small_scene(), "--quiet", "-o", path, "--size", "4x4", "--spp", "1"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.error, "");
}

TEST(Unit_RenderCommand, ElsewhereThanOnATerminalThereAreOnlyLines) {
  const std::string path = fresh_folder("lines") + "/a.exr";
  const ProgramResult result =
      run_candela({"render", small_scene(), "-o", path, "--size", "4x4", "--spp", "1"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.error.find_first_of("\r\x1b"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("\n100 %"), std::string::npos) << result.error;
  EXPECT_EQ(result.error.back(), '\n');
}

TEST(Unit_RenderCommand, OnATerminalThereIsABar) {
  const std::string path = fresh_folder("bar") + "/a.exr";
  const ProgramResult result =
      run_candela({"render", small_scene(), "-o", path, "--size", "100x100", "--spp", "64"},
                  ErrorStream::Terminal);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.error.find("\r\x1b[K["), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("Msamples/s"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("\r\x1b[K100 %"), std::string::npos) << result.error;
}

// The same paths; that another accelerator met them shows in the last bits.
TEST(Unit_RenderCommand, AllAcceleratorsRenderTheSamePicture) {
  const std::string folder = fresh_folder("accel");
  const Image faces = rendered(folder + "/auto.exr", {});
  const Image embree = rendered(folder + "/embree.exr", {"--accel", "embree"});
  const Image bvh = rendered(folder + "/bvh.exr", {"--accel", "bvh"});
  for (const Image* other : {&faces, &bvh}) {
    EXPECT_FALSE(are_same_bits(*other, embree));
    const Result<ImageComparison> comparison = compare_images(*other, embree);
    ASSERT_TRUE(comparison);
    EXPECT_LT(comparison->relmse_trimmed, 1e-3);
    EXPECT_NEAR(comparison->mean_ratio[1], 1, 1e-2);
  }
}

TEST(Unit_RenderCommand, TheGeneralKernelGivesTheSameBits) {
  const std::string folder = fresh_folder("kernel");
  const auto kernel_of = [&](const std::string& name) {
    return nlohmann::json::parse(file_text(folder + "/" + name + ".json"))["kernel"]
        .get<std::string>();
  };
  const Image special = rendered(folder + "/special.exr", {"--stats", folder + "/special.json"});
  const Image general = rendered(folder + "/general.exr",
                                 {"--kernel", "general", "--stats", folder + "/general.json"});
  EXPECT_EQ(kernel_of("special"), "path/lanes");
  EXPECT_EQ(kernel_of("general"), "path/general");
  EXPECT_TRUE(are_same_bits(special, general));
}

}  // namespace
}  // namespace candela::cli_test
