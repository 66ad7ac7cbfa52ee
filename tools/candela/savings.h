// `--without LIST`: what makes a render cheaper and changes nothing of its picture (docs/cli.md,
// "Savings", has the exceptions), taken away for comparisons.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "integrators/render_options.h"
#include "renderer/accel/embree_accel.h"

namespace candela::cli {

enum class Saving : std::uint8_t {
  Packets,
  HighQuality,
  FlushedDenormals,
  LargePages,
  SharedBlocks,
  Convoys,
  Background,
  OpacityGrids
};

using SavingSet = std::uint32_t;
[[nodiscard]] constexpr SavingSet saving_bit(Saving saving) {
  return SavingSet{1} << static_cast<unsigned>(saving);
}
[[nodiscard]] constexpr bool has(SavingSet set, Saving saving) {
  return (set & saving_bit(saving)) != 0;
}

// "packets,convoys"; "" where there are none.
[[nodiscard]] std::string savings_text(SavingSet set);

// The first of the set that only path has, and that only Embree has; "" where there is none.
[[nodiscard]] std::string_view saving_of_path(SavingSet set);
[[nodiscard]] std::string_view saving_of_embree(SavingSet set);

[[nodiscard]] EmbreeOptions embree_options_without(SavingSet set, EmbreeOptions options);
[[nodiscard]] PathSavings path_savings_without(SavingSet set);

}  // namespace candela::cli
