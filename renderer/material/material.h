// Compiled materials: constants in linear colour and handles of textures, one flat struct.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "renderer/geometry/geometry.h"
#include "renderer/math/vec.h"
#include "renderer/texture/texture.h"

namespace candela {

using description::FresnelModel;
using description::GeometryModel;

class CoatTable;
class CoatedMetalTable;
class CoverageGrid;

enum class MaterialModel : std::uint8_t {
  Diffuse,         // kd / pi
  CookTorrance,    // kd / pi + ks F G D / (4 cos cos)                         [REPORT 2.2]
  Lab,             // Blinn-Phong as GGX with a reciprocally coupled diffuse
  Mirror,          // delta reflection, constant reflectance
  Conductor,       // smooth (delta) or rough GGX with eta and k
  Dielectric,      // smooth (delta) or rough GGX, reflection and refraction
  ThinDielectric,  // both interfaces at once, straight through
  DiffuseTransmission,
  CoatedDiffuse,
  CoatedConductor,
  Mix,  // at each hit one of its parts: mixed_material.h
};

// See plain_model.h. CookTorrance: with Schlick's two terms; SmithCookTorrance: with his Fresnel
// term and Smith's masking. Conductor, CoatedDiffuse: rough ones. Glass: smooth.
enum class PlainModel : std::uint8_t {
  None,
  Diffuse,
  CookTorrance,
  SmithCookTorrance,
  Lab,
  Conductor,
  CoatedDiffuse,
  Mirror,
  Glass,
};
// Of those whose lobes are all delta: light samples find nothing there.
[[nodiscard]] constexpr bool is_only_delta(PlainModel model) {
  return model == PlainModel::Mirror || model == PlainModel::Glass;
}

// Whether light may pass to the other side.
[[nodiscard]] constexpr bool is_transmissive(MaterialModel model) {
  return model == MaterialModel::Dielectric || model == MaterialModel::ThinDielectric ||
         model == MaterialModel::DiffuseTransmission;
}

// A texture replaces its constant.
struct ColourParameter {
  Rgb constant{1};
  TextureHandle texture;
};
struct ScalarParameter {
  float constant = 1;
  TextureHandle texture;
  int channel = 0;
};

struct Material {
  MaterialModel model = MaterialModel::Diffuse;
  FresnelModel fresnel = FresnelModel::Schlick;
  GeometryModel geometry = GeometryModel::SchlickGgx;
  bool emits_both_sides = false;
  bool energy_compensation = false;   // CookTorrance with Smith's geometry, Conductor
  bool fresnel_is_conductor = false;  // CookTorrance: exact Fresnel by eta, k (else by ior)

  ColourParameter diffuse{Rgb{0}, {}};   // kd; Mirror: reflectance
  ColourParameter specular{Rgb{0}, {}};  // ks; Lab with a map: alpha * 256 is the exponent
  ScalarParameter roughness{0, {}, 0};   // GGX width a; Lab: from the exponent at compile time
  ScalarParameter roughness_across{0, {}, 0};  // along dp/dv, where is_anisotropic
  bool is_anisotropic = false;                 // there are two of them
  bool follows_tangents = false;               // some lobe has two widths: frames follow dp/du
  float shininess = 0;                         // Lab: the exponent itself, for whitted
  Rgb f0{0.04f};
  Rgb eta{1.5f};  // Dielectric: all channels alike
  Rgb k{0};
  Rgb transmittance{1};
  // Coated models; `roughness` is the coat's. Shared by materials that are coated alike.
  std::shared_ptr<const CoatTable> coat = nullptr;
  std::shared_ptr<const CoatedMetalTable> metal = nullptr;
  ScalarParameter metal_roughness{0, {}, 0};         // CoatedConductor: of the metal
  ScalarParameter metal_roughness_across{0, {}, 0};  // along dp/dv
  int coat_bounces = 0;  // how often light may leave the surface below; 0: no limit
  // Mix: the second of two materials of the scene with the probability `amount`.
  std::array<MaterialHandle, 2> parts{};
  ScalarParameter amount{0.5f, {}, 0};
  Rgb emission{0};                    // radiance
  TextureHandle emission_map{};       // a factor of it by place
  ScalarParameter opacity{1, {}, 3};  // in [0,1]
  bool lab_opacity = false;           // the lab's thresholds 0.2 and 0.9
  // Where the opacity map need not be asked; absent where visibility never asks it.
  Handle<CoverageGrid> coverage_grid{};
  TextureHandle height{};  // bump
  float height_scale = 1;  // see description::Material; lengths are in the scene's own unit
  bool heights_are_lengths = false;
  TextureHandle normal_map{};
  bool normal_map_is_right_handed = false;
  bool reads_uv = false;        // all but the opacity, of its parts, too
  bool reads_tangents = false;  // dp/du and dp/dv; of its parts, too

  [[nodiscard]] bool is_emissive() const { return !is_black(emission); }
};

}  // namespace candela
