// loopsubdiv: Loop's subdivision surfaces [Loop87], with boundaries as cubic B-splines
// [Hoppe94, figure 3].
#include <array>
#include <unordered_map>

#include <fmt/format.h>

#include "scene_io/mesh/smooth_normals.h"
#include "scene_io/pbrt/shape_kinds.h"

namespace candela::pbrt {
namespace {

using description::Mesh;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::size_t most_triangles = std::size_t{1} << 23;

// An edge and what lies beside it: one face at a boundary.
struct Edge {
  std::uint32_t a = 0, b = 0;
  std::array<std::uint32_t, 2> opposite{};  // corners of its faces
  std::uint32_t face_count = 0;

  [[nodiscard]] bool is_inner() const { return face_count == 2; }
};

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

struct EdgeTable {
  std::vector<Edge> edges;
  std::unordered_map<std::uint64_t, std::uint32_t> index_of;

  explicit EdgeTable(const Triangles& triangles) {
    index_of.reserve(triangles.size() * 2);
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t opposite) {
    const auto [at, is_new] =
        index_of.try_emplace(key_of(a, b), static_cast<std::uint32_t>(edges.size()));
    if (is_new) edges.push_back({std::min(a, b), std::max(a, b), {}, 0});
    Edge& edge = edges[at->second];
    if (edge.face_count < 2) edge.opposite[edge.face_count] = opposite;
    ++edge.face_count;
  }
};

// Sums over a vertex' neighbours: all of them, and those along a boundary.
struct Ring {
  Vec3d sum{0.0}, boundary_sum{0.0};
  std::uint32_t valence = 0, boundary_valence = 0;
};

std::vector<Ring> rings_of(const std::vector<Vec3d>& positions, const EdgeTable& table) {
  std::vector<Ring> rings(positions.size());
  const auto add = [&](Ring& ring, const Vec3d& neighbour, bool is_boundary) {
    ring.sum += neighbour;
    ++ring.valence;
    if (!is_boundary) return;
    ring.boundary_sum += neighbour;
    ++ring.boundary_valence;
  };
  for (const Edge& edge : table.edges) {
    add(rings[edge.a], positions[edge.b], !edge.is_inner());
    add(rings[edge.b], positions[edge.a], !edge.is_inner());
  }
  return rings;
}

double beta(std::uint32_t valence) {
  return valence == 3 ? 3.0 / 16 : 3.0 / (8 * valence);
}

// `own` of the vertex and the rest of its neighbours.
Vec3d moved(const Vec3d& vertex, const Ring& ring, double boundary_weight, double inner_weight) {
  if (ring.boundary_valence == 2)
    return vertex * (1 - 2 * boundary_weight) + ring.boundary_sum * boundary_weight;
  if (ring.boundary_valence > 0 || ring.valence < 3) return vertex;  // no surface around it
  return vertex * (1 - ring.valence * inner_weight) + ring.sum * inner_weight;
}

void move_vertices(std::vector<Vec3d>& positions, const EdgeTable& table, bool to_limit) {
  const std::vector<Ring> rings = rings_of(positions, table);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::uint32_t n = rings[i].valence;
    const double inner = n == 0 ? 0 : to_limit ? 1 / (n + 3 / (8 * beta(n))) : beta(n);
    positions[i] = moved(positions[i], rings[i], to_limit ? 1.0 / 6 : 1.0 / 8, inner);
  }
}

Vec3d edge_point(const std::vector<Vec3d>& p, const Edge& edge) {
  if (!edge.is_inner()) return (p[edge.a] + p[edge.b]) * 0.5;
  return (p[edge.a] + p[edge.b]) * (3.0 / 8) +
         (p[edge.opposite[0]] + p[edge.opposite[1]]) * (1.0 / 8);
}

void subdivide(std::vector<Vec3d>& positions, Triangles& triangles) {
  const EdgeTable table(triangles);
  const auto first = static_cast<std::uint32_t>(positions.size());
  std::vector<Vec3d> points;
  points.reserve(table.edges.size());
  for (const Edge& edge : table.edges) points.push_back(edge_point(positions, edge));
  move_vertices(positions, table, false);
  positions.insert(positions.end(), points.begin(), points.end());
  Triangles finer;
  finer.reserve(triangles.size() * 4);
  for (const auto& [a, b, c] : triangles) {
    const std::uint32_t ab = first + table.index_of.at(key_of(a, b));
    const std::uint32_t bc = first + table.index_of.at(key_of(b, c));
    const std::uint32_t ca = first + table.index_of.at(key_of(c, a));
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  triangles = std::move(finer);
}

}  // namespace

MaybeMesh loop_subdivision(Arguments& arguments) {
  arguments.accept({"scheme"});
  const bool is_v3 = arguments.has("nlevels") && !arguments.has("levels");
  const std::string_view name = is_v3 ? "nlevels" : "levels";
  const auto levels = static_cast<double>(arguments.integer(name).value_or(3));
  const auto faces = indexed_faces(arguments, 3);
  if (!faces) return std::nullopt;
  auto left = static_cast<std::int64_t>(arguments.clamped(name, levels, 0));
  if (left > 20 || (faces->indices.size() / 3) > (most_triangles >> (2 * left))) {
    arguments.report().error(
        arguments.statement().place,
        fmt::format("{} levels of subdivision of {} triangles, expected at most {} triangles "
                    "in the end",
                    left, faces->indices.size() / 3, most_triangles));
    return std::nullopt;
  }
  std::vector<Vec3d> positions = faces->positions;
  Triangles triangles;
  // The other way round: pbrt-v4 goes around a vertex clockwise (LoopSubdivide, oneRing()), and the
  // normals that it finds by that decide where such a surface faces.
  for (std::size_t i = 0; i < faces->indices.size(); i += 3)
    triangles.push_back({faces->indices[i], faces->indices[i + 2], faces->indices[i + 1]});
  for (; left > 0; --left) subdivide(positions, triangles);
  move_vertices(positions, EdgeTable(triangles), true);
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  mesh::compute_smooth_normals(mesh);
  return of_triangles(std::move(mesh));
}

}  // namespace candela::pbrt
