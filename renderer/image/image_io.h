// Image files, whole ones of linear floats (textures: decode.h).
//
// Writing is all or nothing: a file is encoded in memory, written beside its target,
// fsync'ed and renamed over it. Reading trusts no header: width, height, channels and byte size are
// held against a limit before anything is allocated, only regular files are opened, and only the
// formats exr png jpeg hdr tiff bmp tga pnm.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/image/image.h"

namespace candela {

// How linear radiance becomes 8 bits. Exposure multiplies by 2^exposure first.
enum class ToneMap : std::uint8_t {
  Srgb,  // clamp, sRGB curve
  Aces,  // the fitted filmic curve of [Narkowicz15], then sRGB
  Lab3,  // pow(c, 1/2.2), then clamp: the lab's own display encoding
};

struct DisplayTransform {
  ToneMap tone_map = ToneMap::Srgb;
  double exposure = 0;  // stops
};

using MetadataValue = std::variant<std::string, double, std::int64_t>;
using Metadata = std::vector<std::pair<std::string, MetadataValue>>;

// Writes by the extension: .exr (32-bit float, all channels, metadata; window offset for crops),
// .hdr .tif .tiff (float, linear; R G B (A)), .png .jpg .jpeg (8 bit, through `display`).
// PNG and TIFF keep alpha where there is a channel "A" (EXR: premultiplied as rendered; PNG:
// straight); JPEG and HDR drop it. Of the metadata other formats than EXR keep at most "DateTime";
// EXR and TIFF note the time of day where it is not given. The error names the file and what
// failed: a channel without a name or two of one name, metadata that an EXR needs for itself
// ("channels", "compression").
struct WriteOptions {
  DisplayTransform display;
  Metadata metadata;
  int offset_x = 0;  // where the image lies in the full picture (EXR data window)
  int offset_y = 0;
  int full_width = 0;  // 0: the image is the full picture
  int full_height = 0;
};
[[nodiscard]] Diagnostics write_image(const std::string& path, const Image& image,
                                      const WriteOptions& options);

// Whether `path` can be written later: known extension, existing folder, permission, no directory,
// and what encodes it is there (codecs.h: it is loaded for others than EXR and PNG).
// Empty where all is well.
[[nodiscard]] Diagnostics check_writable_image(const std::string& path);

// Whether its format holds a picture of this size; empty where all is well or there is no format.
[[nodiscard]] Diagnostics check_image_size(const std::string& path, int width, int height);

// The same as check_writable_image() of any output but for the extension.
[[nodiscard]] Diagnostics check_writable_file(const std::string& path);

// Bytes to a file, all or nothing. For any output (stats, CSV, images). Symbolic links are
// followed; a pipe, a device and what /dev/stdout is open on are written to as they stand.
[[nodiscard]] Diagnostics write_file_atomically(const std::string& path, const std::string& bytes);

// Reads a whole image as linear floats: integers, of 8 bits and of 16, are decoded from sRGB (alpha
// is not), floats are linear as they stand; where the file's alpha is straight, colour is
// premultiplied. `max_bytes` limits width * height * channels * 4.
[[nodiscard]] Result<Image> read_image(const std::string& path,
                                       std::size_t max_bytes = std::size_t{4} << 30);

}  // namespace candela
