#include "renderer/image/decode.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <type_traits>

#include <fmt/format.h>

#include "renderer/base/lack_of_threads.h"
#include "renderer/image/codecs.h"
#include "renderer/image/decode_limits.h"
#include "renderer/image/formats/decode_exr.h"
#include "renderer/image/formats/decode_jpeg.h"
#include "renderer/image/formats/decode_pfm.h"
#include "renderer/image/formats/decode_png.h"
#include "renderer/image/formats/decode_tga.h"
#include "renderer/image/formats/guard.h"
#include "renderer/image/image_format.h"

namespace candela {
namespace {

std::optional<ImageFormat> format_of(const std::string& name, const Bytes& bytes) {
  if (const auto found = format_of_bytes(bytes)) return found;
  if (format_of_extension(name) == ImageFormat::Tga) return ImageFormat::Tga;
  return std::nullopt;
}

// Puts the image's name before each message.
Diagnostics named(const std::string& name, const Diagnostics& found) {
  Diagnostics result;
  for (Diagnostic diagnostic : found.list()) {
    diagnostic.message = fmt::format("'{}' {}", name, diagnostic.message);
    result.add(std::move(diagnostic));
  }
  return result;
}

template <class T>
Result<T> named(const std::string& name, Result<T> result) {
  result.diagnostics = named(name, result.diagnostics);
  return result;
}

Result<ImageHeader> within(const DecodeLimits& limits, ImageHeader header) {
  const Diagnostics found =
      check_size(header.width, header.height, static_cast<double>(header.channels.size()),
                 header.sample_type, limits);
  if (found.has_errors()) return found;
  return header;
}

using MaybeHeader = std::optional<Result<ImageHeader>>;

MaybeHeader if_plain(std::optional<ImageHeader> header) {
  if (!header) return std::nullopt;
  return Result<ImageHeader>(std::move(*header));
}

// What is read without OpenImageIO: all PNG and TGA, and of JPEG, EXR and float maps what pictures
// mostly are. Empty for the rest, and for broken ones, of which OpenImageIO tells what is wrong.
MaybeHeader own_header(ImageFormat format, const Bytes& bytes) {
  switch (format) {
    case ImageFormat::Png:
      return decode_png_header(bytes);
    case ImageFormat::Tga:
      return decode_tga_header(bytes);
    case ImageFormat::Jpeg:
      return if_plain(plain_jpeg_header(bytes));
    case ImageFormat::Exr:
      return if_plain(plain_exr_header(bytes));
    case ImageFormat::Pnm:
      return if_plain(plain_pfm_header(bytes));
    case ImageFormat::Hdr:
    case ImageFormat::Tiff:
    case ImageFormat::Bmp:
      break;
  }
  return std::nullopt;
}

// Of a file with an own_header().
Result<DecodedImage> decode_own(ImageFormat format, const Bytes& bytes, const ImageHeader& header) {
  if (format == ImageFormat::Png) return decode_png(bytes, header);
  if (format == ImageFormat::Tga) return decode_tga(bytes);
  if (format == ImageFormat::Jpeg) return decode_plain_jpeg(bytes, header);
  if (format == ImageFormat::Exr) return decode_plain_exr(bytes, header);
  return decode_plain_pfm(bytes, header);
}

void leave_out_channels(ImageHeader& header, std::size_t max_channels) {
  header.channels.resize(std::min(header.channels.size(), max_channels));
  if (std::cmp_greater_equal(header.alpha_channel, header.channels.size()))
    header.alpha_channel = -1;
}

// Of each pixel the first channels stay, closed up.
void leave_out_channels(DecodedImage& image, std::size_t max_channels) {
  const std::size_t before = image.header.channels.size();
  if (before <= max_channels) return;
  const std::size_t pixels = image.header.sample_count() / before;
  const std::size_t sample = size_of(image.header.sample_type);
  for (std::size_t i = 0; i < pixels; ++i)
    std::memmove(image.samples.get() + i * max_channels * sample,
                 image.samples.get() + i * before * sample, max_channels * sample);
  leave_out_channels(image.header, max_channels);
}

Result<ImageHeader> header_of(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  if (MaybeHeader own = own_header(format, bytes)) {
    if (!*own) return std::move(*own);
    leave_out_channels(**own, limits.max_channels);
    return within(limits, std::move(**own));
  }
  const Result<Codecs> others = codecs();
  if (!others) return others.diagnostics;
  return others->decode_header(format, std::move(bytes), limits);
}

Result<DecodedImage> image_of(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  if (MaybeHeader own = own_header(format, bytes)) {
    if (!*own) return own->diagnostics;
    DecodeLimits of_all = limits;
    of_all.max_channels = (*own)->channels.size();
    const Result<ImageHeader> header = within(of_all, std::move(**own));
    if (!header) return header.diagnostics;
    Result<DecodedImage> image = decode_own(format, bytes, *header);
    if (image) leave_out_channels(*image, limits.max_channels);
    return image;
  }
  const Result<Codecs> others = codecs();
  if (!others) return others.diagnostics;
  return others->decode(format, std::move(bytes), limits);
}

// Recognises, guards and hands on to `decode`. What the guard warns of is said with the samples.
template <class T, class Decode>
Result<T> dispatch(const std::string& name, Bytes bytes, Decode&& decode) {
  if (!format_of_extension(name))
    return failure(fmt::format("'{}' has no extension of an image; expected one of {}", name,
                               readable_extensions));
  const auto format = format_of(name, bytes);
  if (!format) return failure(fmt::format("'{}' does not begin as any image that is read", name));
  try {
    Result<Bytes> guarded = guard_image(*format, std::move(bytes));
    if (!guarded) return named(name, guarded.diagnostics);
    Result<T> result = decode(*format, std::move(*guarded));
    if constexpr (std::is_same_v<T, DecodedImage>)
      for (const Diagnostic& warning : guarded.diagnostics.list()) result.diagnostics.add(warning);
    return named(name, std::move(result));
  } catch (const std::bad_alloc&) {
    throw;  // no picture may depend on how much memory is free
  } catch (const std::exception& exception) {
    if (is_lack_of_threads(exception)) throw;
    return failure(fmt::format("'{}' cannot be decoded: {}", name, exception.what()));
  }
}

std::size_t file_limit(const DecodeLimits& limits) {
  constexpr std::size_t room_for_headers = std::size_t{64} << 20;
  return limits.max_bytes + room_for_headers;
}

}  // namespace

Result<ImageHeader> decode_header(const std::string& name, Bytes bytes,
                                  const DecodeLimits& limits) {
  return dispatch<ImageHeader>(name, std::move(bytes), [&](ImageFormat format, Bytes guarded) {
    return header_of(format, std::move(guarded), limits);
  });
}

Result<DecodedImage> decode_image(const std::string& name, Bytes bytes,
                                  const DecodeLimits& limits) {
  return dispatch<DecodedImage>(name, std::move(bytes), [&](ImageFormat format, Bytes guarded) {
    return image_of(format, std::move(guarded), limits);
  });
}

Result<ImageHeader> read_image_header(const std::string& path, const DecodeLimits& limits) {
  Result<Bytes> bytes = read_regular_file(path, file_limit(limits));
  if (!bytes) return bytes.diagnostics;
  return decode_header(path, std::move(*bytes), limits);
}

Result<DecodedImage> read_decoded_image(const std::string& path, const DecodeLimits& limits) {
  Result<Bytes> bytes = read_regular_file(path, file_limit(limits));
  if (!bytes) return bytes.diagnostics;
  return decode_image(path, std::move(*bytes), limits);
}

}  // namespace candela
