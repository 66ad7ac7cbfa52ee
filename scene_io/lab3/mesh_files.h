// The mesh files of a scene: each is read once, all in parallel, and placed as often as asked.
#pragma once

#include <string>
#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/math/transform.h"
#include "scene_io/load_options.h"

namespace candela::lab3 {

enum class MeshFormat : std::uint8_t { Unknown, Obj, Ply };

// By the name's extension, `.gz` after it or not, in any letter case.
[[nodiscard]] MeshFormat mesh_format_of(std::string_view path);

struct Placement {
  Transform object_to_world;
  SourceSpan span;
};

struct MeshRequest {
  std::string path;
  MeshFormat format = MeshFormat::Obj;
  bool has_own_materials = false;        // OBJ: by its MTL
  description::MaterialHandle material;  // else this one
  std::vector<Placement> placements;
};

class MeshFiles {
 public:
  void request(MeshRequest request) { requests_.push_back(std::move(request)); }

  // What each file had to say comes in the order of the requests, whichever was read first.
  void load_and_place(const LoadOptions& options, description::SceneDescription& scene,
                      Diagnostics& diagnostics) const;

 private:
  std::vector<MeshRequest> requests_;
};

}  // namespace candela::lab3
