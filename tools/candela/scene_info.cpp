#include "tools/candela/scene_info.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/printable.h"

namespace candela::cli {
namespace {

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

// Lists that begin alike are stored once.
std::size_t bytes_of_triangles(const Scene& scene) {
  std::map<const TriangleCorners*, std::size_t> lists;
  for (const Geometry& geometry : scene.geometries) {
    std::size_t& count = lists[geometry.triangles.data()];
    count = std::max(count, geometry.triangles.size());
  }
  std::size_t bytes = 0;
  for (const auto& [list, count] : lists) bytes += count * sizeof(*list);
  return bytes;
}

std::size_t mesh_bytes(const Scene& scene) {
  std::size_t bytes =
      bytes_of(scene.geometries) + bytes_of(scene.instances) + bytes_of_triangles(scene);
  for (const Geometry& geometry : scene.geometries)
    bytes += bytes_of(geometry.positions) + bytes_of(geometry.normals) + bytes_of(geometry.uvs) +
             bytes_of(geometry.spheres);
  return bytes;
}

std::uint64_t triangles_of(const Scene& scene, const Object& object) {
  std::uint64_t count = 0;
  for (const GeometryHandle geometry : object.geometries)
    count += scene.geometries[geometry.index].triangles.size();
  return count;
}

void count_triangles(const Scene& scene, SceneInfo& info) {
  for (const Geometry& geometry : scene.geometries) {
    info.triangles += geometry.triangles.size();
    info.spheres += geometry.spheres.size();
  }
  info.instanced_triangles = triangles_of(scene, scene.world);
  for (const Instance& instance : scene.instances)
    info.instanced_triangles += triangles_of(scene, scene.objects[instance.object.index]);
}

std::string kind_name(LightKind kind) {
  switch (kind) {
    case LightKind::Point:
      return "point";
    case LightKind::Spot:
      return "spot";
    case LightKind::Directional:
      return "directional";
    case LightKind::Triangle:
    case LightKind::TexturedTriangle:
    case LightKind::NearTriangle:
    case LightKind::Quad:  // of two of them
      return "triangle";
    case LightKind::Environment:
      return "environment";
    case LightKind::Goniometric:
      return "goniometric";
    case LightKind::Projection:
      return "projection";
    case LightKind::Sphere:
      return "sphere";
  }
  return "";
}

std::string same_path_key(const std::string& path) {
  std::error_code ignored;
  const auto canonical = std::filesystem::weakly_canonical(path, ignored);
  return ignored ? path : canonical.string();
}

// The textures that compiling kept, then the images that the scene names and nothing reads.
std::vector<TextureRow> texture_rows(const description::SceneDescription& description,
                                     const TextureStore& textures) {
  std::map<std::string, TextureRow> rows;  // by file: equal files share their pixels
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const TextureHandle handle(i);
    if (!textures.is_image(handle)) continue;
    const TextureInfo& info = textures.info(handle);
    rows[same_path_key(textures.path(handle))] = {
        textures.path(handle),      info.width, info.height, info.channels, info.bytes, true,
        textures.is_decoded(handle)};
  }
  for (const description::Image& image : description.images)
    rows.try_emplace(same_path_key(image.path), TextureRow{.path = image.path});
  std::vector<TextureRow> list;
  for (const auto& [key, row] : rows) list.push_back(row);
  return list;
}

std::string bytes_text(std::size_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (value < 1e3) return fmt::format("{} bytes", bytes);
  if (value < 1e6) return fmt::format("{:.1f} kB", value * 1e-3);
  return fmt::format("{:.1f} MB", value * 1e-6);
}

std::string vec_text(const Vec3d& v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z);
}

std::string lights_text(const SceneInfo& info) {
  std::string text;
  for (const auto& [kind, count] : info.lights)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  if (info.light_cells > 0) text += fmt::format("; picked by {} cells", info.light_cells);
  return text.empty() ? "none" : text;
}

