// Words of candela's own parameters in pbrt files, for those who write them and those who read
// them.
#pragma once

namespace candela::pbrt::own {

// "string model" of materials.
inline constexpr const char* lab = "lab";
inline constexpr const char* mirror = "mirror";
inline constexpr const char* cook_torrance = "cooktorrance";

// "string cooktorrance.fresnel" and "string cooktorrance.geometry", in place of Schlick's.
inline constexpr const char* exact = "exact";
inline constexpr const char* smith = "smith";

}  // namespace candela::pbrt::own
