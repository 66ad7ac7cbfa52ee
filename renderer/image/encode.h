// A picture as the bytes of an image file, made in memory: EXR by OpenEXR, PNG by libpng, others by
// OpenImageIO.
#pragma once

#include "renderer/base/result.h"
#include "renderer/image/decode.h"
#include "renderer/image/image.h"
#include "renderer/image/image_format.h"
#include "renderer/image/image_io.h"

namespace candela {

// Whether the format can hold pictures of this size: an error without the path, such as "a jpeg can
// be at most 65500 pixels wide and high, not 70000 x 2".
[[nodiscard]] Diagnostics check_sides(ImageFormat format, int width, int height);

// Whether OpenImageIO writes the format, which is a module to load (codecs.h).
[[nodiscard]] bool is_encoded_by_codecs(ImageFormat format);

// What the format cannot hold (a JPEG side over 65500, no channels, ...) is an error without the
// path.
[[nodiscard]] Result<std::string> encode_image(ImageFormat format, const Image& image,
                                               const WriteOptions& options);

// Samples as they were stored, neither decoded nor multiplied by anything: integers in a PNG,
// floats in an EXR file. `channel`: a grey picture of that one; -1: all.
[[nodiscard]] Result<std::string> encode_samples(const DecodedImage& image, int channel);

}  // namespace candela
