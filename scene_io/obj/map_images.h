// Every image handle of a material, for renumbering.
#pragma once

#include <variant>

#include "renderer/description/scene_description.h"

namespace candela::obj {

template <class Visit>
void for_each_image(description::LabMaterial& m, const Visit& visit) {
  visit(m.diffuse.map);
  visit(m.specular.map);
}
template <class Visit>
void for_each_image(description::CookTorranceMaterial& m, const Visit& visit) {
  visit(m.diffuse.map);
  visit(m.specular.map);
  visit(m.roughness.map);
}
template <class Visit>
void for_each_image(description::DiffuseMaterial& m, const Visit& visit) {
  visit(m.reflectance.map);
}
template <class Visit>
void for_each_image(description::MirrorMaterial& m, const Visit& visit) {
  visit(m.reflectance.map);
}
template <class Visit>
void for_each_image(description::ConductorMaterial& m, const Visit& visit) {
  visit(m.roughness.map);
}
template <class Visit>
void for_each_image(description::DielectricMaterial& m, const Visit& visit) {
  visit(m.roughness.map);
}

// Models that no MTL file makes.
template <class Visit>
void for_each_image(description::CoatedDiffuseMaterial& m, const Visit& visit) {
  visit(m.reflectance.map);
  visit(m.coat.roughness.map);
}
template <class Visit>
void for_each_image(description::CoatedConductorMaterial& m, const Visit& visit) {
  visit(m.roughness.map);
  visit(m.coat.roughness.map);
}
template <class Visit>
void for_each_image(description::DiffuseTransmissionMaterial& m, const Visit& visit) {
  visit(m.reflectance.map);
  visit(m.transmittance.map);
}
template <class Visit>
void for_each_image(description::InterfaceMaterial&, const Visit&) {}
template <class Visit>
void for_each_image(description::MixMaterial& m, const Visit& visit) {
  visit(m.amount.map);
}

// Calls visit(ImageHandle&) for each, valid or not.
template <class Visit>
void for_each_image(description::Material& material, const Visit& visit) {
  std::visit([&](auto& model) { for_each_image(model, visit); }, material.model);
  visit(material.emission_map);
  visit(material.opacity.map);
  visit(material.height);
  visit(material.normal_map);
}

}  // namespace candela::obj
