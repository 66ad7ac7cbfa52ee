// Textures: image files kept in their own bit depth, decoded when a ray first needs them, looked up
// bilinearly; and textures made of them (procedural.h).
//
// uv: v = 0 is the image's bottom row, texel centres lie at (i + 0.5) / size. Any float is a valid
// coordinate (footprint.h).
//
// Encodings: Srgb and Gamma22 decode each texel before filtering, LabGamma filters stored values
// and takes the power then, as the lab does (which gives a texture of width or height 1 its texel
// (0, 0) everywhere). Values that are not finite become 0 or the largest half at decoding.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/base/handle.h"
#include "renderer/description/scene_description.h"
#include "renderer/math/vec.h"
#include "renderer/texture/procedural.h"

namespace candela {

using description::Encoding;
using description::Wrap;

// What the file's header says; read without decoding a pixel. Of procedural textures: a size whose
// texels are about as fine as what they show, and no bytes.
struct TextureInfo {
  int width = 0;
  int height = 0;
  int channels = 0;  // 1..4
  bool has_alpha = false;
  std::size_t bytes = 0;  // in memory once decoded
};

struct TexelArray;
class TextureFile;

// The scene's textures. Immutable but for this: a texture decodes itself once, on first touch, from
// whichever thread comes first. A texture whose file is missing or broken is magenta (1, 0, 1) with
// alpha 1; of what shines broken_lights() makes an error of it.
class TextureStore {
 public:
  TextureStore();
  TextureStore(TextureStore&&) noexcept;
  TextureStore& operator=(TextureStore&&) noexcept;
  ~TextureStore();

  // Checks the file's header; a missing, forbidden or unreadable file is a warning and a magenta
  // texture; codecs that it needs and that are missing are an error. Equal (path, encoding, wrap)
  // give equal handles, and equal paths share their pixels.
  TextureHandle add(const description::Image& image, Diagnostics& diagnostics);

  // The same of an image that shines, whose values below 0 are no light: they count as 0. Of one
  // that cannot be read broken_lights() tells.
  TextureHandle add_light(const description::Image& image, Diagnostics& diagnostics);

  // Errors about the images that shine and cannot be read, as far as they were decoded: magenta
  // light would be a picture that looks finished.
  [[nodiscard]] Diagnostics broken_lights() const;

  // An error where the largest value of an image that shines, times `factor`, is above `most`.
  void check_brightness(TextureHandle light, double factor, double most,
                        Diagnostics& diagnostics) const;

  // An image that was calculated: linear, already decoded, under a name for messages, no path.
  TextureHandle add(const std::string& name, TexelArray texels, Wrap wrap);

  // Its inputs are textures of this store.
  TextureHandle add(const Procedural& procedural);

  // Bilinear, decoded to linear by the texture's encoding (alpha is never decoded). Greyscale files
  // repeat their value in r, g, b; files without alpha have alpha 1. Values above 1 pass (HDR), and
  // so do negative ones of float files with Encoding::Linear. Colour is not premultiplied by alpha
  // but as the file stores it. Wrap::Black has alpha 0 outside where the file has alpha.
  // Of stored values NaN counts as 0 and infinity as the largest half, of light (add_light())
  // what is below 0 as 0; decoding_diagnostics() says how many there were.
  [[nodiscard]] Vec4f lookup(TextureHandle texture, Vec2f uv) const;
  // lookup() and lookup_at() but for an image's power of LabGamma, for callers that take that of
  // many at once.
  struct Stored {
    Vec4f value;
    bool lacks_gamma;  // power_2_2() of the colour is still to be taken
  };
  [[nodiscard]] Stored lookup_stored(TextureHandle image, Vec2f uv) const;
  [[nodiscard]] Stored lookup_stored_at(TextureHandle texture, const TexturePoint& at) const;
  // (d/du, d/dv) of lookup().x by central differences over one texel, where texels tell it at once
  // (texel_slope.h).
  [[nodiscard]] std::optional<Vec2f> slope(TextureHandle texture, Vec2f uv) const;
  // Asks the memory for what lookup() of the same place will read, and waits for nothing.
  void prefetch(TextureHandle texture, Vec2f uv) const;
  // The same of textures that may look at more than uv.
  [[nodiscard]] Vec4f lookup_at(TextureHandle texture, const TexturePoint& at) const;
  // lookup_at().w, without the work for colour.
  [[nodiscard]] float lookup_alpha_at(TextureHandle texture, const TexturePoint& at) const;
  // Whether it does.
  [[nodiscard]] bool is_by_place(TextureHandle texture) const;
  // One texel of an image, decoded to linear; row 0 is the file's first, 0 <= x < width, 0 <= y <
  // height. For tables that are built over all texels (environment maps), not for kernels.
  [[nodiscard]] Vec4f texel(TextureHandle texture, int x, int y) const;
  // All texels of a row, at a fraction of what one after the other takes.
  [[nodiscard]] std::vector<Vec4f> texels(TextureHandle texture, int row) const;

