#include "integrators/path/surface_lanes.h"

#include "integrators/path/reflectance_lanes.h"
#include "renderer/material/bump.h"

namespace candela {
namespace {

[[nodiscard]] TexturePoint texture_point_of(const PlainLanes& lanes, std::uint32_t slot) {
  return {lanes.bsdfs.uv[slot], lanes.met.position[slot], lanes.met.normal[slot]};
}

// Where surfaces have bumps. What textures say is looked up one path after the other, once it is
// known where they are.
void put_bumps(const Scene& scene, PlainLanes& lanes) {
  MetLanes& met = lanes.met;
  for_each_lane(lanes.filled, [&](std::uint32_t slot) {
    const Material& material = *lanes.bsdfs.material[slot];
    if (!has_bump(material)) return;
    const Geometry& geometry = scene.geometries[met.geometry[slot]];
    const bool is_instanced = (met.instanced >> slot & 1) != 0;
    SurfacePoint point;
    if (!geometry.uvs.empty())
      set_tangents(geometry, geometry.triangles[met.triangle[slot]],
                   is_instanced ? met.instance[slot] : nullptr, point);
    met.front_normal.set(slot,
                         shading_normal_at(material, scene.textures, texture_point_of(lanes, slot),
                                           met.front_normal[slot], point.dpdu, point.dpdv));
    met.is_flat[slot] = 0;
    met.all_are_flat = false;
  });
}

// `put(slot, material, at)` for each path.
template <class Put>
void for_each_material(const PlainLanes& lanes, const Put& put) {
  for_each_lane(lanes.filled, [&](std::uint32_t slot) {
    put(slot, *lanes.bsdfs.material[slot], texture_point_of(lanes, slot));
  });
}

// The colour of the diffuse lobe. Says whether it lacks the lab's gamma, which comes for all paths
// at once (decode_reflectance()).
inline bool put_diffuse(const Material& material, const TextureStore& textures,
                        const TexturePoint& at, std::uint32_t slot, Vec3Lanes& diffuse) {
  if (!material.diffuse.texture) {
    diffuse.set(slot, material.diffuse.constant);
    return false;
  }
  const auto [value, lacks_gamma] = textures.lookup_stored_at(material.diffuse.texture, at);
  diffuse.set(slot, lacks_gamma ? Rgb(value) : clamp_unit(Rgb(value)));
  return lacks_gamma;
}

void put_colours(const TextureStore& textures, PlainLanes& lanes) {
  Vec3Lanes& diffuse = lanes.bsdfs.diffuse;
  LaneMask lacks_gamma = 0;
  for_each_material(lanes, [&](std::uint32_t slot, const Material& material, const auto& at) {
    if (put_diffuse(material, textures, at, slot, diffuse)) lacks_gamma |= 1u << slot;
  });
  if (lacks_gamma != 0) decode_reflectance(lacks_gamma, diffuse);
}

// `bsdf_at`: with any colour of the diffuse lobe.
template <class BsdfAt>
void put_highlights(const BsdfAt& bsdf_at, const TextureStore& textures, PlainLanes& lanes) {
  BsdfLanes& bsdfs = lanes.bsdfs;
  LaneMask lacks_gamma = 0;
  for_each_material(lanes, [&](std::uint32_t slot, const Material& material, const auto& at) {
    if (put_diffuse(material, textures, at, slot, bsdfs.diffuse)) lacks_gamma |= 1u << slot;
    const Bsdf bsdf = bsdf_at(material, at);
    bsdfs.specular.set(slot, bsdf.specular);
    bsdfs.f0.set(slot, bsdf.f0);
    bsdfs.alpha[slot] = bsdf.alpha;
  });
  if (lacks_gamma != 0) decode_reflectance(lacks_gamma, bsdfs.diffuse);
}

void put_metals(const TextureStore& textures, PlainLanes& lanes) {
  BsdfLanes& bsdfs = lanes.bsdfs;
  for_each_material(lanes, [&](std::uint32_t slot, const Material& material, const auto& at) {
    const MetalIndex metal = metal_index_at(material, textures, at);
    bsdfs.eta.set(slot, metal.eta);
    bsdfs.k.set(slot, metal.k);
    bsdfs.alpha[slot] = ggx_width(material.roughness.constant);
  });
}

void put_coats(const TextureStore& textures, PlainLanes& lanes) {
  BsdfLanes& bsdfs = lanes.bsdfs;
  for_each_material(lanes, [&](std::uint32_t slot, const Material& material, const auto& at) {
    const Bsdf bsdf = coated_diffuse_at(material, textures, at);
    const float cos_o = dot(-lanes.met.direction[slot], lanes.met.shading_normal[slot]);
    bsdfs.diffuse.set(slot, bsdf.diffuse);
    bsdfs.alpha[slot] = bsdf.alpha;
    bsdfs.coat_eta[slot] = bsdf.coat->eta();
    bsdfs.transmittance_o[slot] = bsdf.coat->transmittance(cos_o, bsdf.alpha);
    bsdfs.mean_transmittance[slot] = bsdf.coat->mean_transmittance(bsdf.alpha);
  });
}

void put_glass(const TextureStore& textures, PlainLanes& lanes) {
  BsdfLanes& bsdfs = lanes.bsdfs;
  for_each_material(lanes, [&](std::uint32_t slot, const Material& material, const auto& at) {
    const Bsdf bsdf = dielectric_at(material, textures, at, lanes.met.is_front[slot] != 0);
    bsdfs.eta.set(slot, bsdf.eta);
    bsdfs.transmittance.set(slot, bsdf.transmittance);
  });
}

void put_bsdfs(PlainModel model, const TextureStore& textures, PlainLanes& lanes) {
  switch (model) {
    case PlainModel::Diffuse:
    case PlainModel::Mirror:
      return put_colours(textures, lanes);
    case PlainModel::CookTorrance:
    case PlainModel::SmithCookTorrance:
      put_highlights(
          [&](const Material& material, const TexturePoint& at) {
            return unlimited_cook_torrance_at(material, textures, at, Rgb(0));
          },
          textures, lanes);
      return limit_reflectances(lanes.bsdfs.diffuse, lanes.bsdfs.specular);
    case PlainModel::Lab:
      return put_highlights(
          [&](const Material& material, const TexturePoint& at) {
            return lab_at(material, textures, at, Rgb(0));
          },
          textures, lanes);
    case PlainModel::Conductor:
      return put_metals(textures, lanes);
    case PlainModel::CoatedDiffuse:
      return put_coats(textures, lanes);
    case PlainModel::Glass:
      return put_glass(textures, lanes);
    case PlainModel::None:
      break;
  }
}

}  // namespace

void find_surfaces(PlainModel model, const Scene& scene, PlainLanes& lanes) {
  find_points(lanes);
  if (scene.features.bump) put_bumps(scene, lanes);
  find_frames(lanes);
  put_bsdfs(model, scene.textures, lanes);
}

}  // namespace candela
