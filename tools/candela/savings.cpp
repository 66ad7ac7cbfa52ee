#include "tools/candela/savings.h"

#include "tools/candela/option_values.h"

namespace candela::cli {
namespace {

constexpr SavingSet of_path = saving_bit(Saving::Packets) | saving_bit(Saving::SharedBlocks) |
                              saving_bit(Saving::Convoys) | saving_bit(Saving::Background);
constexpr SavingSet of_embree = saving_bit(Saving::Packets) | saving_bit(Saving::HighQuality);

// The first of a set; "" of none.
std::string_view first_name(SavingSet set) {
  for (const auto& [name, saving] : saving_choices())
    if (has(set, saving)) return name;
  return "";
}

}  // namespace

std::string savings_text(SavingSet set) {
  std::string text;
  for (const auto& [name, saving] : saving_choices())
    if (has(set, saving)) text += (text.empty() ? "" : ",") + std::string(name);
  return text;
}

std::string_view saving_of_path(SavingSet set) {
  return first_name(set & of_path);
}
std::string_view saving_of_embree(SavingSet set) {
  return first_name(set & of_embree);
}

EmbreeOptions embree_options_without(SavingSet set, EmbreeOptions options) {
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
