#include "scene_io/ply/write_ply.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include <fmt/format.h>

namespace candela::ply {
namespace {

using description::Mesh;

static_assert(std::endian::native == std::endian::little);

template <class Number>
void append(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

// The vertices that triangles use, numbered as they come.
struct Picked {
  std::vector<std::uint32_t> vertices;  // of the mesh
  std::vector<std::uint32_t> corners;   // three a triangle, into `vertices`
};

Picked pick(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  constexpr std::uint32_t unseen = UINT32_MAX;
  Picked picked;
  picked.corners.reserve(3 * triangles.size());
  std::vector<std::uint32_t> number_of(mesh.positions.size(), unseen);
  for (const std::uint32_t triangle : triangles)
    for (const std::uint32_t vertex : mesh.triangles[triangle]) {
      if (number_of[vertex] == unseen) {
        number_of[vertex] = static_cast<std::uint32_t>(picked.vertices.size());
        picked.vertices.push_back(vertex);
      }
      picked.corners.push_back(number_of[vertex]);
    }
  return picked;
}

bool are_floats(const Mesh& mesh, const Picked& picked) {
  return std::all_of(picked.vertices.begin(), picked.vertices.end(), [&](std::uint32_t vertex) {
    const Vec3d& p = mesh.positions[vertex];
    return Vec3d(Vec3f(p)) == p;
  });
}

std::string header(const Picked& picked, bool has_doubles, bool has_normals, bool has_uvs) {
  const std::string_view type = has_doubles ? "double" : "float";
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  text += fmt::format("element vertex {}\n", picked.vertices.size());
  for (const char axis : {'x', 'y', 'z'}) text += fmt::format("property {} {}\n", type, axis);
  if (has_normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (has_uvs) text += "property float u\nproperty float v\n";
  text += fmt::format("element face {}\n", picked.corners.size() / 3);
  return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

std::string write_ply(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                      const WriteOptions& options) {
  const Picked picked = pick(mesh, triangles);
  const bool has_doubles = !are_floats(mesh, picked);
  const bool has_normals = !mesh.normals.empty();
  const bool has_uvs = !mesh.uvs.empty() || options.missing_uv.has_value();
  std::string bytes = header(picked, has_doubles, has_normals, has_uvs);
  bytes.reserve(bytes.size() + 44 * picked.vertices.size() + 13 * (picked.corners.size() / 3));
  for (const std::uint32_t vertex : picked.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      const double number = mesh.positions[vertex][axis];
      if (has_doubles)
        append(bytes, number);
      else
        append(bytes, static_cast<float>(number));
    }
    if (has_normals)
      for (int axis = 0; axis < 3; ++axis) append(bytes, mesh.normals[vertex][axis]);
    if (!has_uvs) continue;
    const Vec2f uv = mesh.uvs.empty() ? *options.missing_uv : mesh.uvs[vertex];
    append(bytes, uv.x);
    append(bytes, uv.y);
  }
  for (std::size_t i = 0; i < picked.corners.size(); i += 3) {
    append(bytes, std::uint8_t{3});
    for (std::size_t k = 0; k < 3; ++k)
      append(bytes, static_cast<std::int32_t>(picked.corners[i + k]));
  }
  return bytes;
}

}  // namespace candela::ply
