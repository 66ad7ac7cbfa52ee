// Seeded damage to small files of every kind: a sentence or a picture, never a crash, and nothing
// on the error stream. The variable CANDELA_MUTATED_COPIES asks for more.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "renderer/image/decode.h"
#include "tests/image/crafted_files.h"

namespace candela {
namespace {

using crafted::operator+;

// Numbers from a counter, the same wherever the test runs.
class Stream {
 public:
  explicit Stream(std::uint64_t seed) : seed_(seed) {}
  std::size_t below(std::size_t limit) { return next() % limit; }

 private:
  std::uint64_t next() {  // splitmix64
    std::uint64_t z = (seed_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t seed_;
};

std::uint64_t copies_of(std::uint64_t usual) {
  const char* const asked = std::getenv("CANDELA_MUTATED_COPIES");
  return asked == nullptr ? usual : std::strtoull(asked, nullptr, 10);
}

void damage_once(crafted::Bytes& bytes, std::size_t reach, Stream& stream) {
  if (bytes.empty()) return;
  const std::size_t place = stream.below(std::min(reach, bytes.size()));
  const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(place);
  switch (stream.below(8)) {
    case 0:
    case 1:
      *at = static_cast<unsigned char>(*at ^ (1u << stream.below(8)));
      return;
    case 2:
    case 3:
      *at = static_cast<unsigned char>(stream.below(256));
      return;
    case 4:
      *at = 255;
      return;
    case 5:
      *at = 0;
      return;
    case 6:
      bytes.erase(
          at, at + static_cast<std::ptrdiff_t>(std::min(stream.below(16), bytes.size() - place)));
      return;
    default:
      if (stream.below(4) == 0) bytes.resize(place);
  }
}

// Half of the damage falls into the first 200 bytes, where headers are.
crafted::Bytes damaged(crafted::Bytes bytes, std::uint64_t seed) {
  Stream stream(seed);
  const std::size_t reach = stream.below(2) == 0 ? 200 : bytes.size();
  const std::size_t count = 1 + stream.below(6);
  for (std::size_t i = 0; i < count; ++i)
    damage_once(bytes, std::max<std::size_t>(reach, 1), stream);
  return bytes;
}

struct Encoding {
  std::string format, compression;
  OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
  int channels = 3;
  int tile = 0;
};

crafted::Bytes encoded(const Encoding& encoding) {
  constexpr int width = 24, height = 20;
  OIIO::ImageSpec spec(width, height, encoding.channels, encoding.type);
  spec.attribute("compression", encoding.compression);
  spec.attribute("tiff:write_exif", 0);
  spec.tile_width = spec.tile_height = encoding.tile;
  if (encoding.tile > 0) spec.tile_depth = 1;
  std::vector<float> values(static_cast<std::size_t>(width * height * encoding.channels));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>((i * i) % 251) / 251.0f;
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(encoding.format);
  output->set_ioproxy(&memory);
  EXPECT_TRUE(output->open("memory." + encoding.format, spec) &&
              output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close())
      << encoding.format << ' ' << encoding.compression << ": " << output->geterror();
  return bytes;
}

std::map<std::string, crafted::Bytes> sample_files() {
  using OIIO::TypeDesc;
  std::map<std::string, crafted::Bytes> files{
      {"none.exr", encoded({"exr", "none", TypeDesc::FLOAT})},
      {"zip.exr", encoded({"exr", "zip", TypeDesc::HALF, 4})},
      {"rle.exr", encoded({"exr", "rle", TypeDesc::HALF, 4})},
      {"piz.exr", encoded({"exr", "piz", TypeDesc::FLOAT})},
      {"pxr24.exr", encoded({"exr", "pxr24", TypeDesc::FLOAT})},
      {"b44.exr", encoded({"exr", "b44", TypeDesc::HALF})},
      {"dwaa.exr", encoded({"exr", "dwaa", TypeDesc::HALF})},
      {"tiled.exr", encoded({"exr", "zip", TypeDesc::FLOAT, 4, 8})},
      {"rgb.png", encoded({"png", ""})},
      {"rgba16.png", encoded({"png", "", TypeDesc::UINT16, 4})},
      {"rgb.jpg", encoded({"jpeg", ""})},
      {"grey.jpg", encoded({"jpeg", "", TypeDesc::UINT8, 1})},
      {"cmyk.jpg", crafted::cmyk_jpeg()},
      {"rgb.hdr", encoded({"hdr", "", TypeDesc::FLOAT})},
      {"none.tif", encoded({"tiff", "none", TypeDesc::FLOAT, 4})},
      {"lzw.tif", encoded({"tiff", "lzw"})},
      {"zip.tif", encoded({"tiff", "zip", TypeDesc::UINT16})},
      {"packbits.tif", encoded({"tiff", "packbits"})},
      {"jpeg.tif", encoded({"tiff", "jpeg"})},
      {"tiled.tif", encoded({"tiff", "zip", TypeDesc::UINT8, 4, 16})},
      {"rgb.bmp", encoded({"bmp", ""})},
      {"rgba.tga", encoded({"targa", "none", TypeDesc::UINT8, 4})},
      {"rle.tga", encoded({"targa", "rle", TypeDesc::UINT8, 4})},
      {"binary.ppm", encoded({"pnm", ""})},
      {"ascii.ppm", crafted::text("P3\n4 2\n255\n1 2 3 4 5 6 7 8 9 10 11 12\n13 14 15 16 17 18 "
                                  "19 20 21 22 23 24\n")},
      {"float.pfm", crafted::text("PF\n2 2\n-1.0\n") + crafted::Bytes(48, 0x3e)},
      {"palette.tga", crafted::tga({1, 8, 8, 8, 0, 4, 24, crafted::Bytes(76, 1)})},
  };
  crafted::Png palette;
  palette.width = 16;
  palette.height = 8;
  palette.bit_depth = 4;
  palette.colour = crafted::Palette;
  palette.samples = crafted::Bytes(64, 0x12);
  palette.palette = crafted::Bytes(9, 77);
  palette.transparency = {1, 2};
  files["palette.png"] = crafted::png(palette);
  return files;
}

// Headers are read without a decoder where that is possible: they say what is decoded all the same.
void expect_header_of(const std::string& name, const crafted::Bytes& bytes,
                      const DecodeLimits& limits, const ImageHeader& decoded) {
  const Result<ImageHeader> header = decode_header(name, bytes, limits);
  ASSERT_TRUE(header) << name;
  EXPECT_EQ(header->width, decoded.width) << name;
  EXPECT_EQ(header->height, decoded.height) << name;
  EXPECT_EQ(header->channels, decoded.channels) << name;
  EXPECT_EQ(header->sample_type, decoded.sample_type) << name;
  EXPECT_EQ(header->alpha_channel, decoded.alpha_channel) << name;
  EXPECT_EQ(header->alpha_is_straight, decoded.alpha_is_straight) << name;
}

void expect_sentence_or_picture(const std::string& name, const crafted::Bytes& bytes) {
  DecodeLimits limits;
  limits.max_bytes = std::size_t{64} << 20;
  const Result<DecodedImage> image = decode_image(name, bytes, limits);
  if (image) {
    EXPECT_GT(image->header.sample_count(), 0u);
    expect_header_of(name, bytes, limits, image->header);
    return;
  }
  ASSERT_EQ(image.diagnostics.error_count(), 1u);
  const std::string& message = image.diagnostics.list().front().message;
  EXPECT_EQ(message.find("'" + name + "' "), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Errors_MutatedImage, ThousandsOfDamagedFilesGiveSentencesOrPictures) {
  const std::uint64_t copies = copies_of(1000);
  const auto files = sample_files();
  testing::internal::CaptureStderr();
  for (const auto& [name, bytes] : files)
    for (std::uint64_t copy = 0; copy < copies; ++copy)
      expect_sentence_or_picture(name, damaged(bytes, copy * 1000003 + bytes.size()));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Checksums would stop most damage at the door. libpng writes a line about each of these on the
// error stream, which we cannot keep from it.
TEST(Errors_MutatedImage, DamagedPngsWithRightChecksumsToo) {
  const std::uint64_t copies = copies_of(2000);
  testing::internal::CaptureStderr();
  for (const auto& [name, bytes] : sample_files())
    if (name.ends_with(".png"))
      for (std::uint64_t copy = 0; copy < copies; ++copy)
        expect_sentence_or_picture(name, crafted::with_right_checksums(damaged(bytes, copy)));
  (void)testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace candela
