// What is read without OpenImageIO is read as it does.
#include <gtest/gtest.h>

#include <cstring>

#include "renderer/image/codecs.h"
#include "renderer/image/decode.h"
#include "renderer/image/formats/guard.h"
#include "tests/image/openimageio/sample_files.h"

namespace candela {
namespace {

using crafted::operator+;
using Files = std::map<std::string, crafted::Bytes>;

Result<DecodedImage> decoded_by_openimageio(const std::string& name, const crafted::Bytes& bytes,
                                            const DecodeLimits& limits) {
  const ImageFormat format = *format_of_bytes(bytes);
  Result<Bytes> guarded = guard_image(format, bytes);
  EXPECT_TRUE(guarded) << name;
  return codecs()->decode(format, std::move(*guarded), limits);
}

void expect_equal_headers(const std::string& name, const ImageHeader& own,
                          const ImageHeader& other) {
  EXPECT_EQ(own.width, other.width) << name;
  EXPECT_EQ(own.height, other.height) << name;
  EXPECT_EQ(own.left, other.left) << name;
  EXPECT_EQ(own.top, other.top) << name;
  EXPECT_EQ(own.channels, other.channels) << name;
  EXPECT_EQ(own.sample_type, other.sample_type) << name;
  EXPECT_EQ(own.alpha_channel, other.alpha_channel) << name;
  EXPECT_EQ(own.alpha_is_straight, other.alpha_is_straight) << name;
}

void expect_agreement(const Files& files, const DecodeLimits& limits = {}) {
  for (const auto& [name, bytes] : files) {
    const Result<DecodedImage> own = decode_image(name, bytes, limits);
    const Result<DecodedImage> other = decoded_by_openimageio(name, bytes, limits);
    ASSERT_TRUE(own && other) << name;
    EXPECT_TRUE(own.diagnostics.list().empty()) << name;
    expect_equal_headers(name, own->header, other->header);
    ASSERT_EQ(own->header.sample_count(), other->header.sample_count()) << name;
    const std::size_t size = own->header.sample_count() * size_of(own->header.sample_type);
    EXPECT_EQ(std::memcmp(own->samples.get(), other->samples.get(), size), 0) << name;
  }
}

crafted::Png png_of(crafted::PngColour colour, unsigned depth, std::size_t channels) {
  crafted::Png png;
  png.width = 13;
  png.height = 9;
  png.bit_depth = depth;
  png.colour = colour;
  const std::size_t row_bytes = (png.width * depth * channels + 7) / 8;
  for (std::size_t i = 0; i < png.height * row_bytes; ++i)
    png.samples.push_back(static_cast<unsigned char>(i * i * 37 + i * 11));
  if (colour == crafted::Palette)
    for (unsigned i = 0; i < 3u << depth; ++i)
      png.palette.push_back(static_cast<unsigned char>(i * 29));
  return png;
}

void add_pngs(Files& files, crafted::PngColour colour, std::size_t channels,
              const std::vector<unsigned>& depths, const crafted::Bytes& transparency) {
  for (const unsigned depth : depths) {
    crafted::Png png = png_of(colour, depth, channels);
    const std::string name = "colour " + std::to_string(colour) + " bits " + std::to_string(depth);
    files[name + ".png"] = crafted::png(png);
    png.transparency = transparency;
    if (!transparency.empty()) files[name + " transparent.png"] = crafted::png(png);
  }
}

TEST(Agreement_OwnCodecs, PngsOfAllColoursAndDepths) {
  Files files;
  add_pngs(files, crafted::Grey, 1, {1, 2, 4, 8, 16}, {0, 1});
  add_pngs(files, crafted::Rgb, 3, {8, 16}, {0, 0, 0, 11, 0, 59});
  add_pngs(files, crafted::Palette, 1, {1, 2, 4, 8}, {0, 100});
  add_pngs(files, crafted::GreyAlpha, 2, {8, 16}, {});
  add_pngs(files, crafted::Rgba, 4, {8, 16}, {});
  expect_agreement(files);
}

TEST(Agreement_OwnCodecs, JpegsOfAllSubsamplings) {
  Files files{{"grey.jpg", encoded({"jpeg", "", OIIO::TypeDesc::UINT8, 1})}};
  for (const char* subsampling : {"4:4:4", "4:2:2", "4:2:0", "4:1:1", "4:2:1"}) {
    Encoding encoding{"jpeg", "jpeg:85"};
    encoding.attributes = {{"jpeg:subsampling", subsampling}};
    files[std::string(subsampling) + ".jpg"] = encoded(encoding);
  }
  expect_agreement(files);
}

TEST(Agreement_OwnCodecs, ExrsOfAllCompressions) {
  using OIIO::TypeDesc;
  Files files;
  for (const char* compression :
       {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"})
    for (const auto& [type, word] : {std::pair(TypeDesc::HALF, "half"), {TypeDesc::FLOAT, "float"}})
      for (const int channels : {1, 3, 4})
        for (const int tile : {0, 16}) {
          const std::string name =
              fmt::format("{} {} {} {}.exr", compression, word, channels, tile);
          files[name] = encoded({"exr", compression, type, channels, tile, {}, -5, 7});
        }
  expect_agreement(files);
}

TEST(Agreement_OwnCodecs, FloatMaps) {
  crafted::Bytes rows;
  for (unsigned i = 0; i < 5 * 3 * 12; ++i) rows.push_back(static_cast<unsigned char>(40 + i % 30));
  Files files;
  for (const char* scale : {"-1.0", "1", "1.000", "-1"}) {
    files[std::string("rgb ") + scale + ".pfm"] =
        crafted::text(std::string("PF\n5 3\n") + scale + "\n") + rows;
    files[std::string("grey ") + scale + ".pfm"] =
        crafted::text(std::string("Pf\n5 9\n") + scale + "\n") + rows;
  }
  expect_agreement(files);
}

TEST(Agreement_OwnCodecs, FewerChannelsThanThereAre) {
  using OIIO::TypeDesc;
  const Files files{{"x.png", crafted::png(png_of(crafted::Rgba, 16, 4))},
                    {"x.jpg", encoded({"jpeg", ""})},
                    {"x.exr", encoded({"exr", "zip", TypeDesc::HALF, 4})}};
  for (const std::size_t count : {1, 2, 3}) {
    DecodeLimits limits;
    limits.max_channels = count;
    expect_agreement(files, limits);
  }
}

// What is left to OpenImageIO comes through.
TEST(Agreement_OwnCodecs, WhatIsNotPlain) {
  Encoding scaled{"exr", "zip", OIIO::TypeDesc::UINT32};
  Files files{{"integers.exr", encoded(scaled)},
              {"five.exr", encoded({"exr", "zip", OIIO::TypeDesc::HALF, 5})},
              {"two.exr", encoded({"exr", "zip", OIIO::TypeDesc::HALF, 2})},
              {"scaled.pfm", crafted::text("Pf\n1 1\n-2.0\n") + crafted::Bytes(4, 0x3e)},
              {"binary.ppm", encoded({"pnm", ""})}};
  expect_agreement(files);
}

}  // namespace
}  // namespace candela
