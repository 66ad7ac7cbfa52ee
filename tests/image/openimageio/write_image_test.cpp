// What is written can be read again, with the same numbers as far as the format goes.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/image/encode.h"
#include "renderer/image/image_io.h"
#include "renderer/sampling/hash.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

std::string first_message(const Diagnostics& diagnostics) {
  return diagnostics.list().empty() ? "" : diagnostics.list().front().message;
}

float test_value(int x, int y, std::size_t c) {
  return std::exp2(static_cast<float>(x - 4)) * (0.3f + 0.1f * static_cast<float>(y)) +
         static_cast<float>(c) * 0.125f;
}

Image test_image(int width, int height, const std::vector<std::string>& channels) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < channels.size(); ++c)
        image.pixel(x, y)[c] = channels[c] == "A" ? 0.75f : test_value(x, y, c);
  return image;
}

Image written_and_read(const TemporaryFolder& folder, const std::string& name, const Image& image,
                       const WriteOptions& options = {}) {
  const Diagnostics found = write_image(folder.file(name), image, options);
  EXPECT_EQ(first_message(found), "");
  Result<Image> result = read_image(folder.file(name));
  EXPECT_EQ(first_message(result.diagnostics), "");
  return result ? *result : Image{};
}

TEST(Unit_WriteImage, ExrKeepsEveryChannelExactly) {
  const TemporaryFolder folder;
  const Image image = test_image(
      9, 5, {"R", "G", "B", "A", "albedo.R", "albedo.G", "albedo.B", "normal.X", "depth.Z"});
  const Image back = written_and_read(folder, "x.exr", image);
  ASSERT_EQ(back.pixel_count(), image.pixel_count());
  ASSERT_EQ(back.channel_count(), image.channel_count());
  for (std::size_t c = 0; c < image.channel_count(); ++c) {
    const int found = back.channel_index(image.channels[c]);
    ASSERT_GE(found, 0) << image.channels[c];
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        EXPECT_EQ(back.pixel(x, y)[found], image.pixel(x, y)[c]);
  }
}

TEST(Unit_WriteImage, ExrKeepsMetadataAndTheWindowOfACrop) {
  const TemporaryFolder folder;
  WriteOptions options;
  options.offset_x = 3;
  options.offset_y = 7;
  options.full_width = 64;
  options.full_height = 32;
  options.metadata = {{"candela:version", std::string("0.1.0 \"quoted\"\n")},
                      {"candela:error", 0.1},
                      {"candela:spp", std::int64_t{64}},
                      {"candela:seed", std::int64_t{1} << 60}};
  ASSERT_FALSE(
      write_image(folder.file("x.exr"), test_image(9, 5, {"R", "G", "B"}), options).has_errors());
  const auto input = OIIO::ImageInput::open(folder.file("x.exr"));
  ASSERT_TRUE(input);
  const OIIO::ImageSpec& spec = input->spec();
  EXPECT_EQ(spec.x, 3);
  EXPECT_EQ(spec.y, 7);
  EXPECT_EQ(spec.full_x, 0);
  EXPECT_EQ(spec.full_width, 64);
  EXPECT_EQ(spec.full_height, 32);
  EXPECT_EQ(spec.get_string_attribute("candela:version"), "0.1.0 \"quoted\"\n");
  EXPECT_EQ(spec.get_int_attribute("candela:spp"), 64);
  EXPECT_EQ(spec.get_string_attribute("candela:seed"), "1152921504606846976");
  const auto* error = spec.find_attribute("candela:error");
  ASSERT_NE(error, nullptr);
  ASSERT_EQ(error->type(), OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE));
  EXPECT_EQ(*static_cast<const double*>(error->data()), 0.1);
}

TEST(Unit_WriteImage, TiffKeepsColourAndAlphaExactly) {
  const TemporaryFolder folder;
  const Image image = test_image(9, 5, {"R", "G", "B", "A", "depth.Z"});
  const Image back = written_and_read(folder, "x.tiff", image);
  ASSERT_EQ(back.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(back.pixel(x, y)[c], image.pixel(x, y)[c]);
}

// RGBE shares an exponent: half a step of 1/256 to 1/128 of the largest channel, as often up as
// down.
TEST(Unit_WriteImage, HdrKeepsColourToASharedExponent) {
  const TemporaryFolder folder;
  Image image = test_image(9, 5, {"R", "G", "B", "A"});
  image.pixel(0, 0)[0] = -1;
  image.pixel(0, 0)[1] = std::numeric_limits<float>::quiet_NaN();
  image.pixel(0, 0)[2] = 0;
  const Image back = written_and_read(folder, "x.hdr", image);
  ASSERT_EQ(back.channels, (std::vector<std::string>{"R", "G", "B"}));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(back.pixel(0, 0)[c], 0);
  for (int x = 1; x < image.width; ++x) {
    const float* p = image.pixel(x, 3);
    const float largest = std::max({p[0], p[1], p[2]});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back.pixel(x, 3)[c], p[c], largest / 256);
  }
}

