// Wavefront OBJ with its MTL -> meshes and materials of a SceneDescription.
//
// Meshes. MtlUse::Ignore: one mesh a file, vertices unique per (v, vt, vn) within each shape (every
// `g` or `o` starts one), so that computed normals do not smooth across shapes. Otherwise one mesh
// for each MTL material that has faces, in the order of the MTL, vertices unique per (v, vt, vn)
// within it. If any corner of a mesh lacks a normal, all its normals are computed: the sum of the
// cross products of the triangles that share a vertex (area-weighted). If any lacks a texture
// coordinate, all are (.5, .5). (docs/scene_format.md, "Meshes")
//
// Polygons are triangulated (scene_io/mesh/triangulate.h); `l`, `p` and free-form statements are
// left out with one warning. v = 0 is the image's bottom row, as in the file. File names may use
// back-slashes and the wrong letter case. See read_mtl.h for what the materials become.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "scene_io/image_index.h"

namespace candela::obj {

enum class MtlUse : std::uint8_t {
  Ignore,  // the MTL is not opened
  Lab,     // as lab3's framework reads it; faces without a material are dropped with a warning
  Full,  // Ke, Ni, illum, Tf, map_d, -bm, norm, Pr, Pm count too; faces without a material are grey
};

struct ObjOptions {
  MtlUse materials = MtlUse::Lab;
  description::MaterialHandle material;  // of all faces with Ignore; with Full, of the faces that
                                         // have none (invalid: a grey one is added)
  bool smooth_missing_normals = true;    // false: such a mesh gets no normals at all
};

// What a file holds, apart from any scene: handles count from 0 within the model, and a mesh whose
// `materials` is empty waits for ObjOptions::material.
struct ObjModel {
  std::vector<description::Mesh> meshes;
  std::vector<description::Material> materials;
  std::vector<description::Image> images;
  std::vector<std::string> files;  // the OBJ and every MTL that was read
};

// Reads `path` (`.gz`: inflated) and its MTLs. Touches no scene, so several files may be read in
// parallel. After errors the model may be incomplete but its indices are valid.
[[nodiscard]] ObjModel read_obj(const std::string& path, const ObjOptions& options,
                                Diagnostics& diagnostics);

// The same with `text` in place of the bytes of the file; MTLs are still looked for beside `path`.
[[nodiscard]] ObjModel parse_obj(const std::string& path, std::string text,
                                 const ObjOptions& options, Diagnostics& diagnostics);

// Moves a model into the scene and returns the handles of its meshes, in order. Images that the
// scene has already (same path, encoding and wrap) are shared; nothing is instanced.
std::vector<description::MeshHandle> append_model(ObjModel&& model,
                                                  description::MaterialHandle material,
                                                  ImageIndex& images,
                                                  description::SceneDescription& scene);

// read_obj and append_model in one.
std::vector<description::MeshHandle> append_obj(const std::string& path, const ObjOptions& options,
                                                description::SceneDescription& scene,
                                                Diagnostics& diagnostics);

}  // namespace candela::obj
