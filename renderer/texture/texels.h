// The pixels of one image file: decoded once, on first touch, in the file's own bit depth, and
// shared by all textures of that file.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

#include "renderer/base/diagnostic.h"
#include "renderer/image/decode.h"
#include "renderer/texture/range_tree.h"

namespace candela {

// From allocate_samples(). Rows from the top, interleaved: grey, grey and alpha, RGB, RGBA.
struct TexelArray {
  std::shared_ptr<std::byte[]> samples;
  int width = 1;
  int height = 1;
  int channels = 1;
  SampleType type = SampleType::U8;

  [[nodiscard]] bool has_alpha() const { return channels % 2 == 0; }
  [[nodiscard]] std::size_t bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(channels) * size_of(type);
  }
};

// A sample as stored: integers as [0,1].
[[nodiscard]] float stored_value(const TexelArray& texels, int x, int y, int channel);

// Whether alpha, the last channel, is 1 everywhere.
[[nodiscard]] bool is_opaque(const TexelArray& texels);
// Whether all colours of each texel are equal.
[[nodiscard]] bool is_grey(const TexelArray& texels);

class TextureFile {
 public:
  // A file that `found` has errors about is magenta from the start.
  // Of one that is light values below 0 count as 0, and are told of with what else is wrong.
  TextureFile(std::string path, SourceSpan span, const Result<ImageHeader>& found, bool is_light);
  // No file: pixels that were calculated, finite.
  TextureFile(std::string name, TexelArray texels);

  [[nodiscard]] const std::string& path() const { return path_; }
  // Why it is broken: a sentence that begins with its path in quotes.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  // Magenta since its header could not be read or, as texels() finds out, its pixels.
  [[nodiscard]] bool is_broken() const { return is_broken_; }
  // What the header says; decodes nothing.
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int channels() const { return channels_; }
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] bool holds_floats() const {
    return type_ == SampleType::Half || type_ == SampleType::Float;
  }

  // Decodes at the first call; any number of threads may call at once.
  const TexelArray& texels();
  [[nodiscard]] bool is_decoded() const { return is_decoded_.load(std::memory_order_acquire); }
  // Of CPU time, what decoding took; 0 before.
  [[nodiscard]] double decoding_seconds() const { return is_decoded() ? decoding_seconds_ : 0; }
  // What was wrong with pixels whose header was fine. Empty until decoded.
  [[nodiscard]] Diagnostics decoding_diagnostics() const;
  // The largest of all samples, of whole numbers the largest that there is. Decodes floats.
  [[nodiscard]] float largest();
  // Builds the tree of a channel at the first call. `channel` < channels of texels().
  const RangeTree& range_tree(int channel);

 private:
  void decode();
  void decode_file();
  void become_magenta();
  void remove_negative();

  std::string path_;
  SourceSpan span_;
  bool is_broken_ = false;
  std::string complaint_;
  int width_ = 1;
  int height_ = 1;
  int channels_ = 4;
  SampleType type_ = SampleType::U8;
  bool is_light_ = false;

  std::once_flag decode_once_;
  std::atomic<bool> is_decoded_{false};
  double decoding_seconds_ = 0;
  TexelArray texels_;
  Diagnostics diagnostics_;
  std::array<std::once_flag, 4> range_once_;
  std::array<RangeTree, 4> range_trees_;
};

}  // namespace candela