TEST(Unit_WriteImage, HdrIsNeitherTooDarkNorTooBright) {
  const TemporaryFolder folder;
  Image image(64, 64, {"R", "G", "B"});
  const auto uniform = [](std::size_t i) {
    return unit_float(static_cast<std::uint32_t>(mix_bits(i + 1)));
  };
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = uniform(i) * std::exp(10 * uniform(~(i / 3)) - 5);
  image.pixel(0, 0)[0] = 0.99999f;  // the next exponent
  const Image back = written_and_read(folder, "x.hdr", image);
  double sum = 0;
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    const float largest = std::max({image.values[i], image.values[i + 1], image.values[i + 2]});
    for (std::size_t c = i; c < i + 3; ++c) {
      EXPECT_LE(std::abs(back.values[c] - image.values[c]), largest / 255.9f);
      sum += double{(back.values[c] - image.values[c]) / largest};
    }
  }
  // Uniform between half a step of at most 1/128 down and up.
  const auto count = static_cast<double>(image.values.size());
  EXPECT_LT(std::abs(sum), 3 * std::sqrt(count / 12) / 128);
}

TEST(Unit_WriteImage, PngKeepsDisplayedColourToHalfAStep) {
  const TemporaryFolder folder;
  Image image(256, 1, {"R", "G", "B"});
  for (int x = 0; x < 256; ++x)
    for (std::size_t c = 0; c < 3; ++c) image.pixel(x, 0)[c] = static_cast<float>(x) / 255.0f;
  const Image back = written_and_read(folder, "x.png", image);
  ASSERT_EQ(back.width, 256);
  const auto encoded = [](double v) {
    return v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  };
  for (int x = 0; x < 256; ++x)
    EXPECT_NEAR(encoded(back.pixel(x, 0)[1]), encoded(image.pixel(x, 0)[1]), 0.501 / 255);
}

// Premultiplied in memory, straight in the file.
TEST(Unit_WriteImage, PngAlphaIsStraight) {
  const TemporaryFolder folder;
  Image image(1, 1, {"R", "G", "B", "A"});
  image.values = {0.25f, 0.5f, 0.125f, 0.5f};
  ASSERT_FALSE(write_image(folder.file("x.png"), image, {}).has_errors());
  const auto input = OIIO::ImageInput::open(folder.file("x.png"));
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  const auto raw = OIIO::ImageInput::open(folder.file("x.png"), &hints);
  ASSERT_TRUE(raw);
  unsigned char pixel[4];
  ASSERT_TRUE(raw->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, pixel));
  EXPECT_EQ(pixel[0], 188);  // sRGB of 0.5
  EXPECT_EQ(pixel[1], 255);
  EXPECT_EQ(pixel[2], 137);  // sRGB of 0.25
  EXPECT_EQ(pixel[3], 128);
  const Result<Image> back = read_image(folder.file("x.png"));
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->pixel(0, 0)[0], 0.25, 0.004);
  EXPECT_NEAR(back->pixel(0, 0)[1], 0.5, 0.004);
}

