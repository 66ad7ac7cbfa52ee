// What holds for every model a reader hands back, whatever the file was.
#pragma once

#include <string>

#include "scene_io/obj/map_images.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {

inline std::string fault_of(const description::Mesh& mesh, std::size_t material_count) {
  const std::size_t count = mesh.positions.size();
  for (const Vec3d& p : mesh.positions) {
    if (!is_finite(p)) return "a position is not finite";
  }
  for (const Vec3f& n : mesh.normals) {
    if (!is_finite(n)) return "a normal is not finite";
  }
  if (!mesh.normals.empty() && mesh.normals.size() != count) return "wrong count of normals";
  if (!mesh.uvs.empty() && mesh.uvs.size() != count) return "wrong count of uvs";
  if (mesh.triangles.empty()) return "no triangles";
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= count) return "a vertex is out of range";
    }
  }
  for (const description::MaterialHandle material : mesh.materials) {
    if (material.index >= material_count) return "a material is out of range";
  }
  return "";
}

// "" where all is well.
inline std::string fault_of(ObjModel& model) {
  for (const description::Mesh& mesh : model.meshes) {
    if (std::string fault = fault_of(mesh, model.materials.size()); !fault.empty()) return fault;
  }
  std::string fault;
  for (description::Material& material : model.materials) {
    for_each_image(material, [&](description::ImageHandle image) {
      if (image && image.index >= model.images.size()) fault = "an image is out of range";
    });
    if (!is_finite(material.emission)) fault = "emission is not finite";
  }
  return fault;
}

}  // namespace candela::obj
