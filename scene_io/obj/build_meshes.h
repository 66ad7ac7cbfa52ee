// The faces of an OBJ file -> meshes.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/description/scene_description.h"
#include "scene_io/obj/obj_data.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {

// A stretch of faces of one chunk between two switches.
struct FaceRun {
  const Chunk* chunk = nullptr;
  std::uint32_t face_begin = 0, face_end = 0;
  std::uint32_t corner_begin = 0;
  std::uint32_t shape = 0;  // 0 for all where shapes do not matter
};

// What one mesh will be made of.
struct MeshPlan {
  std::optional<std::uint32_t> material;  // index into the file's materials
  std::vector<FaceRun> runs;
  std::size_t face_count = 0;
};

// The material that a name means; nothing, after having said so, where there is none.
using MaterialOfName = std::function<std::optional<std::uint32_t>(std::string_view name)>;

// One plan for the whole file, with its shapes told apart.
[[nodiscard]] MeshPlan plan_whole(const ObjData& data);

// One plan for each of `material_count` materials, and a last one for faces without; some may have
// no faces.
[[nodiscard]] std::vector<MeshPlan> plan_by_material(const ObjData& data,
                                                     std::size_t material_count,
                                                     const MaterialOfName& material_of_name);

// Where the plan's first face stands in the file.
[[nodiscard]] std::size_t first_offset(const MeshPlan& plan);

struct BuiltMesh {
  description::Mesh mesh;  // without name, span and material
  std::size_t bow_count = 0;
  std::size_t first_bow_offset = 0;
};

[[nodiscard]] BuiltMesh build_mesh(const ObjData& data, const MeshPlan& plan,
                                   bool smooth_missing_normals);

}  // namespace candela::obj
