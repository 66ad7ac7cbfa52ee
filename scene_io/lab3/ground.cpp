#include "scene_io/lab3/ground.h"

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "scene_io/lab3/assets.h"
#include "scene_io/lab3/fields.h"
#include "scene_io/text/file.h"
#include "scene_io/text/source.h"

namespace candela::lab3 {
namespace {

using description::MaterialHandle;
using description::MeshHandle;

constexpr double white_oak_height = -10;
constexpr float repeats_each_way = 15;

// Of the models' vertices.
std::optional<double> lowest_y(const description::SceneDescription& scene) {
  std::optional<double> lowest;
  for (const description::Instance& instance : scene.instances)
    for (const Vec3d& position : scene.meshes[instance.mesh.index].positions) {
      const double y = instance.object_to_world.point(position).y;
      if (!lowest || y < *lowest) lowest = y;
    }
  return lowest;
}

double height_of(const Reader& reader) {
  const std::filesystem::path path = text::without_gzip_extension(reader.scene.path);
  if (is_same_name(path.stem().string(), "white_oak")) return white_oak_height;
  return lowest_y(reader.scene).value_or(0);
}

// v counts from the picture's bottom row here and from its top row there: hence -z.
description::Mesh make_square(double half_size, double height, MaterialHandle material) {
  description::Mesh mesh;
  mesh.name = "lab3 ground";
  for (const Vec2f corner : {Vec2f(-1, -1), Vec2f(-1, 1), Vec2f(1, 1), Vec2f(1, -1)}) {
    mesh.positions.emplace_back(corner.x * half_size, height, corner.y * half_size);
    mesh.uvs.emplace_back(repeats_each_way * corner.x, -repeats_each_way * corner.y);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {material};
  return mesh;
}

}  // namespace

void add_ground(Reader& reader) {
  if (!reader.options.lab3_ground) return;
  const std::string& image = *reader.options.lab3_ground;
  const std::string problem = problem_of_file(image);
  if (!problem.empty()) {
    reader.diagnostics.error({}, fmt::format("--lab3-ground {}: {}", text::quoted(image), problem));
    return;
  }
  const double half_size = 0.5 * reader.z_far;
  if (half_size <= 0) {
    reader.diagnostics.error({},
                             "--lab3-ground: the ZFar of camera 0 gives the ground's size and "
                             "must be above 0");
    return;
  }
  description::SceneDescription& scene = reader.scene;
  description::LabMaterial picture;
  picture.diffuse.map = reader.images.add(
      {image, description::Encoding::LabGamma, description::Wrap::Repeat, {}}, scene);
  description::Material material;
  material.name = "lab3 ground";
  material.model = picture;
  scene.materials.push_back(std::move(material));
  const MaterialHandle handle(scene.materials.size() - 1);
  scene.meshes.push_back(make_square(half_size, height_of(reader), handle));
  scene.instances.push_back({MeshHandle(scene.meshes.size() - 1), {}, {}, {}});
}

}  // namespace candela::lab3
