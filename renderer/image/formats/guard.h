// Checks of image files before a decoder of others sees them, and removal of what only could hurt:
// metadata blocks that no picture needs. Each takes the whole file and gives it back, changed or
// not, or a sentence without the file's name ("is truncated: ...").
#pragma once

#include "renderer/base/result.h"
#include "renderer/image/file_input.h"
#include "renderer/image/image_format.h"

namespace candela {

[[nodiscard]] Result<Bytes> guard_image(ImageFormat format, Bytes bytes);

// Chunks IHDR PLTE tRNS IDAT IEND stay, their checksums are verified (libpng prints what it finds
// wrong), and the size must be one that the compressed data can hold.
[[nodiscard]] Result<Bytes> guard_png(Bytes bytes);
// Segments APP1..13, APP15 and COM go (Exif, colour profiles, thumbnails); a size that the data
// cannot hold is refused.
[[nodiscard]] Result<Bytes> guard_jpeg(Bytes bytes);
// Deep and multi-part files are refused, and tables of chunks that are longer than the file; other
// primaries than Rec.709's are warned of.
[[nodiscard]] Result<Bytes> guard_exr(Bytes bytes);
// Run-length-encoded files are refused (OpenImageIO 2.4.7 reads none aright and throws on some),
// and sizes that the file does not hold.
[[nodiscard]] Result<Bytes> guard_bmp(Bytes bytes);

}  // namespace candela
