// Image files to samples in their own bit depth. Nothing is allocated on a header's word: formats
// are recognised by content, their structure is checked (formats/guard.h), sizes are held against a
// limit, and rows are decoded in bands into memory that is reserved but untouched until they
// arrive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/image/file_input.h"

namespace candela {

enum class SampleType : std::uint8_t { U8, U16, Half, Float };

[[nodiscard]] constexpr std::size_t size_of(SampleType type) {
  switch (type) {
    case SampleType::U8:
      return 1;
    case SampleType::U16:
    case SampleType::Half:
      return 2;
    case SampleType::Float:
      return 4;
  }
  return 0;
}

struct ImageHeader {
  int width = 0;
  int height = 0;
  SampleType sample_type = SampleType::U8;
  std::vector<std::string> channels;
  int alpha_channel = -1;
  bool alpha_is_straight = false;  // else colour is premultiplied by it
  int left = 0, top = 0;  // where its first pixel lies in the picture of which it is a part (EXR)

  [[nodiscard]] std::size_t sample_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels.size();
  }
};

struct DecodedImage {
  ImageHeader header;
  std::shared_ptr<std::byte[]> samples;  // rows from the top, interleaved, machine byte order
};

// The samples' memory, in large pages, which images share; not initialised but for one spare sample
// at the end: a pixel of three may be loaded as if it had four.
[[nodiscard]] std::shared_ptr<std::byte[]> allocate_samples(const ImageHeader& header);

struct DecodeLimits {
  std::size_t max_bytes = std::size_t{4} << 30;  // of the decoded samples
  std::size_t max_channels = 1024;               // further ones are left out
  int max_side = 1 << 22;                        // a float tells the texels of such a row apart
  bool counts_floats = false;                    // each sample counts four bytes, whatever its type
};

// `name` is what messages call the image: its path. Errors begin with it in quotes; warnings tell
// of what was converted (CMYK) or complained about by a decoder that went on.
[[nodiscard]] Result<ImageHeader> decode_header(const std::string& name, Bytes bytes,
                                                const DecodeLimits& limits);
[[nodiscard]] Result<DecodedImage> decode_image(const std::string& name, Bytes bytes,
                                                const DecodeLimits& limits);

// The same, of a regular file.
[[nodiscard]] Result<ImageHeader> read_image_header(const std::string& path,
                                                    const DecodeLimits& limits);
[[nodiscard]] Result<DecodedImage> read_decoded_image(const std::string& path,
                                                      const DecodeLimits& limits);

}  // namespace candela
