// What is behind a handle of a TextureStore.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "renderer/texture/procedural.h"
#include "renderer/texture/texel_filter.h"
#include "renderer/texture/texel_slope.h"
#include "renderer/texture/texels.h"
#include "renderer/texture/texture.h"

namespace candela {

// One way to look into one file, or a procedural texture.
class Texture {
 public:
  Texture(const Procedural& procedural, const TextureInfo& info)
      : is_ready_(true),
        is_special_(true),
        procedural_(std::make_unique<const Procedural>(procedural)),
        info_(info) {}
  Texture(TextureFile& file, Encoding encoding, Wrap wrap)
      : file_(&file), encoding_(encoding), wrap_(wrap) {
    info_ = {file.width(), file.height(), file.channels(), file.channels() % 2 == 0, file.bytes()};
  }

  [[nodiscard]] bool is_image() const { return file_ != nullptr; }
  [[nodiscard]] TextureFile& file() const { return *file_; }
  [[nodiscard]] Wrap wrap() const { return wrap_; }
  [[nodiscard]] Encoding encoding() const { return encoding_; }
  [[nodiscard]] const TextureInfo& info() const { return info_; }

  // Whether every lookup gives the first texel.
  [[nodiscard]] bool is_single_texel(const TexelArray& texels) const {
    if (encoding_ == Encoding::LabGamma && (texels.width == 1 || texels.height == 1)) return true;
    return texels.width == 1 && texels.height == 1 && wrap_ != Wrap::Black;
  }

  [[nodiscard]] Vec4f texel(int x, int y) {
    decode();
    if (is_special_) return constant_;
    // A file may have fewer pixels than its header said when it was added.
    const int column = std::min(x, view_.width - 1);
    const int row = std::min(y, view_.height - 1);
    return filters_.all(view_, {{column, column, 0}, {row, row, 0}});
  }
  [[nodiscard]] std::vector<Vec4f> texels(int row) {
    decode();
    std::vector<Vec4f> texels(static_cast<std::size_t>(info_.width), constant_);
    if (is_special_) return texels;
    const std::span stored(texels.data(),
                           static_cast<std::size_t>(std::min(info_.width, view_.width)));
    filters_.row(view_, std::min(row, view_.height - 1), stored);
    std::fill(texels.begin() + static_cast<std::ptrdiff_t>(stored.size()), texels.end(),
              stored.back());
    return texels;
  }

  // Inputs of procedural textures are in `store`. `at`: all of the point, or null where only uv is
  // known.
  [[nodiscard]] Vec4f lookup(const TextureStore& store, Vec2f uv, const TexturePoint* at) {
    decode();
    if (is_special_) return special(store, uv, at);
    return filters_.all(view_, footprint_of(uv, view_.width, view_.height, wrap_));
  }

  [[nodiscard, gnu::always_inline]] TextureStore::Stored lookup_stored(const TextureStore& store,
                                                                       Vec2f uv,
                                                                       const TexturePoint* at) {
    decode();
    if (is_special_) return {special(store, uv, at), false};
    return {filters_.before_gamma(view_, footprint_of(uv, view_.width, view_.height, wrap_)),
            encoding_ == Encoding::LabGamma};
  }

  [[nodiscard]] std::optional<Vec2f> slope(Vec2f uv) {
    decode();
    if (is_special_ || slope_ == nullptr) return {};
    return slope_(view_, uv);
  }

  void prefetch(Vec2f uv) const {
    if (!is_ready_.load(std::memory_order_acquire) || is_at_hand_) return;
    const auto [column, row] = footprint_of(uv, view_.width, view_.height, wrap_);
    for (const std::int32_t y : {row.first, row.second}) {
      const std::ptrdiff_t texel = std::ptrdiff_t{y} * view_.width + column.first;
      if (texel < 0) continue;
      __builtin_prefetch(view_.samples + static_cast<std::size_t>(texel) * texel_bytes_);
    }
  }

  [[nodiscard]] float lookup_alpha(const TextureStore& store, const TexturePoint& at) {
    decode();
    if (is_special_) return special(store, at.uv, &at).w;
    return filters_.alpha(view_, footprint_of(at.uv, view_.width, view_.height, wrap_));
  }

  [[nodiscard]] bool is_by_place(const TextureStore& store) const {
    if (!procedural_) return false;
    return procedural_->is_by_place() ||
           std::any_of(procedural_->inputs.begin(), procedural_->inputs.end(),
                       [&](const TextureValue& input) {
                         return input.texture && store.is_by_place(input.texture);
                       });
  }

  // What lookups do first, and what else they may look into.
  void decode() {
    if (!is_ready_.load(std::memory_order_acquire)) prepare();
  }
  [[nodiscard]] std::span<const TextureValue> inputs() const {
    if (!procedural_) return {};
    return procedural_->inputs;
  }

 private:
  // Of what is no image of several texels.
  [[nodiscard]] Vec4f special(const TextureStore& store, Vec2f uv, const TexturePoint* at) const {
    if (!procedural_) return constant_;
    return evaluate_procedural(*procedural_, store, at != nullptr ? *at : TexturePoint{.uv = uv});
  }
  void prepare() {
    std::call_once(prepare_once_, [this] {
      const TexelArray& texels = file_->texels();
      view_ = {texels.samples.get(), texels.width, texels.height};
      texel_bytes_ = static_cast<std::size_t>(texels.channels) * size_of(texels.type);
      filters_ = texel_filters(texels.type, texels.channels, encoding_, wrap_ == Wrap::Black);
      slope_ = slope_filter(texels.type, texels.channels, encoding_, wrap_);
      is_special_ = is_single_texel(texels);
      constexpr std::size_t most_at_hand = 1 << 16;  // of a processor's second cache a small part
      is_at_hand_ = is_special_ || file_->bytes() <= most_at_hand;
      if (is_special_) constant_ = filters_.all(view_, Footprint{});
      is_ready_.store(true, std::memory_order_release);
    });
  }

  TextureFile* file_ = nullptr;
  std::atomic<bool> is_ready_{false};
  bool is_special_ = false;  // a constant, or procedural
  bool is_at_hand_ = true;   // nothing that memory would have to be asked for
  Encoding encoding_ = Encoding::Linear;
  Wrap wrap_ = Wrap::Repeat;
  TexelView view_;
  std::size_t texel_bytes_ = 0;
  TexelFilters filters_;
  SlopeFilter slope_ = nullptr;
  Vec4f constant_{0};
  std::unique_ptr<const Procedural> procedural_;
  TextureInfo info_;
  std::once_flag prepare_once_;
};

}  // namespace candela
