// How the guide of a render is learned: from paths of its own, which the picture does not use.
#pragma once

#include <cstdint>

#include "integrators/guiding/guiding_field.h"
#include "integrators/kernel.h"
#include "integrators/render_options.h"

namespace candela {

// Camera samples of pixels all over the picture, whatever the crop: blocks of 16 of a pixel. Each
// iteration has as many as all before and is guided by what the last one taught
// [Mueller17, section 3.1].
class Training {
 public:
  // Keeps references. Learns no more once `is_over`.
  Training(const RenderOptions& options, const TileFunction& render_tile,
           const std::function<bool()>& is_over);

  // Goes on as long as no more samples than these are taken in all: the first time in three
  // iterations, of a quarter, a quarter and a half.
  void run_until(std::uint64_t samples);
  [[nodiscard]] std::uint64_t samples() const;
  [[nodiscard]] const GuidingField& field() const { return field_; }

 private:
  void iterate(std::uint32_t blocks);

  const RenderOptions& options_;
  const TileFunction& render_tile_;
  const std::function<bool()>& is_over_;
  TilePass settings_;
  GuidingField field_;
  std::uint32_t blocks_ = 0;  // so far
};

}  // namespace candela