std::string texture_text(const TextureRow& row) {
  if (!row.is_used) return fmt::format("    {}: named, never read\n", printable(row.path));
  return fmt::format("    {}: {}x{}, {} channels, {}{}\n", printable(row.path), row.width,
                     row.height, row.channels, bytes_text(row.bytes),
                     row.is_decoded ? ", decoded" : "");
}

std::string rays_text(const SceneInfo& info) {
  const std::string spheres =
      info.listed_spheres > 0 ? fmt::format(" and {} spheres", info.listed_spheres) : "";
  const std::string rest = info.boxes > 0
                               ? fmt::format("and down a tree behind {} boxes", info.boxes)
                               : "without a tree";
  return fmt::format("against all of {} faces{}, {}", info.faces, spheres, rest);
}

}  // namespace

SceneInfo describe_scene(const description::SceneDescription& description, const Scene& scene) {
  SceneInfo info;
  info.path = description.path;
  count_triangles(scene, info);
  info.geometries = scene.geometries.size();
  info.instances = scene.instances.size();
  info.cameras = scene.cameras.size();
  info.materials = scene.material_names;
  for (const description::Medium& medium : description.media)
    info.media.push_back({medium.name, medium.absorption, medium.scattering, medium.asymmetry});
  info.textures = texture_rows(description, scene.textures);
  for (const Light& light : scene.lights)
    if (light.kind != LightKind::Quad) ++info.lights[kind_name(light.kind)];
  if (scene.environment && info.lights.count("environment") == 0) info.lights["environment"] = 1;
  info.light_cells = scene.light_sampler.cells().count();
  if (!scene.bounds.is_empty()) {
    info.bounds_min = scene.normalisation.to_file(scene.bounds.lower);
    info.bounds_max = scene.normalisation.to_file(scene.bounds.upper);
  }
  info.mesh_bytes = mesh_bytes(scene);
  for (const TextureRow& row : info.textures)
    if (row.is_used) info.texture_bytes += row.bytes;
  info.dropped = scene.dropped;
  return info;
}

std::string to_text(const SceneInfo& info) {
  std::string text = fmt::format("{}\n", printable(info.path));
  const auto line = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("  {:<12}{}\n", name, value);
  };
  line("hash", info.scene_hash);
  line("triangles", fmt::format("{} in {} geometries", info.triangles, info.geometries));
  if (info.spheres > 0) line("spheres", std::to_string(info.spheres));
  line("instances",
       fmt::format("{} ({} triangles seen by rays)", info.instances, info.instanced_triangles));
  line("cameras", std::to_string(info.cameras));
  line("lights", lights_text(info));
  line("bounds", fmt::format("{} .. {}", vec_text(info.bounds_min), vec_text(info.bounds_max)));
  line("memory", fmt::format("meshes {}, textures {} when all are decoded",
                             bytes_text(info.mesh_bytes), bytes_text(info.texture_bytes)));
  if (info.accelerator_bytes)
    line("", fmt::format("{} {}", info.accelerator, bytes_text(*info.accelerator_bytes)));
  line("kernel", info.kernel);
  if (info.faces > 0) line("rays", rays_text(info));
  line("materials", fmt::format("{}", info.materials.size()));
  for (const std::string& name : info.materials) text += fmt::format("    {}\n", printable(name));
  line("media", fmt::format("{}", info.media.size()));
  for (const MediumRow& row : info.media)
    text +=
        fmt::format("    {}: absorption {}, scattering {}, asymmetry {:g}\n", printable(row.name),
                    vec_text(row.absorption), vec_text(row.scattering), row.asymmetry);
  line("textures", fmt::format("{}", info.textures.size()));
  for (const TextureRow& row : info.textures) text += texture_text(row);
  line("dropped", info.dropped.empty() ? "nothing" : "");
  for (const Dropped& dropped : info.dropped)
    text += fmt::format("    {}: {}\n", dropped.what, dropped.count);
  return text;
}

}  // namespace candela::cli
