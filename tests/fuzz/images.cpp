// Every image format, through its guard.
#include "renderer/image/decode.h"
#include "renderer/image/image_format.h"
#include "tests/fuzz/check_errors.h"
#include "tests/fuzz/readers.h"
#include "tests/image/crafted_files.h"

namespace candela::fuzz {
namespace {

std::string fault_of(const Result<DecodedImage>& image) {
  if (!image) return fault_of_failure(image.diagnostics);
  const ImageHeader& header = image->header;
  if (header.sample_count() == 0) return "a picture without samples";
  if (header.alpha_channel >= static_cast<int>(header.channels.size())) return "alpha beyond all";
  return fuzz::fault_of(image.diagnostics);
}

std::string try_image(ImageFormat format, const Bytes& bytes) {
  const std::optional<ImageFormat> found = format_of_bytes(bytes);
  if (format == ImageFormat::Tga ? found.has_value() : found != format) return "";
  DecodeLimits limits;
  limits.max_bytes = std::size_t{4} << 20;
  const std::string name = "fuzzed." + std::string(name_of(format));
  if (decode_header(name, bytes, limits).diagnostics.error_count() > 1) return "several errors";
  return fault_of(decode_image(name, bytes, limits));
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

}  // namespace

std::string try_exr(std::string_view bytes) {
  return try_image(ImageFormat::Exr, bytes_of(bytes));
}
// Checksums would stop most of it at the door: set right, they let it in.
std::string try_png(std::string_view bytes) {
  const std::string fault = try_image(ImageFormat::Png, bytes_of(bytes));
  if (!fault.empty()) return fault;
  return try_image(ImageFormat::Png, crafted::with_right_checksums(bytes_of(bytes)));
}
std::string try_jpeg(std::string_view bytes) {
  return try_image(ImageFormat::Jpeg, bytes_of(bytes));
}
std::string try_hdr(std::string_view bytes) {
  return try_image(ImageFormat::Hdr, bytes_of(bytes));
}
std::string try_tiff(std::string_view bytes) {
  return try_image(ImageFormat::Tiff, bytes_of(bytes));
}
std::string try_bmp(std::string_view bytes) {
  return try_image(ImageFormat::Bmp, bytes_of(bytes));
}
std::string try_tga(std::string_view bytes) {
  return try_image(ImageFormat::Tga, bytes_of(bytes));
}
std::string try_pnm(std::string_view bytes) {
  return try_image(ImageFormat::Pnm, bytes_of(bytes));
}

}  // namespace candela::fuzz
