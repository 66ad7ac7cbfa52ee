#include "renderer/image/formats/guard.h"

#include <utility>

namespace candela {

Result<Bytes> guard_image(ImageFormat format, Bytes bytes) {
  switch (format) {
    case ImageFormat::Png:
      return guard_png(std::move(bytes));
    case ImageFormat::Jpeg:
      return guard_jpeg(std::move(bytes));
    case ImageFormat::Exr:
      return guard_exr(std::move(bytes));
    case ImageFormat::Bmp:
      return guard_bmp(std::move(bytes));
    case ImageFormat::Hdr:
    case ImageFormat::Tiff:
    case ImageFormat::Tga:
    case ImageFormat::Pnm:
      return bytes;
  }
  return bytes;
}

}  // namespace candela
