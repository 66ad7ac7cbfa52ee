// Every kind of file that is read gives the numbers that were put into it.
#include <gtest/gtest.h>

#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>

#include <cmath>
#include <cstring>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/decode.h"
#include "renderer/image/half.h"
#include "renderer/image/image_io.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using crafted::operator+;

std::string message_of(const Diagnostics& diagnostics) {
  return diagnostics.list().empty() ? "" : diagnostics.list().front().message;
}

DecodedImage decoded(const std::string& name, const crafted::Bytes& bytes) {
  Result<DecodedImage> image = decode_image(name, bytes, {});
  EXPECT_TRUE(image) << message_of(image.diagnostics);
  return image ? std::move(*image) : DecodedImage{};
}

std::vector<unsigned> bytes_of(const DecodedImage& image) {
  std::vector<unsigned> values;
  for (std::size_t i = 0; i < image.header.sample_count(); ++i)
    values.push_back(std::to_integer<unsigned>(image.samples[i]));
  return values;
}

double linear_of(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

TEST(Unit_ReadImage, EightBitsAreDecodedFromSrgbAndAlphaIsNot) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.png", crafted::png_rgba(2, 1, [](int x, int, int c) {
                                        return c == 3 ? (x == 0 ? 255u : 51u) : 100u + 20 * c;
                                      }));
  const Result<Image> image = read_image(path);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  for (int c = 0; c < 3; ++c) {
    const double straight = linear_of((100 + 20 * c) / 255.0);
    EXPECT_NEAR(image->pixel(0, 0)[c], straight, 1e-7);
    EXPECT_NEAR(image->pixel(1, 0)[c], straight * 0.2, 1e-7);  // premultiplied in memory
  }
  EXPECT_EQ(image->pixel(1, 0)[3], 0.2f);
}

TEST(Unit_ReadImage, SixteenBitsKeepAllOfThem) {
  const TemporaryFolder folder;
  const std::string path =
      folder.put("x.png", crafted::png_of(3, 1, crafted::Grey, 16, [](int x, int, int) {
                   return x == 0 ? 1u : x == 1 ? 30001u : 65535u;
                 }));
  const Result<Image> image = read_image(path);
  ASSERT_TRUE(image);
  ASSERT_EQ(image->channel_count(), 1u);
  EXPECT_NEAR(image->values[0], linear_of(1 / 65535.0), 1e-12);
  EXPECT_NEAR(image->values[1], linear_of(30001 / 65535.0), 1e-7);
  EXPECT_EQ(image->values[2], 1.0f);
}

TEST(Unit_ReadImage, PalettesAndSingleBitsBecomeColours) {
  crafted::Png palette;
  palette.width = 4;
  palette.bit_depth = 2;
  palette.colour = crafted::Palette;
  palette.samples = {0b00011011};
  palette.palette = {1, 2, 3, 10, 20, 30, 100, 101, 102, 255, 254, 253};
  EXPECT_EQ(bytes_of(decoded("x.png", crafted::png(palette))),
            (std::vector<unsigned>{1, 2, 3, 10, 20, 30, 100, 101, 102, 255, 254, 253}));
  palette.transparency = {255, 0, 128};
  EXPECT_EQ(
      bytes_of(decoded("x.png", crafted::png(palette))),
      (std::vector<unsigned>{1, 2, 3, 255, 10, 20, 30, 0, 100, 101, 102, 128, 255, 254, 253, 255}));
  crafted::Png bits;
  bits.width = 8;
  bits.bit_depth = 1;
  bits.colour = crafted::Grey;
  bits.samples = {0b10100011};
  EXPECT_EQ(bytes_of(decoded("x.png", crafted::png(bits))),
            (std::vector<unsigned>{255, 0, 255, 0, 0, 0, 255, 255}));
}

TEST(Unit_ReadImage, TgaInAllItsKinds) {
  const crafted::Bytes two_pixels{3, 2, 1, 6, 5, 4};  // blue first
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({2, 2, 1, 24, 0, 0, 0, two_pixels}))),
            (std::vector<unsigned>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({2, 1, 2, 24, 0, 0, 0, two_pixels}))),
            (std::vector<unsigned>{4, 5, 6, 1, 2, 3}));  // bottom row first
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({2, 1, 2, 24, 0x20, 0, 0, two_pixels}))),
            (std::vector<unsigned>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({2, 2, 1, 24, 0x10, 0, 0, two_pixels}))),
            (std::vector<unsigned>{4, 5, 6, 1, 2, 3}));  // from the right
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({2, 1, 1, 32, 8, 0, 0, {3, 2, 1, 9}}))),
            (std::vector<unsigned>{1, 2, 3, 9}));
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({2, 1, 1, 16, 0, 0, 0, {0x1F, 0x7C}}))),
            (std::vector<unsigned>{255, 0, 255}));
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({3, 3, 1, 8, 0, 0, 0, {7, 8, 9}}))),
            (std::vector<unsigned>{7, 8, 9}));
  EXPECT_EQ(
      bytes_of(decoded("x.tga", crafted::tga({1, 2, 1, 8, 0, 2, 24, {3, 2, 1, 6, 5, 4, 1, 0}}))),
      (std::vector<unsigned>{4, 5, 6, 1, 2, 3}));
  // Run-length encoded: three times grey 5, then 6 and 7 as they are.
  EXPECT_EQ(bytes_of(decoded("x.tga", crafted::tga({11, 5, 1, 8, 0, 0, 0, {0x82, 5, 1, 6, 7}}))),
            (std::vector<unsigned>{5, 5, 5, 6, 7}));
}

