#include "scene_io/pbrt/media_presets.h"

#include <algorithm>
#include <array>

namespace candela::pbrt {
namespace {

const std::array<MediumPreset, 12> presets{{
    {"Apple", {2.29, 2.39, 1.97}, {.0030, .0034, .046}},
    {"Chicken1", {.15, .21, .38}, {.015, .077, .19}},
    {"Chicken2", {.19, .25, .32}, {.018, .088, .20}},
    {"Cream", {7.38, 5.47, 3.15}, {.0002, .0028, .0163}},
    {"Ketchup", {.18, .07, .03}, {.061, .97, 1.45}},
    {"Marble", {2.19, 2.62, 3.00}, {.0021, .0041, .0071}},
    {"Potato", {.68, .70, .55}, {.0024, .0090, .12}},
    {"Skimmilk", {.70, 1.22, 1.90}, {.0014, .0025, .0142}},
    {"Skin1", {.74, .88, 1.01}, {.032, .17, .48}},
    {"Skin2", {1.09, 1.59, 1.79}, {.013, .070, .145}},
    {"Spectralon", {11.6, 20.4, 14.9}, {.00, .00, .00}},
    {"Wholemilk", {2.55, 3.21, 3.77}, {.0011, .0024, .014}},
}};

}  // namespace

std::optional<MediumPreset> medium_preset(std::string_view name) {
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [&](const MediumPreset& preset) { return preset.name == name; });
  if (found == presets.end()) return std::nullopt;
  return *found;
}

std::vector<std::string_view> medium_preset_names() {
  std::vector<std::string_view> names;
  for (const MediumPreset& preset : presets) names.push_back(preset.name);
  return names;
}

}  // namespace candela::pbrt
