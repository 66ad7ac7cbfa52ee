// trianglemesh, plymesh and bilinearmesh.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene_io/mesh/float_direction.h"
#include "scene_io/pbrt/shape_kinds.h"
#include "scene_io/pbrt/source_files.h"
#include "scene_io/ply/read_ply.h"
#include "scene_io/text/file.h"

namespace candela::pbrt {
namespace {

using description::Mesh;

using Patch = std::array<Vec3d, 4>;  // at u v: 0 0, 1 0, 0 1, 1 1

Vec2f to_float(const Vec2d& uv) {
  return Vec2f(glm::clamp(uv, Vec2d(-1e30), Vec2d(1e30)));
}
Vec3f to_float(const Vec3d& normal) {
  return mesh::to_float_direction(normal);
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

// u and v are the same on its two triangles, up to rounding.
bool is_parallelogram(const Patch& p) {
  const double twist = length(p[3] - p[1] - p[2] + p[0]);
  return twist <= 1e-6 * std::max(length(p[1] - p[2]), length(p[3] - p[0]));
}

// A convex quadrangle of one plane: its normals at the corners are one, where there are any.
bool is_convex_and_flat(const Patch& p) {
  const std::array<Vec3d, 4> normals{
      cross(p[1] - p[0], p[2] - p[0]), cross(p[1] - p[0], p[3] - p[1]),
      cross(p[3] - p[2], p[2] - p[0]), cross(p[3] - p[2], p[3] - p[1])};
  Vec3d first(0.0);
  for (const Vec3d& normal : normals) {
    const double size = length(normal);
    if (!(size > 0)) continue;
    if (first == Vec3d(0.0)) first = normal / size;
    if (length(normal / size - first) > 1e-5) return false;
  }
  return true;
}

bool is_of_two_triangles(const Patch& patch, bool shows_uvs) {
  return is_parallelogram(patch) || (!shows_uvs && is_convex_and_flat(patch));
}

void append_patch(const IndexedFaces& faces, const std::uint32_t* corner, bool needs_uvs,
                  std::uint32_t curved_cells, Mesh& mesh) {
  const auto at = [&](const auto& list, double u, double v) {
    return blend(list[corner[0]], list[corner[1]], list[corner[2]], list[corner[3]], u, v);
  };
  const auto& positions = faces.positions;
  const Patch p{positions[corner[0]], positions[corner[1]], positions[corner[2]],
                positions[corner[3]]};
  const auto surface = [&](double u, double v) {
    const Vec3d du = (p[1] - p[0]) * (1 - v) + (p[3] - p[2]) * v;
    const Vec3d dv = (p[2] - p[0]) * (1 - u) + (p[3] - p[1]) * u;
    const Vec3d normal = faces.normals.empty() ? cross(du, dv) : at(faces.normals, u, v);
    return SurfaceSample{at(positions, u, v), normal};
  };
  const auto uv = [&](double u, double v) {
    return faces.uvs.empty() ? Vec2d(u, v) : at(faces.uvs, u, v);
  };
  const bool shows_uvs = needs_uvs || !faces.normals.empty();
  const std::uint32_t cells = is_of_two_triangles(p, shows_uvs) ? 1 : curved_cells;
  append_grid(cells, cells, surface, uv, mesh);
}

const Parameter* parameter_of(const ShapeStatement& shape, std::string_view name) {
  const ParameterList& list = shape.statement.parameters;
  const auto found = std::find_if(
      list.begin(), list.end(), [&](const Parameter& parameter) { return parameter.name == name; });
  return found == list.end() ? nullptr : &*found;
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
  if (arguments.has_errors()) return std::nullopt;
  const std::size_t count = faces.positions.size();
  const auto fail = [&](std::string message) {
    arguments.report().error(arguments.statement().place, std::move(message));
    return std::nullopt;
  };
  if (count == 0) return fail("a mesh without positions: expected \"point3 P\"");
  if (faces.indices.empty() && !arguments.has("indices") && count == corners)
    for (std::uint32_t i = 0; i < corners; ++i) faces.indices.push_back(i);
  if (faces.indices.empty() || faces.indices.size() % corners != 0)
    return fail(
        fmt::format("{} indices, expected {} for each face", faces.indices.size(), corners));
  const std::uint32_t largest = *std::max_element(faces.indices.begin(), faces.indices.end());
  if (largest >= count)
    return fail(
        fmt::format("\"indices\" has {}, but there are {} vertices (from 0)", largest, count));
  if (!faces.normals.empty() && faces.normals.size() != count)
    return fail(fmt::format("{} normals N for {} vertices", faces.normals.size(), count));
  if (!faces.uvs.empty() && faces.uvs.size() != count)
    return fail(fmt::format("{} texture coordinates uv for {} vertices", faces.uvs.size(), count));
  return faces;
}

MaybeMesh triangle_mesh(Arguments& arguments) {
  arguments.accept({"faceIndices"});
  arguments.ignore("S", "tangents are those of the texture coordinates");
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

namespace {

std::optional<ply::PolygonMesh> read_faces(Arguments& arguments, const Parameter& file,
                                           const ShapeOptions& options) {
  const std::string path =
      resolve_file(options.scene_path, file.place, file.strings[0], arguments.report());
  const Result<std::string> bytes = text::read_file(path);
  if (!bytes) {
    for (const Diagnostic& reason : bytes.diagnostics.list())
      arguments.report().error(file.place,
                               fmt::format("{} {}", text::quoted_path(path), reason.message));
    return std::nullopt;
  }
  return ply::parse_polygons(path, *bytes, arguments.report().diagnostics());
}

// pbrt's for files without: of triangles and, as it makes patches of them, of quadrangles. It has
// no other faces. Vertices are no longer shared.
void add_face_uvs(ply::PolygonMesh& faces) {
  static constexpr std::array<Vec2f, 4> corner_uvs{Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1),
                                                   Vec2f(0, 1)};
  Mesh split;
  split.name = faces.mesh.name;
  split.span = faces.mesh.span;
  std::size_t next = 0;
  for (const std::uint32_t size : faces.sizes)
    for (std::size_t k = 0; k < size; ++k) {
      std::uint32_t& corner = faces.corners[next];
      split.positions.push_back(faces.mesh.positions[corner]);
      if (!faces.mesh.normals.empty()) split.normals.push_back(faces.mesh.normals[corner]);
      split.uvs.push_back(corner_uvs[std::min<std::size_t>(k, 3)]);
      corner = static_cast<std::uint32_t>(next++);
    }
  faces.mesh = std::move(split);
}

}  // namespace

MaybeMesh ply_mesh(Arguments& arguments, const ShapeOptions& options) {
  arguments.ignore("displacement", "meshes are not displaced");
  arguments.accept({"edgelength"});
  const Parameter* file = arguments.file("filename", "a plymesh");
  if (!file) return std::nullopt;
  std::optional<ply::PolygonMesh> faces = read_faces(arguments, *file, options);
  if (!faces) return std::nullopt;
  if (options.needs_uvs && faces->mesh.uvs.empty()) add_face_uvs(*faces);
  const std::size_t count = faces->sizes.size();
  return ShapeMesh{ply::triangulated(std::move(*faces)), count};
}

std::size_t curved_patch_count(const ShapeStatement& shape, bool needs_uvs) {
  const Parameter* given = parameter_of(shape, "P");
  if (shape.statement.type != "bilinearmesh" || !given) return 0;
  const std::vector<double>& p = given->numbers;
  const Parameter* indices = parameter_of(shape, "indices");
  const std::vector<double> corners = indices ? indices->numbers : std::vector<double>{0, 1, 2, 3};
  const bool shows_uvs = needs_uvs || parameter_of(shape, "N");
  std::size_t count = 0;
  for (std::size_t i = 0; i + 4 <= corners.size(); i += 4) {
    Patch patch;
    for (std::size_t k = 0; k < 4; ++k) {
      const double corner = corners[i + k];
      if (!(corner >= 0 && corner < static_cast<double>(p.size() / 3))) return count;  // an error
      const std::size_t at = 3 * static_cast<std::size_t>(corner);
      patch[k] = {p[at], p[at + 1], p[at + 2]};
    }
    if (!is_of_two_triangles(patch, shows_uvs)) ++count;
  }
  return count;
}

MaybeMesh bilinear_mesh(Arguments& arguments, const ShapeOptions& options) {
  arguments.ignore("emissionfilename", "patches emit evenly");
  arguments.accept({"faceIndices"});
  const auto faces = indexed_faces(arguments, 4);
  if (!faces) return std::nullopt;
  const std::uint32_t cells = patch_cells_for(options.segments);
  Mesh mesh;
  for (std::size_t i = 0; i < faces->indices.size(); i += 4)
    append_patch(*faces, &faces->indices[i], options.needs_uvs, cells, mesh);
  return ShapeMesh{std::move(mesh), faces->indices.size() / 4};
}

}  // namespace candela::pbrt