TEST(Unit_ReadImage, BmpAndNetpbm) {
  EXPECT_EQ(bytes_of(decoded("x.bmp", crafted::bmp({1, 2, 24, 0, {3, 2, 1, 0, 6, 5, 4, 0}}))),
            (std::vector<unsigned>{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(bytes_of(decoded("x.ppm", crafted::text("P6\n2 1\n255\nabcdef"))),
            (std::vector<unsigned>{'a', 'b', 'c', 'd', 'e', 'f'}));
  EXPECT_EQ(bytes_of(decoded("x.pgm", crafted::text("P2\n# a comment\n2 1\n255\n7 200\n"))),
            (std::vector<unsigned>{7, 200}));
  EXPECT_EQ(bytes_of(decoded("x.pbm", crafted::text("P1\n3 1\n1 0 1\n"))),
            (std::vector<unsigned>{0, 255, 0}));
}

TEST(Unit_ReadImage, PfmRowsComeFromTheBottom) {
  const float rows[2] = {1.5f, -2.25f};
  crafted::Bytes bytes = crafted::text("Pf\n1 2\n-1.0\n") + crafted::Bytes(8);
  std::memcpy(bytes.data() + bytes.size() - 8, rows, 8);
  const DecodedImage image = decoded("x.pfm", bytes);
  ASSERT_EQ(image.header.sample_type, SampleType::Float);
  float found[2];
  std::memcpy(found, image.samples.get(), 8);
  EXPECT_EQ(found[0], -2.25f);
  EXPECT_EQ(found[1], 1.5f);
}

TEST(Errors_ReadImage, PfmHeadersThatEndEarly) {
  for (const char* text : {"PF\n", "PF 3", "PF\n3\n", "PF\n3 4\n"}) {
    const auto image = decode_image("x.pfm", crafted::text(text), DecodeLimits{});
    ASSERT_FALSE(image) << text;
    EXPECT_EQ(image.diagnostics.list()[0].message.find("substr"), std::string::npos)
        << image.diagnostics.list()[0].message;
  }
}

// The content decides, not the name.
TEST(Unit_ReadImage, AWrongExtensionOfAKnownKindDoesNoHarm) {
  EXPECT_EQ(bytes_of(decoded("x.jpg", crafted::text("P6\n1 1\n255\nabc"))),
            (std::vector<unsigned>{'a', 'b', 'c'}));
}

// What every picture can do without is cut out before a decoder sees it.
TEST(Unit_ReadImage, BrokenMetadataDoesNotMatter) {
  const crafted::Bytes broken_profile = crafted::png_chunk("iCCP", crafted::text("no profile"));
  crafted::Png image;
  image.samples = {1, 2, 3};
  EXPECT_EQ(bytes_of(decoded("x.png", crafted::png(image, broken_profile))),
            (std::vector<unsigned>{1, 2, 3}));
}

TEST(Unit_ReadImage, CmykIsConvertedWithAWarning) {
  const Result<DecodedImage> image = decode_image("x.jpg", crafted::cmyk_jpeg(), {});
  ASSERT_TRUE(image) << message_of(image.diagnostics);
  EXPECT_NE(message_of(image.diagnostics).find("printing inks (CMYK)"), std::string::npos);
  const std::vector<unsigned> values = bytes_of(*image);
  const double paper_through_black = 255.0 * (1 - 26 / 255.0);
  EXPECT_NEAR(values[0], paper_through_black * (1 - 64 / 255.0), 2);
  EXPECT_NEAR(values[1], paper_through_black * (1 - 128 / 255.0), 2);
  EXPECT_NEAR(values[2], paper_through_black * (1 - 191 / 255.0), 2);
}

TEST(Unit_ReadImage, OtherPrimariesThanRec709sAreWarnedOf) {
  const TemporaryFolder folder;
  const auto said_of = [&](const Imf::Chromaticities& primaries) {
    const std::string path = folder.path() + "/x.exr";
    Imf::Header header(1, 1);
    Imf::addChromaticities(header, primaries);
    const Imf::Rgba pixel(0.2f, 0.8f, 0.2f);
    {
      Imf::RgbaOutputFile file(path.c_str(), header, Imf::WRITE_RGB);
      file.setFrameBuffer(&pixel, 1, 1);
      file.writePixels(1);
    }
    EXPECT_TRUE(read_image_header(path, {}).diagnostics.list().empty());
    return message_of(read_decoded_image(path, {}).diagnostics);
  };
  EXPECT_EQ(said_of(Imf::Chromaticities()), "");  // those of Rec.709
  const Imf::Chromaticities rec2020({0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f},
                                    {0.3127f, 0.329f});
  EXPECT_NE(said_of(rec2020).find("has other primaries"), std::string::npos);
}

TEST(Unit_ReadImage, TheLimitIsHeldAgainstFloats) {
  const TemporaryFolder folder;
  const std::string path =
      folder.put("x.png", crafted::png_rgba(10, 10, [](int, int, int) { return 1u; }));
  EXPECT_TRUE(read_image(path, 1600));
  EXPECT_FALSE(read_image(path, 1599));
}

TEST(Unit_Half, MatchesItsDefinitionForEveryPattern) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
    const int exponent = static_cast<int>((bits >> 10) & 31);
    const double mantissa = bits & 1023;
    const float found = half_to_float(static_cast<std::uint16_t>(bits));
    if (exponent == 31) {
      EXPECT_EQ(std::isnan(found), mantissa != 0);
      EXPECT_EQ(std::isinf(found), mantissa == 0);
      continue;
    }
    const double magnitude =
        exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1 + mantissa / 1024, exponent - 15);
    ASSERT_EQ(found, static_cast<float>((bits & 0x8000) != 0 ? -magnitude : magnitude)) << bits;
  }
}

}  // namespace
}  // namespace candela
