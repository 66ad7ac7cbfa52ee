// Interleaved samples in memory, as OpenEXR's frame buffers name them.
#pragma once

#include <ImfFrameBuffer.h>

#include "renderer/image/decode.h"

namespace candela {

[[nodiscard]] inline Imf::PixelType exr_pixel_type(const ImageHeader& header) {
  return header.sample_type == SampleType::Half ? Imf::HALF : Imf::FLOAT;
}

// Of rows from the top, the first of which lies at (left, top) of the full picture, whose origin is
// what OpenEXR is told of.
[[nodiscard]] inline Imf::FrameBuffer exr_slices(const ImageHeader& header,
                                                 const std::byte* samples) {
  const std::size_t sample = size_of(header.sample_type);
  const std::size_t pixel = sample * header.channels.size();
  const Imath::V2i origin(header.left, header.top);
  Imf::FrameBuffer slices;
  for (std::size_t c = 0; c < header.channels.size(); ++c)
    slices.insert(header.channels[c], Imf::Slice::Make(exr_pixel_type(header), samples + c * sample,
                                                       origin, header.width, header.height, pixel));
  return slices;
}

}  // namespace candela