TEST(Unit_WriteImage, JpegDropsAlphaAndLayers) {
  const TemporaryFolder folder;
  Image image(16, 16, {"R", "G", "B", "A", "normal.X"});
  for (std::size_t i = 0; i < image.pixel_count(); ++i) {
    float* p = image.values.data() + 5 * i;
    p[0] = 0.8f, p[1] = 0.2f, p[2] = 0.1f, p[3] = 0.5f, p[4] = -1;
  }
  for (const char* name : {"x.jpg", "x.JPEG"}) {
    const Image back = written_and_read(folder, name, image);
    ASSERT_EQ(back.channels, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_NEAR(back.pixel(8, 8)[0], 0.8, 0.03);
    EXPECT_NEAR(back.pixel(8, 8)[1], 0.2, 0.02);
  }
}

TEST(Unit_WriteImage, GreyChannelsFillTheColour) {
  const TemporaryFolder folder;
  Image image(2, 1, {"Y"});
  image.values = {1, 0};
  const Image back = written_and_read(folder, "x.png", image);
  EXPECT_EQ(back.values, (std::vector<float>{1, 1, 1, 0, 0, 0}));
}

TEST(Unit_WriteImage, TheSamePictureGivesTheSameBytes) {
  const TemporaryFolder folder;
  const Image image = test_image(40, 30, {"R", "G", "B", "A"});
  WriteOptions options;  // some formats note the time of day where none is given
  options.metadata = {{"DateTime", std::string("2000:01:01 00:00:00")}};
  for (const char* name : {"x.exr", "x.png", "x.jpg", "x.hdr", "x.tif"}) {
    ASSERT_EQ(first_message(write_image(folder.file(name), image, options)), "");
    const std::string first = contents_of(folder.file(name));
    ASSERT_FALSE(write_image(folder.file(name), image, options).has_errors());
    EXPECT_EQ(contents_of(folder.file(name)), first) << name;
  }
}

TEST(Unit_WriteImage, AGivenTimeOfDayStandsForThePresentOne) {
  const TemporaryFolder folder;
  const std::string given = "2000:01:01 00:00:00";
  WriteOptions options;
  options.metadata = {{"DateTime", given}};
  for (const char* name : {"x.exr", "x.png", "x.tif"}) {
    ASSERT_FALSE(
        write_image(folder.file(name), test_image(4, 3, {"R", "G", "B"}), options).has_errors());
    const auto input = OIIO::ImageInput::open(folder.file(name));
    ASSERT_TRUE(input) << name;
    EXPECT_EQ(input->spec().get_string_attribute("DateTime"), given) << name;
  }
}

TEST(Errors_WriteImage, SaysWhichExtensionsThereAre) {
  const TemporaryFolder folder;
  const Image image = test_image(2, 2, {"R", "G", "B"});
  for (const char* name : {"x.gif", "x.bmp", "x", "x.", ".png/x"}) {
    const std::string message = first_message(write_image(folder.file(name), image, {}));
    EXPECT_NE(message.find("expected one of .exr .png"), std::string::npos) << name << message;
    EXPECT_TRUE(check_writable_image(folder.file(name)).has_errors());
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Errors_WriteImage, RefusesWhatAFormatCannotHold) {
  const TemporaryFolder folder;
  const Image wide(70000, 1, {"R", "G", "B"});
  const std::string message = first_message(write_image(folder.file("x.jpg"), wide, {}));
  EXPECT_NE(message.find("at most 65500 pixels"), std::string::npos) << message;
  EXPECT_TRUE(write_image(folder.file("x.png"), Image{}, {}).has_errors());
  Image broken(4, 4, {"R"});
  broken.values.resize(3);
  EXPECT_TRUE(write_image(folder.file("x.exr"), broken, {}).has_errors());
  const Image twice(2, 2, {"R", "G", "R"});
  EXPECT_NE(first_message(write_image(folder.file("x.exr"), twice, {})).find("two channels 'R'"),
            std::string::npos);
  EXPECT_TRUE(write_image(folder.file("x.exr"), Image(2, 2, {"R", ""}), {}).has_errors());
  WriteOptions options;
  options.metadata = {{"compression", std::string("none")}};
  EXPECT_NE(first_message(write_image(folder.file("x.exr"), Image(2, 2, {"R"}), options))
                .find("cannot be written: exr encoder: "),
            std::string::npos);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Errors_WriteImage, ANaNIsBlackOnADisplay) {
  const TemporaryFolder folder;
  Image image(3, 1, {"R", "G", "B"});
  image.values = {NAN, -1, INFINITY, 0, 0, 0, 1, 1, 1};
  for (const ToneMap map : {ToneMap::Srgb, ToneMap::Aces, ToneMap::Lab3}) {
    const Image back = written_and_read(folder, "x.png", image, {{map, 0}, {}, 0, 0, 0, 0});
    EXPECT_EQ(back.pixel(0, 0)[0], 0);
    EXPECT_EQ(back.pixel(0, 0)[1], 0);
    EXPECT_EQ(back.pixel(0, 0)[2], 1);
  }
}

}  // namespace
}  // namespace candela
