#include "tests/image/openimageio/sample_files.h"

#include <OpenImageIO/filesystem.h>
#include <gtest/gtest.h>

namespace candela {

using crafted::operator+;

crafted::Bytes encoded(const Encoding& encoding) {
  constexpr int width = 24, height = 20;
  OIIO::ImageSpec spec(width, height, encoding.channels, encoding.type);
  spec.attribute("compression", encoding.compression);
  spec.attribute("tiff:write_exif", 0);
  for (const auto& [name, value] : encoding.attributes) spec.attribute(name, value);
  spec.x = encoding.left;
  spec.y = encoding.top;
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

}  // namespace candela
