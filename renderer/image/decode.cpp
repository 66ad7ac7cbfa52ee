#include "renderer/image/decode.h"

#include <algorithm>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "renderer/image/codecs.h"
#include "renderer/image/decode_limits.h"
#include "renderer/image/guard.h"
#include "renderer/image/image_format.h"
#include "renderer/image/jpeg_header.h"
#include "renderer/image/tga.h"

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

Result<ImageHeader> checked_tga_header(const Bytes& bytes, const DecodeLimits& limits) {
  Result<ImageHeader> header = decode_tga_header(bytes);
  if (!header) return header;
  return within(limits, std::move(*header));
}

Result<DecodedImage> checked_tga(const Bytes& bytes, const DecodeLimits& limits) {
  const Result<ImageHeader> header = checked_tga_header(bytes, limits);
  if (!header) return header.diagnostics;
  return decode_tga(bytes);
}

// Recognises, guards and hands on to `decode_tga_file` or, with the format, to `decode_other`.
template <class T, class DecodeTga, class DecodeOther>
Result<T> dispatch(const std::string& name, Bytes bytes, DecodeTga&& decode_tga_file,
                   DecodeOther&& decode_other) {
  if (!format_of_extension(name))
    return failure(fmt::format("'{}' has no extension of an image; expected one of {}", name,
                               readable_extensions));
  const auto format = format_of(name, bytes);
  if (!format) return failure(fmt::format("'{}' does not begin as any image that is read", name));
  try {
    if (*format == ImageFormat::Tga) return named(name, decode_tga_file(bytes));
    Result<Bytes> guarded = guard_image(*format, std::move(bytes));
    if (!guarded) return named(name, guarded.diagnostics);
    return named(name, decode_other(*format, std::move(*guarded)));
  } catch (const std::bad_alloc&) {
    return failure(fmt::format("'{}' needs more memory than there is", name));
  } catch (const std::exception& exception) {
    return failure(fmt::format("'{}' cannot be decoded: {}", name, exception.what()));
  }
}

Result<ImageHeader> other_header(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  auto plain = format == ImageFormat::Jpeg ? plain_jpeg_header(bytes) : std::nullopt;
  if (plain) {
    plain->channels.resize(std::min(plain->channels.size(), limits.max_channels));
    return within(limits, std::move(*plain));
  }
  const Result<Codecs> others = codecs();
  if (!others) return others.diagnostics;
  return others->decode_header(format, std::move(bytes), limits);
}

Result<DecodedImage> decode_other(ImageFormat format, Bytes bytes, const DecodeLimits& limits) {
  const Result<Codecs> others = codecs();
  if (!others) return others.diagnostics;
  return others->decode(format, std::move(bytes), limits);
}

std::size_t file_limit(const DecodeLimits& limits) {
  constexpr std::size_t room_for_headers = std::size_t{64} << 20;
  return limits.max_bytes + room_for_headers;
}

}  // namespace

Diagnostics prepare_to_decode(const std::string& name) {
  if (format_of_extension(name) == ImageFormat::Tga) return {};
  return named(name, codecs().diagnostics);
}

Result<ImageHeader> decode_header(const std::string& name, Bytes bytes,
                                  const DecodeLimits& limits) {
  return dispatch<ImageHeader>(
      name, std::move(bytes), [&](const Bytes& tga) { return checked_tga_header(tga, limits); },
      [&](ImageFormat format, Bytes other) {
        return other_header(format, std::move(other), limits);
      });
}

Result<DecodedImage> decode_image(const std::string& name, Bytes bytes,
                                  const DecodeLimits& limits) {
  return dispatch<DecodedImage>(
      name, std::move(bytes), [&](const Bytes& tga) { return checked_tga(tga, limits); },
      [&](ImageFormat format, Bytes other) {
        return decode_other(format, std::move(other), limits);
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
