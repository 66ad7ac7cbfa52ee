// A BSDF at a point, in the local shading frame (z is the shading normal on the side of wo).
// Directions point away from the surface. All densities are in solid angle.
#pragma once

#include <cstdint>

#include "renderer/math/vec.h"

namespace candela {

enum class BsdfModel : std::uint8_t {
  Diffuse,
  CookTorrance,
  Lab,
  Mirror,
  Conductor,
  Dielectric,
  ThinDielectric,
  CompensatedCookTorrance,  // with the light of multiple bounces; conductors, too
  DiffuseTransmission,
  CoatedDiffuse,
  CoatedConductor,
  AnisotropicConductor,
  AnisotropicDielectric,
};

class CoatTable;
class CoatedMetalTable;

enum class FresnelTerm : std::uint8_t { Schlick, Dielectric, Conductor };
enum class GeometryTerm : std::uint8_t { SchlickGgx, Smith };

// Parameters of one model at one point; which members count depends on the model.
struct Bsdf {
  BsdfModel model = BsdfModel::Diffuse;
  FresnelTerm fresnel = FresnelTerm::Schlick;
  GeometryTerm geometry = GeometryTerm::SchlickGgx;
  bool is_smooth = false;  // conductors, coated or not, and dielectrics: all lobes are delta
  float alpha = 1;         // GGX width; 0: of a smooth coat
  Rgb diffuse{0};          // kd; Mirror: reflectance
  Rgb specular{0};         // ks
  Rgb f0{0.04f};
  Rgb eta{1.5f};  // relative index: below the surface over above it, seen from wo's side
  Rgb k{0};
  Rgb transmittance{1};
  // Anisotropic models and coats: the width along the frame's y, `alpha` being that along x.
  float alpha_across = 1;
  const CoatTable* coat = nullptr;          // coated models
  const CoatedMetalTable* metal = nullptr;  // CoatedConductor; its lobe's widths:
  Vec2f metal_widths{1};
  int metal_bounces = 0;  // off the metal, at most; 0: no limit
};

// f(wo, wi) |cos(theta_i)| and the density with which sample_bsdf() would have chosen wi.
struct BsdfEvaluation {
  Rgb value{0};
  float pdf = 0;
};

struct BsdfSample {
  Vec3f wi{0};
  Rgb weight{0};  // f |cos| / pdf, or the delta lobe's weight; zero: the sample is rejected
  float pdf = 0;  // of wi over all lobes, by solid angle; 0 for delta lobes
  float eta = 1;  // refraction: index of wi's side over wo's side; 1 otherwise
  bool is_delta = false;
};

// Which models there may be: code that is given a set leaves the others out of its switches.
using ModelSet = std::uint32_t;
constexpr ModelSet model_bit(BsdfModel model) {
  return 1u << static_cast<unsigned>(model);
}
inline constexpr ModelSet all_models =
    2 * model_bit(BsdfModel::AnisotropicDielectric) - 1;  // the last

// The functions over these: is_only_delta, evaluate_bsdf and sample_bsdf in
// renderer/bsdf/dispatch.h, albedo_estimate in albedo.h.

}  // namespace candela