  // The smallest and largest stored value of `channel` (0..2 colour, 3: alpha; 1 where the file has
  // none) over all texels that a bilinear lookup within the triangle of uvs can touch; decodes.
  // Integers are in [0,1]. Conservative: may be wider than exact;
  // of procedural textures it is everything from 0 on.
  struct Range {
    float low = 0;
    float high = 1;
  };
  [[nodiscard]] Range range_in_triangle(TextureHandle texture, const Vec2f (&uv)[3],
                                        int channel) const;

  // The same by cells: one range for all lookups whose footprint (footprint.h) begins in one cell
  // of `cell_side` x `cell_side` texels, row by row. Without cells for Wrap::Black and
  // procedural textures. A texture that
  // is the same everywhere has the size 1x1.
  struct RangeGrid {
    int width = 1;  // in texels
    int height = 1;
    Wrap wrap = Wrap::Repeat;
    std::vector<Range> cells;
  };
  [[nodiscard]] RangeGrid range_grid(TextureHandle texture, int channel, int cell_side) const;

  // What an image is as one number (description::alpha_or_mean); decodes files of 2 to 4 channels.
  enum class ScalarKind : std::uint8_t { First, Alpha, Mean };  // First: all colours are equal
  [[nodiscard]] ScalarKind scalar_kind(TextureHandle texture) const;

  // Of images: whether the file holds floats. Decodes nothing.
  [[nodiscard]] bool may_exceed_one(TextureHandle texture) const;
  [[nodiscard]] const TextureInfo& info(TextureHandle texture) const;
  // Whether it is an image file and no procedural texture; only images have paths.
  [[nodiscard]] bool is_image(TextureHandle texture) const;
  [[nodiscard]] const std::string& path(TextureHandle texture) const;
  // Of images: how lookups decode.
  [[nodiscard]] Encoding encoding(TextureHandle texture) const;
  [[nodiscard]] std::size_t size() const;
  // Decodes what lookups of it would decode, its inputs' images too, so that they need no memory.
  void decode(TextureHandle texture) const;
  // Which have been decoded so far, and the bytes they hold.
  [[nodiscard]] bool is_decoded(TextureHandle texture) const;
  [[nodiscard]] std::size_t decoded_bytes() const;
  // The CPU time that decoding them took.
  [[nodiscard]] double decoding_seconds() const;
  // Warnings met while decoding (a file whose header was fine and whose pixels were not).
  [[nodiscard]] Diagnostics decoding_diagnostics() const;

 private:
  struct Files;  // pixels by path, and those that were calculated
  TextureFile& file_of(const description::Image& image, bool is_light, Diagnostics& diagnostics);
  TextureHandle add(TextureFile& file, const description::Image& image);

  std::vector<std::unique_ptr<Texture>> textures_;
  std::unique_ptr<Files> files_;
};

}  // namespace candela
