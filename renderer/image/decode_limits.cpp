#include "renderer/image/decode_limits.h"

#include <algorithm>

#include <fmt/format.h>

namespace candela {

Diagnostics check_size(double width, double height, double channels, SampleType type,
                       const DecodeLimits& limits) {
  if (width > limits.max_side || height > limits.max_side)
    return failure(fmt::format("claims {:.0f} x {:.0f} pixels; a side of at most {} is read", width,
                               height, limits.max_side));
  const std::size_t sample_bytes = size_of(limits.counts_floats ? SampleType::Float : type);
  const double kept_channels = std::min(channels, static_cast<double>(limits.max_channels));
  const double bytes = width * height * kept_channels * static_cast<double>(sample_bytes);
  if (bytes <= static_cast<double>(limits.max_bytes)) return {};
  return failure(
      fmt::format("claims {:.0f} x {:.0f} pixels: {:.0f} MB, where at most {:.0f} are read", width,
                  height, bytes / 1e6, static_cast<double>(limits.max_bytes) / 1e6));
}

}  // namespace candela
