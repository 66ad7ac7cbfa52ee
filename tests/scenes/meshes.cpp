#include "tests/scenes/meshes.h"

#include <map>

namespace candela::test {
namespace {

using Index = std::uint32_t;

// The point midway along an edge, made once for the two triangles that share it.
class MidpointTable {
 public:
  explicit MidpointTable(std::vector<Vec3d>& points) : points_(points) {}

  Index midpoint(Index a, Index b) {
    const auto key = std::minmax(a, b);
    const auto [entry, is_new] = table_.try_emplace(key, static_cast<Index>(points_.size()));
    if (is_new) points_.push_back(normalize(points_[a] + points_[b]));
    return entry->second;
  }

 private:
  std::vector<Vec3d>& points_;
  std::map<std::pair<Index, Index>, Index> table_;
};

description::Mesh unit_icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  description::Mesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3d& p : mesh.positions) p = normalize(p);
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

void subdivide(description::Mesh& mesh) {
  MidpointTable midpoints(mesh.positions);
  std::vector<std::array<Index, 3>> smaller;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Index ab = midpoints.midpoint(a, b);
    const Index bc = midpoints.midpoint(b, c);
    const Index ca = midpoints.midpoint(c, a);
    smaller.insert(smaller.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(smaller);
}

template <class T>
void append_or_clear(std::vector<T>& a, const std::vector<T>& b, bool both) {
  if (both)
    a.insert(a.end(), b.begin(), b.end());
  else
    a.clear();
}

}  // namespace

description::Mesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  description::Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

description::Mesh quad(const Vec3d& corner, const Vec3d& edge1, const Vec3d& edge2) {
  description::Mesh mesh;
  mesh.positions = {corner, corner + edge1, corner + edge1 + edge2, corner + edge2};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

description::Mesh box(const Vec3d& lower, const Vec3d& upper) {
  const Vec3d e = upper - lower;
  const Vec3d x(e.x, 0, 0);
  const Vec3d y(0, e.y, 0);
  const Vec3d z(0, 0, e.z);
  description::Mesh mesh = quad(lower, y, x);
  mesh = merged(std::move(mesh), quad(lower, x, z));
  mesh = merged(std::move(mesh), quad(lower, z, y));
  mesh = merged(std::move(mesh), quad(lower + z, x, y));
  mesh = merged(std::move(mesh), quad(lower + y, z, x));
  return merged(std::move(mesh), quad(lower + x, y, z));
}

description::Mesh sphere(const Vec3d& centre, double radius, int subdivisions, bool has_normals) {
  description::Mesh mesh = unit_icosahedron();
  for (int i = 0; i < subdivisions; ++i) subdivide(mesh);
  if (has_normals) mesh.normals.assign(mesh.positions.begin(), mesh.positions.end());
  for (Vec3d& p : mesh.positions) p = centre + p * radius;
  return mesh;
}

description::Mesh merged(description::Mesh a, const description::Mesh& b) {
  const auto offset = static_cast<Index>(a.positions.size());
  append_or_clear(a.normals, b.normals, !a.normals.empty() && !b.normals.empty());
  append_or_clear(a.uvs, b.uvs, !a.uvs.empty() && !b.uvs.empty());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({i + offset, j + offset, k + offset});
  return a;
}

description::Mesh inside_out(description::Mesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  for (Vec3f& n : mesh.normals) n = -n;
  return mesh;
}

}  // namespace candela::test
