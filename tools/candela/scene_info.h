// What is in a scene, for `candela info`.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/scene/scene.h"

namespace candela::cli {

struct TextureRow {
  std::string path;
  int width = 0;  // 0: never opened
  int height = 0;
  int channels = 0;
  std::size_t bytes = 0;    // in memory once decoded
  bool is_used = false;     // shading or visibility can read it
  bool is_decoded = false;  // compiling had to look at its pixels
};

// Coefficients a unit of the file's length.
struct MediumRow {
  std::string name;
  Vec3d absorption{0.0};
  Vec3d scattering{0.0};
  double asymmetry = 0;
};

struct SceneInfo {
  std::string path;
  std::string scene_hash;
  std::uint64_t triangles = 0;            // stored
  std::uint64_t instanced_triangles = 0;  // seen by rays: each instance counted
  std::uint64_t spheres = 0;              // stored
  std::uint64_t geometries = 0;
  std::uint64_t instances = 0;
  std::uint64_t cameras = 0;
  std::vector<std::string> materials;
  std::vector<MediumRow> media;
  std::vector<TextureRow> textures;
  std::map<std::string, std::uint64_t> lights;  // by kind
  std::uint64_t light_cells = 0;                // by which they are picked; 0: by power alone
  Vec3d bounds_min{0.0};                        // file units
  Vec3d bounds_max{0.0};
  std::size_t mesh_bytes = 0;
  std::size_t texture_bytes = 0;  // once all used ones are decoded
  std::optional<std::size_t> accelerator_bytes;
  std::string accelerator;
  std::vector<Dropped> dropped;
  std::string kernel;
  // That rays are tested against one by one; no faces: they go down a tree.
  std::size_t faces = 0;
  std::size_t listed_spheres = 0;
  std::size_t boxes = 0;  // around the rest, which has a tree; 0: there is no rest
};

[[nodiscard]] SceneInfo describe_scene(const description::SceneDescription& description,
                                       const Scene& scene);
[[nodiscard]] std::string to_text(const SceneInfo& info);

}  // namespace candela::cli
