#include "scene_io/pbrt/named_spectra.h"

namespace candela::pbrt {
namespace {

// Measured spectra of n and k (gold, silver, copper [Johnson72]) as metal_of_spectra() has them;
// those of brass averaged with the CIE's colour matching functions, in linear Rec.709 with a
// constant spectrum as (1, 1, 1).
const NamedMetal metals[] = {
    {"metal-Ag-eta", "metal-Ag-k", {0.1285, 0.1236, 0.1509}, {4.0947, 3.3263, 2.4079}},
    {"metal-Al-eta", "metal-Al-k", {1.4073, 0.9266, 0.5841}, {7.6838, 6.5958, 5.3309}},
    {"metal-Au-eta", "metal-Au-k", {0.0795, 0.4066, 1.5595}, {56.3923, 2.3388, 1.7195}},
    {"metal-Cu-eta", "metal-Cu-k", {0.1071, 0.9772, 1.2047}, {2.861, 2.6244, 2.3604}},
    {"metal-CuZn-eta", "metal-CuZn-k", {0.4314, 0.5151, 1.1465}, {3.5945, 2.687, 1.7516}},
    {"metal-MgO-eta", "metal-MgO-k", {1.7337, 1.741, 1.7535}, {0.0, 0.0, 0.0}},
    {"metal-TiO2-eta", "metal-TiO2-k", {2.8603, 2.9567, 3.1854}, {0.0047, 0.0333, 0.0217}},
};

// [Schott] n_d.
const NamedGlass glasses[] = {
    {"glass-BK7", 1.5168},    {"glass-BAF10", 1.67003}, {"glass-FK51A", 1.48656},
    {"glass-LASF9", 1.85025}, {"glass-SF5", 1.67271},   {"glass-SF10", 1.72825},
    {"glass-SF11", 1.78472},  {"glass-F5", 1.67271},    {"glass-F10", 1.72825},
    {"glass-F11", 1.78472},
};

// [CIE15], table T.3 and section 3.1.
const NamedIlluminant illuminants[] = {
    {"stdillum-A", 0.44758, 0.40745},   {"stdillum-D50", 0.34567, 0.35851},
    {"stdillum-D65", 0.31272, 0.32903}, {"stdillum-F1", 0.3131, 0.3371},
    {"stdillum-F2", 0.3721, 0.3751},    {"stdillum-F3", 0.4091, 0.3941},
    {"stdillum-F4", 0.4402, 0.4031},    {"stdillum-F5", 0.3138, 0.3452},
    {"stdillum-F6", 0.3779, 0.3882},    {"stdillum-F7", 0.3129, 0.3292},
    {"stdillum-F8", 0.3458, 0.3586},    {"stdillum-F9", 0.3741, 0.3727},
    {"stdillum-F10", 0.3458, 0.3588},   {"stdillum-F11", 0.3805, 0.3769},
    {"stdillum-F12", 0.4370, 0.4042},   {"illum-acesD60", 0.32168, 0.33767},
};

}  // namespace

std::span<const NamedMetal> named_metals() {
  return metals;
}
std::span<const NamedGlass> named_glasses() {
  return glasses;
}
std::span<const NamedIlluminant> named_illuminants() {
  return illuminants;
}

std::vector<std::string_view> spectrum_names() {
  std::vector<std::string_view> names;
  for (const NamedMetal& metal : metals) {
    names.push_back(metal.eta_name);
    names.push_back(metal.k_name);
  }
  for (const NamedGlass& glass : glasses) names.push_back(glass.name);
  for (const NamedIlluminant& illuminant : illuminants) names.push_back(illuminant.name);
  return names;
}

}  // namespace candela::pbrt
