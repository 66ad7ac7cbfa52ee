#include "tests/stress/closed_meshes.h"

#include <map>
#include <set>

#include "scene_io/load.h"
#include "tests/scene_io/shared_scenes.h"
#include "tests/scenes/soups.h"

namespace candela::test {
namespace {

using Index = std::uint32_t;
using Edge = std::pair<Index, Index>;

// Directed edges without their opposite.
std::map<Index, Index> boundary_of(const std::vector<std::array<Index, 3>>& triangles) {
  std::set<Edge> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  std::map<Index, Index> boundary;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) boundary[a] = b;
  return boundary;
}

// A fan over each hole, from the middle of its border.
void fill_holes(description::Mesh& mesh) {
  std::map<Index, Index> boundary = boundary_of(mesh.triangles);
  while (!boundary.empty()) {
    std::vector<Index> loop;
    for (Index v = boundary.begin()->first; boundary.contains(v);) {
      loop.push_back(v);
      const Index next = boundary[v];
      boundary.erase(v);
      v = next;
    }
    Vec3d middle(0.0);
    for (const Index v : loop) middle += mesh.positions[v] / static_cast<double>(loop.size());
    const auto hub = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(middle);
    for (std::size_t i = 0; i < loop.size(); ++i)
      mesh.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], hub});
  }
}

// OBJ files repeat vertices; a surface is closed only where equal ones are one.
void weld(description::Mesh& mesh) {
  const auto less = [](const Vec3d& a, const Vec3d& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<Vec3d, Index, decltype(less)> seen(less);
  std::vector<Vec3d> positions;
  std::vector<Index> renumbered;
  for (const Vec3d& p : mesh.positions) {
    const auto [at, is_new] = seen.try_emplace(Vec3d(Vec3f(p)), static_cast<Index>(seen.size()));
    if (is_new) positions.push_back(p);
    renumbered.push_back(at->second);
  }
  for (auto& t : mesh.triangles)
    for (Index& v : t) v = renumbered[v];
  std::erase_if(mesh.triangles,
                [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  mesh.positions = std::move(positions);
  mesh.normals.clear();
  mesh.uvs.clear();
}

// A grid over [-1, 1]^2 x {0}-like faces of a cube: x is cut at `cuts`, the others not at all.
description::Mesh cube_in_strips(const std::vector<double>& cuts) {
  description::Mesh mesh;
  const std::array<Vec2d, 4> corners{Vec2d(-1, -1), Vec2d(-1, 1), Vec2d(1, 1), Vec2d(1, -1)};
  for (const double x : cuts)
    for (const Vec2d& corner : corners) mesh.positions.emplace_back(x, corner.x, corner.y);
  for (Index i = 0; i + 1 < cuts.size(); ++i)
    for (Index k = 0; k < 4; ++k) {
      const Index a = 4 * i + k;
      const Index b = 4 * i + (k + 1) % 4;
      mesh.triangles.push_back({a, b, b + 4});
      mesh.triangles.push_back({a, b + 4, a + 4});
    }
  const auto last = static_cast<Index>(mesh.positions.size() - 4);
  mesh.triangles.insert(
      mesh.triangles.end(),
      {{0, 2, 1}, {0, 3, 2}, {last, last + 1, last + 2}, {last, last + 2, last + 3}});
  return mesh;
}

}  // namespace

ClosedMesh closed_mesh(const std::string& name, const description::Mesh& mesh, const Vec3d& inside,
                       double radius) {
  ClosedMesh closed{name, {}, Vec3f(inside), static_cast<float>(radius)};
  closed.geometry.positions.reserve(mesh.positions.size() + 1);
  for (const Vec3d& p : mesh.positions) closed.geometry.positions.emplace_back(p);
  closed.geometry.triangles = mesh.triangles;
  closed.geometry.material = MaterialHandle(0);
  return closed;
}

ClosedMesh closed_cornell_box() {
  description::Mesh mesh;
  mesh.positions = {{0, 0, 0},     {552.8, 0, 0},   {549.6, 0, 559.2},   {0, 0, 559.2},
                    {0, 548.8, 0}, {556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}};
  mesh.triangles = {{0, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}, {3, 7, 6}, {3, 6, 2},
                    {0, 4, 7}, {0, 7, 3}, {1, 2, 6}, {1, 6, 5}, {0, 1, 5}, {0, 5, 4}};
  return closed_mesh("Cornell box", mesh, {277, 274, 280}, 200);
}

ClosedMesh icosphere(int subdivisions) {
  return closed_mesh("icosphere " + std::to_string(subdivisions),
                     sphere({0, 0, 0}, 1, subdivisions, false), {0, 0, 0}, 0.4);
}

ClosedMesh box_of_slivers() {
  std::vector<double> cuts;
  for (const double start : {-0.9, -0.31, 0.0, 0.52})
    for (int i = 0; i < 250; ++i) cuts.push_back(start + 2e-6 * i);
  cuts.insert(cuts.begin(), -1);
  cuts.push_back(1);
  description::Mesh mesh = cube_in_strips(cuts);
  const Vec3d x = normalize(Vec3d(3, 1, 2));
  const Vec3d y = normalize(cross(x, Vec3d(0, 0, 1)));
  for (Vec3d& p : mesh.positions) p = x * p.x + y * p.y + cross(x, y) * p.z;
  return closed_mesh("slivers", mesh, {0, 0, 0}, 0.4);
}

std::optional<ClosedMesh> closed_bunny() {
  const std::optional<std::string> path = shared_scene("lab3/bunny/bunny.yaml");
  if (!path) return std::nullopt;
  const Result<description::SceneDescription> scene = load(*path, {});
  if (!scene || scene->meshes.empty()) return std::nullopt;
  description::Mesh mesh = scene->meshes[0];
  weld(mesh);
  fill_holes(mesh);
  Vec3d lower(1e30), upper(-1e30);
  for (const Vec3d& p : mesh.positions) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  const Vec3d extent = upper - lower;
  // The middle of its body, which is left of and below the middle of the box with the ears.
  return closed_mesh("bunny", mesh, lower + extent * Vec3d(0.6, 0.3, 0.5), 0.03 * extent.x);
}

ClosedMesh far_sphere() {
  const Vec3d centre(148376.0, 1234.0, -223423.0);
  return closed_mesh("far sphere", sphere(centre, 2, 6, false), centre, 0.8);
}

std::size_t open_edges(const Geometry& geometry) {
  std::map<Edge, int> count;
  for (const auto& t : geometry.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  std::size_t open = 0;
  for (const auto& [edge, times] : count) {
    const auto opposite = count.find({edge.second, edge.first});
    open += times != 1 || opposite == count.end() || opposite->second != 1;
  }
  return open;
}

Scene scene_of(const ClosedMesh& mesh) {
  std::vector<Geometry> geometries{mesh.geometry};
  geometries[0].positions.reserve(mesh.geometry.positions.size() + 1);
  return scene_of(std::move(geometries));
}

}  // namespace candela::test
