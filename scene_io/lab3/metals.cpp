#include "scene_io/lab3/metals.h"

#include <algorithm>
#include <iterator>

namespace candela::lab3 {
namespace {

// Interpolated linearly in wavelength between the rows of the published tables:
// gold, silver, copper [Johnson72]; chromium, iron, nickel, titanium [Johnson74];
// aluminium [Rakic95].
const Metal table[] = {
    {"gold", {0.188, 0.544, 1.332}, {3.403, 2.231, 1.869}},
    {"silver", {0.057, 0.054, 0.047}, {4.254, 3.429, 2.803}},
    {"copper", {0.275, 1.116, 1.247}, {3.373, 2.596, 2.456}},
    {"aluminium", {1.430, 0.939, 0.686}, {7.508, 6.420, 5.635}},
    {"aluminum", {1.430, 0.939, 0.686}, {7.508, 6.420, 5.635}},
    {"chromium", {3.145, 3.034, 2.456}, {3.312, 3.330, 3.210}},
    {"iron", {2.892, 2.895, 2.646}, {3.065, 2.918, 2.805}},
    {"nickel", {1.990, 1.877, 1.765}, {4.094, 3.495, 3.048}},
    {"titanium", {2.698, 2.479, 2.305}, {3.757, 3.351, 3.082}},
};

}  // namespace

std::span<const Metal> metals() {
  return table;
}

Metal metal_named(std::string_view name) {
  return *std::find_if(std::begin(table), std::end(table),
                       [&](const Metal& metal) { return metal.name == name; });
}

}  // namespace candela::lab3
