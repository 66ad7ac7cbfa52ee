#include "scene_io/obj/build_meshes.h"

#include <algorithm>

#include "scene_io/mesh/smooth_normals.h"
#include "scene_io/mesh/triangulate.h"
#include "scene_io/obj/unique_vertices.h"

namespace candela::obj {
namespace {

using description::Mesh;
using VertexTriangle = std::array<std::uint32_t, 3>;

std::size_t corner_count(const MeshPlan& plan) {
  std::size_t count = 0;
  for (const FaceRun& run : plan.runs) {
    for (std::uint32_t f = run.face_begin; f < run.face_end; ++f) {
      count += run.chunk->faces[f].corner_count;
    }
  }
  return count;
}

class MeshBuilder {
 public:
  MeshBuilder(const ObjData& data, const MeshPlan& plan)
      : data_(data), plan_(plan), corner_count_(corner_count(plan)), vertices_(corner_count_ / 4) {
    built_.mesh.triangles.reserve(corner_count_ - 2 * plan.face_count);
  }

  BuiltMesh build(bool smooth_missing_normals) {
    for (const FaceRun& run : plan_.runs) add_run(run);
    fill_positions();
    fill_uvs();
    fill_normals();
    vertices_ = UniqueVertices(0);  // smoothing needs memory of its own
    if (built_.mesh.normals.empty() && smooth_missing_normals) {
      mesh::compute_smooth_normals(built_.mesh);
    }
    return std::move(built_);
  }

 private:
  void add_run(const FaceRun& run) {
    if (run.shape != shape_) vertices_.begin_shape(shape_ = run.shape);
    std::size_t corner = run.corner_begin;
    for (std::uint32_t f = run.face_begin; f < run.face_end; ++f) {
      const Face& face = run.chunk->faces[f];
      const CornerTable& corners = run.chunk->corners;
      if (face.corner_count == 3) {
        built_.mesh.triangles.push_back({vertices_.index_of(corners[corner]),
                                         vertices_.index_of(corners[corner + 1]),
                                         vertices_.index_of(corners[corner + 2])});
      } else {
        polygon_corners_.clear();
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
          polygon_corners_.push_back(corners[corner + k]);
        add_polygon(polygon_corners_);
        if (triangulator_.was_bow()) note_bow(run.chunk->begin + face.offset);
      }
      corner += face.corner_count;
    }
  }

  void add_polygon(std::span<const Corner> corners) {
    polygon_.clear();
    polygon_vertices_.clear();
    for (const Corner& corner : corners) {
      polygon_.push_back(data_.positions[static_cast<std::size_t>(corner.position)]);
      polygon_vertices_.push_back(vertices_.index_of(corner));
    }
    const std::size_t first = built_.mesh.triangles.size();
    for (const mesh::IndexTriangle& t : triangulator_.triangulate(polygon_)) {
      built_.mesh.triangles.push_back(
          {polygon_vertices_[t[0]], polygon_vertices_[t[1]], polygon_vertices_[t[2]]});
    }
    if (triangulator_.was_bow()) turn_bow(corners, first);
  }

  // A bow has no orientation of its own: its normals say which way it looks.
  void turn_bow(std::span<const Corner> corners, std::size_t first_triangle) {
    Vec3d given{0.0};
    for (const Corner& corner : corners) {
      if (corner.normal < 0) return;
      given += Vec3d(data_.normals[static_cast<std::size_t>(corner.normal)]);
    }
    const auto& [a, b, c] = built_.mesh.triangles[first_triangle];
    const auto position = [&](std::uint32_t vertex) {
      const auto index = static_cast<std::size_t>(vertices_.vertices()[vertex].position);
      return data_.positions[index];
    };
    const Vec3d edge_b = position(b) - position(a);
    const Vec3d edge_c = position(c) - position(a);
    if (dot(cross(edge_b, edge_c), given) >= 0.0) return;
    for (std::size_t t = first_triangle; t < built_.mesh.triangles.size(); ++t) {
      std::swap(built_.mesh.triangles[t][1], built_.mesh.triangles[t][2]);
    }
  }

  void note_bow(std::size_t offset) {
    if (built_.bow_count == 0) built_.first_bow_offset = offset;
    ++built_.bow_count;
  }

  void fill_positions() {
    built_.mesh.positions.reserve(vertices_.vertices().size());
    for (const Corner& corner : vertices_.vertices()) {
      built_.mesh.positions.push_back(data_.positions[static_cast<std::size_t>(corner.position)]);
    }
  }

  void fill_uvs() {
    const std::vector<Corner>& vertices = vertices_.vertices();
    const bool is_complete =
        std::all_of(vertices.begin(), vertices.end(), [](const Corner& c) { return c.uv >= 0; });
    built_.mesh.uvs.assign(vertices.size(), Vec2f{0.5f});
    if (!is_complete) return;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      built_.mesh.uvs[i] = data_.uvs[static_cast<std::size_t>(vertices[i].uv)];
    }
  }

  // All or none.
  void fill_normals() {
    const std::vector<Corner>& vertices = vertices_.vertices();
    const bool is_complete = std::all_of(vertices.begin(), vertices.end(),
                                         [](const Corner& c) { return c.normal >= 0; });
    if (!is_complete) return;
    built_.mesh.normals.reserve(vertices.size());
    for (const Corner& corner : vertices) {
      built_.mesh.normals.push_back(data_.normals[static_cast<std::size_t>(corner.normal)]);
    }
  }

  const ObjData& data_;
  const MeshPlan& plan_;
  std::size_t corner_count_;
  UniqueVertices vertices_;
  mesh::Triangulator triangulator_;
  std::vector<Corner> polygon_corners_;
  std::vector<Vec3d> polygon_;
  std::vector<std::uint32_t> polygon_vertices_;
  std::uint32_t shape_ = 0;
  BuiltMesh built_;
};

}  // namespace

BuiltMesh build_mesh(const ObjData& data, const MeshPlan& plan, bool smooth_missing_normals) {
  return MeshBuilder(data, plan).build(smooth_missing_normals);
}

}  // namespace candela::obj
