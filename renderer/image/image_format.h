// The eight kinds of image files that are read and the five that are written.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace candela {

enum class ImageFormat : std::uint8_t { Exr, Png, Jpeg, Hdr, Tiff, Bmp, Tga, Pnm };

// "png", as users know it.
[[nodiscard]] std::string_view name_of(ImageFormat format);

// By the path's extension, letter case free.
[[nodiscard]] std::optional<ImageFormat> format_of_extension(std::string_view path);

// By the first bytes: what a file is, whatever it is called. TGA has no such mark.
[[nodiscard]] std::optional<ImageFormat> format_of_bytes(std::span<const unsigned char> bytes);

[[nodiscard]] bool is_writable(ImageFormat format);

// The extension with its dot ("" where there is none), as written.
[[nodiscard]] std::string_view extension_of(std::string_view path);

inline constexpr std::string_view readable_extensions =
    ".exr .png .jpg .jpeg .hdr .tif .tiff .bmp .tga .pnm .ppm .pgm .pbm .pfm";
inline constexpr std::string_view writable_extensions = ".exr .png .jpg .jpeg .hdr .tif .tiff";

}  // namespace candela
