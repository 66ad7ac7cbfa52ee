// trianglemesh, plymesh and bilinearmesh.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene_io/pbrt/shape_kinds.h"
#include "scene_io/pbrt/source_files.h"
#include "scene_io/ply/read_ply.h"

namespace candela::pbrt {
namespace {

using description::Mesh;

// Cells along an edge of a patch that is not flat.
constexpr std::uint32_t patch_cells = 16;

Vec2f to_float(const Vec2d& uv) {
  return Vec2f(glm::clamp(uv, Vec2d(-1e30), Vec2d(1e30)));
}
// Any length counts, so that long ones may be cut.
Vec3f to_float(const Vec3d& normal) {
  const double largest = max_component(glm::abs(normal));
  const bool is_moderate = largest == 0 || (largest > 1e-18 && largest < 1e18);
  return Vec3f(is_moderate ? normal : normal / largest);
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& from) {
  std::vector<To> to(from.size());
  std::transform(from.begin(), from.end(), to.begin(), [](const From& v) { return to_float(v); });
  return to;
}

template <class T>
T blend(const T& p00, const T& p10, const T& p01, const T& p11, double u, double v) {
  return (p00 * (1 - u) + p10 * u) * (1 - v) + (p01 * (1 - u) + p11 * u) * v;
}

void append_patch(const IndexedFaces& faces, const std::uint32_t* corner, Mesh& mesh) {
  const auto at = [&](const auto& list, double u, double v) {
    return blend(list[corner[0]], list[corner[1]], list[corner[2]], list[corner[3]], u, v);
  };
  const auto& p = faces.positions;
  const Vec3d p00 = p[corner[0]];
  const Vec3d p10 = p[corner[1]];
  const Vec3d p01 = p[corner[2]];
  const Vec3d p11 = p[corner[3]];
  const auto surface = [&](double u, double v) {
    const Vec3d du = (p10 - p00) * (1 - v) + (p11 - p01) * v;
    const Vec3d dv = (p01 - p00) * (1 - u) + (p11 - p10) * u;
    const Vec3d normal = faces.normals.empty() ? cross(du, dv) : at(faces.normals, u, v);
    return SurfaceSample{at(p, u, v), normal};
  };
  const auto uv = [&](double u, double v) {
    return faces.uvs.empty() ? Vec2d(u, v) : at(faces.uvs, u, v);
  };
  // A parallelogram, up to rounding: u and v are the same on its two triangles.
  const double twist = length(p11 - p10 - p01 + p00);
  const bool is_flat = twist <= 1e-6 * std::max(length(p10 - p01), length(p11 - p00));
  const std::uint32_t cells = is_flat ? 1 : patch_cells;
  append_grid(cells, cells, surface, uv, mesh);
}

}  // namespace

ShapeMesh of_triangles(Mesh mesh) {
  const std::size_t count = mesh.triangles.size();
  return {std::move(mesh), count};
}

std::optional<IndexedFaces> indexed_faces(Arguments& arguments, std::size_t corners) {
  IndexedFaces faces{arguments.points3("P"), arguments.points3("N"), arguments.points2("uv"),
                     arguments.indices("indices")};
  if (faces.uvs.empty()) faces.uvs = arguments.points2("st");  // pbrt-v3
  const std::size_t count = faces.positions.size();
  const auto fail = [&](std::string message) {
    arguments.report().error(arguments.statement().place, std::move(message));
    return std::nullopt;
  };
  if (count == 0) {
    if (arguments.has("P")) return std::nullopt;  // said
    return fail("a mesh without positions: expected \"point3 P\"");
  }
  if (faces.indices.empty() && !arguments.has("indices") && count == corners)
    for (std::uint32_t i = 0; i < corners; ++i) faces.indices.push_back(i);
  if (faces.indices.empty() || faces.indices.size() % corners != 0)
    return fail(
        fmt::format("{} indices, expected {} for each face", faces.indices.size(), corners));
  const std::uint32_t largest = *std::max_element(faces.indices.begin(), faces.indices.end());
  if (largest >= count)
    return fail(fmt::format("index {} of {} vertices (from 0)", largest, count));
  if (!faces.normals.empty() && faces.normals.size() != count)
    return fail(fmt::format("{} normals N for {} vertices", faces.normals.size(), count));
  if (!faces.uvs.empty() && faces.uvs.size() != count)
    return fail(fmt::format("{} texture coordinates uv for {} vertices", faces.uvs.size(), count));
  return faces;
}

MaybeMesh triangle_mesh(Arguments& arguments) {
  arguments.accept({"S", "faceIndices"});  // tangents: the same as uv's for what is rendered here
  auto faces = indexed_faces(arguments, 3);
  if (!faces) return std::nullopt;
  Mesh mesh;
  mesh.positions = std::move(faces->positions);
  mesh.normals = converted<Vec3f>(faces->normals);
  mesh.uvs = converted<Vec2f>(faces->uvs);
  mesh.triangles.reserve(faces->indices.size() / 3);
  for (std::size_t i = 0; i < faces->indices.size(); i += 3)
    mesh.triangles.push_back({faces->indices[i], faces->indices[i + 1], faces->indices[i + 2]});
  return of_triangles(std::move(mesh));
}

MaybeMesh ply_mesh(Arguments& arguments, const ShapeOptions& options) {
  arguments.ignore("displacement", "meshes are not displaced");
  arguments.accept({"edgelength"});
  const Parameter* file = arguments.find("filename", {ParameterType::String});
  if (!file || file->strings.size() != 1) {
    arguments.report().error(arguments.statement().place,
                             "a plymesh without its file: expected \"string filename\"");
    return std::nullopt;
  }
  const std::string path =
      resolve_file(options.scene_path, file->place, file->strings[0], arguments.report());
  auto mesh =
      ply::read_ply(path, {.smooth_missing_normals = false}, arguments.report().diagnostics());
  return mesh ? MaybeMesh(of_triangles(std::move(*mesh))) : std::nullopt;
}

MaybeMesh bilinear_mesh(Arguments& arguments) {
  arguments.ignore("emissionfilename", "patches emit evenly");
  arguments.accept({"faceIndices"});
  const auto faces = indexed_faces(arguments, 4);
  if (!faces) return std::nullopt;
  Mesh mesh;
  for (std::size_t i = 0; i < faces->indices.size(); i += 4)
    append_patch(*faces, &faces->indices[i], mesh);
  return ShapeMesh{std::move(mesh), faces->indices.size() / 4};
}

}  // namespace candela::pbrt
