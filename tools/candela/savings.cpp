#include "tools/candela/savings.h"

#include "tools/candela/option_values.h"

namespace candela::cli {
namespace {

constexpr Choice<Saving> choices[] = {{"packets", Saving::Packets},
                                      {"high-quality", Saving::HighQuality},
                                      {"flushing", Saving::FlushedDenormals},
                                      {"large-pages", Saving::LargePages},
                                      {"shared-blocks", Saving::SharedBlocks},
                                      {"convoys", Saving::Convoys},
                                      {"background", Saving::Background},
                                      {"opacity-grids", Saving::OpacityGrids}};

constexpr SavingSet of_path = saving_bit(Saving::SharedBlocks) | saving_bit(Saving::Convoys) |
                              saving_bit(Saving::Background) | saving_bit(Saving::OpacityGrids);

}  // namespace

Result<SavingSet> parse_savings(std::string_view text) {
  SavingSet set = 0;
  for (const std::string_view name : split(text, ',')) {
    const Result<Saving> saving = choose("saving", name, std::span<const Choice<Saving>>(choices));
    if (!saving) return Diagnostics(saving.diagnostics);
    set |= saving_bit(*saving);
  }
  return SavingSet(set);
}

std::string savings_text(SavingSet set) {
  std::string text;
  for (const auto& [name, saving] : choices)
    if (has(set, saving)) text += (text.empty() ? "" : ",") + std::string(name);
  return text;
}

std::string_view saving_of_path(SavingSet set) {
  for (const auto& [name, saving] : choices)
    if (has(set & of_path, saving)) return name;
  return "";
}

EmbreeOptions without(SavingSet set, EmbreeOptions options) {
  options.packets = !has(set, Saving::Packets);
  options.high_quality = !has(set, Saving::HighQuality);
  return options;
}

PathSavings path_savings_without(SavingSet set) {
  return {.skips_background = !has(set, Saving::Background),
          .shares_blocks = !has(set, Saving::SharedBlocks),
          .has_convoys = !has(set, Saving::Convoys),
          .opacity_grids = !has(set, Saving::OpacityGrids)};
}

}  // namespace candela::cli
