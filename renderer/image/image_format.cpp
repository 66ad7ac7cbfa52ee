#include "renderer/image/image_format.h"

#include <array>
#include <cctype>
#include <utility>

#include "renderer/base/letter_case.h"

namespace candela {
namespace {

constexpr std::array<std::pair<std::string_view, ImageFormat>, 15> extensions{{
    {".exr", ImageFormat::Exr},
    {".png", ImageFormat::Png},
    {".jpg", ImageFormat::Jpeg},
    {".jpeg", ImageFormat::Jpeg},
    {".hdr", ImageFormat::Hdr},
    {".rgbe", ImageFormat::Hdr},
    {".tif", ImageFormat::Tiff},
    {".tiff", ImageFormat::Tiff},
    {".bmp", ImageFormat::Bmp},
    {".tga", ImageFormat::Tga},
    {".pnm", ImageFormat::Pnm},
    {".ppm", ImageFormat::Pnm},
    {".pgm", ImageFormat::Pnm},
    {".pbm", ImageFormat::Pnm},
    {".pfm", ImageFormat::Pnm},
}};

constexpr std::array<std::pair<std::string_view, ImageFormat>, 8> marks{{
    {"\x76\x2f\x31\x01", ImageFormat::Exr},
    {"\x89PNG\r\n\x1a\n", ImageFormat::Png},
    {"\xff\xd8\xff", ImageFormat::Jpeg},
    {"#?RADIANCE", ImageFormat::Hdr},
    {"#?RGBE", ImageFormat::Hdr},
    {std::string_view("II*\0", 4), ImageFormat::Tiff},
    {std::string_view("MM\0*", 4), ImageFormat::Tiff},
    {"BM", ImageFormat::Bmp},
}};

// P1 ... P6 and the float maps PF, Pf, each followed by white space.
bool is_netpbm(std::string_view text) {
  return text.size() > 2 && text[0] == 'P' &&
         std::string_view("123456Ff").find(text[1]) != std::string_view::npos &&
         std::isspace(static_cast<unsigned char>(text[2])) != 0;
}

}  // namespace

std::string_view name_of(ImageFormat format) {
  switch (format) {
    case ImageFormat::Exr:
      return "exr";
    case ImageFormat::Png:
      return "png";
    case ImageFormat::Jpeg:
      return "jpeg";
    case ImageFormat::Hdr:
      return "hdr";
    case ImageFormat::Tiff:
      return "tiff";
    case ImageFormat::Bmp:
      return "bmp";
    case ImageFormat::Tga:
      return "tga";
    case ImageFormat::Pnm:
      return "pnm";
  }
  return "";
}

std::string_view extension_of(std::string_view path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string_view::npos ? std::string_view{} : name.substr(dot);
}

std::optional<ImageFormat> format_of_extension(std::string_view path) {
  const std::string_view extension = extension_of(path);
  for (const auto& [known, format] : extensions)
    if (equal_ignoring_case(extension, known)) return format;
  return std::nullopt;
}

std::optional<ImageFormat> format_of_bytes(std::span<const unsigned char> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const auto& [mark, format] : marks)
    if (text.starts_with(mark)) return format;
  if (is_netpbm(text)) return ImageFormat::Pnm;
  return std::nullopt;
}

bool is_writable(ImageFormat format) {
  switch (format) {
    case ImageFormat::Exr:
    case ImageFormat::Png:
    case ImageFormat::Jpeg:
    case ImageFormat::Hdr:
    case ImageFormat::Tiff:
      return true;
    case ImageFormat::Bmp:
    case ImageFormat::Tga:
    case ImageFormat::Pnm:
      return false;
  }
  return false;
}

}  // namespace candela
