// A picture in memory: rows from the top, interleaved 32-bit floats.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace candela {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  // names: "R", "G", "B", "A", "albedo.R", ...
  std::vector<float> values;          // ((y * width) + x) * channels.size() + c

  Image() = default;
  Image(int w, int h, std::vector<std::string> names)
      : width(w),
        height(h),
        channels(std::move(names)),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * channels.size()) {}

  [[nodiscard]] std::size_t channel_count() const { return channels.size(); }
  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] float* pixel(int x, int y) { return values.data() + offset(x, y); }
  [[nodiscard]] const float* pixel(int x, int y) const { return values.data() + offset(x, y); }
  // The index of a channel by name, or -1.
  [[nodiscard]] int channel_index(const std::string& name) const {
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (channels[c] == name) return static_cast<int>(c);
    return -1;
  }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x)) *
           channels.size();
  }
};

}  // namespace candela
