#include "renderer/scene/split_triangles.h"

#include <algorithm>
#include <map>

#include "renderer/scene/triangle_sort.h"

namespace candela {
namespace {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;

constexpr double shortest_cut = 4;

// What would be cut into more pieces stays whole: slivers become ever thinner ones by it. Of a
// triangle that is not one there are some twenty for each factor of ten.
constexpr std::size_t most_pieces = 16384;
constexpr std::size_t most_pieces_of_mesh = std::size_t{1} << 20;

double distance_from_centre(const Vec3d& a, const Vec3d& b) {
  const Vec3d along = b - a;
  const double t = std::clamp(-dot(a, along) / dot(along, along), 0.0, 1.0);
  return length(a + along * t);
}

class Splitter {
 public:
  Splitter(const description::Mesh& mesh, const Transform& to_normalised) : mesh_(mesh) {
    for (const Vec3d& p : mesh.positions) normalised_.push_back(to_normalised.point(p));
  }

  description::Mesh run() {
    const auto triangles = std::move(mesh_.triangles);
    whole_ = triangles.size();
    const auto materials = std::move(mesh_.materials);
    mesh_.triangles.clear();
    mesh_.materials.clear();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      split(triangles[i]);
      if (materials.size() == triangles.size())
        mesh_.materials.resize(mesh_.triangles.size(), materials[i]);
    }
    if (materials.size() != triangles.size()) mesh_.materials = materials;
    return std::move(mesh_);
  }

 private:
  // Of a - b, whichever way round it is given: 0 where it may stay.
  [[nodiscard]] double length_to_cut(Index a, Index b) const {
    const Vec3d& p = normalised_[std::min(a, b)];
    const Vec3d& q = normalised_[std::max(a, b)];
    if (!is_in_reach(p) || !is_in_reach(q)) return 0;
    const double edge = length(q - p);
    return edge > shortest_cut && edge > distance_from_centre(p, q) ? edge : 0;
  }

  void split(const Corners& first) {
    const std::size_t before = mesh_.triangles.size();
    std::vector<Corners> waiting{first};
    while (!waiting.empty()) {
      const std::size_t pieces = mesh_.triangles.size() - before + waiting.size();
      if (pieces > most_pieces || before + pieces > most_pieces_of_mesh + whole_) {
        mesh_.triangles.resize(before);
        mesh_.triangles.push_back(first);
        return;
      }
      const Corners t = waiting.back();
      waiting.pop_back();
      std::size_t longest = 0;
      std::array<double, 3> lengths{};
      for (std::size_t k = 0; k < 3; ++k) {
        lengths[k] = length_to_cut(t[k], t[(k + 1) % 3]);
        if (lengths[k] > lengths[longest]) longest = k;
      }
      if (lengths[longest] == 0) {
        mesh_.triangles.push_back(t);
        continue;
      }
      const Index a = t[longest];
      const Index b = t[(longest + 1) % 3];
      const Index c = t[(longest + 2) % 3];
      const Index middle = middle_of(a, b);
      waiting.push_back({middle, b, c});
      waiting.push_back({a, middle, c});
    }
  }

  Index middle_of(Index a, Index b) {
    const auto key = std::minmax(a, b);
    const auto [at, is_new] = middles_.try_emplace(key, static_cast<Index>(normalised_.size()));
    if (!is_new) return at->second;
    const auto halve = [](auto& values, const std::pair<Index, Index>& edge) {
      if (!values.empty()) values.push_back((values[edge.first] + values[edge.second]) * 0.5f);
    };
    mesh_.positions.push_back((mesh_.positions[a] + mesh_.positions[b]) * 0.5);
    normalised_.push_back((normalised_[a] + normalised_[b]) * 0.5);
    halve(mesh_.normals, key);
    halve(mesh_.uvs, key);
    return at->second;
  }

  description::Mesh mesh_;
  std::vector<Vec3d> normalised_;
  std::map<std::pair<Index, Index>, Index> middles_;
  std::size_t whole_ = 0;  // triangles, before any was cut
};

// Edges of what lies within this are no longer than shortest_cut.
bool is_near(const Vec3d& p) {
  constexpr double reach = 1.15;
  return std::abs(p.x) <= reach && std::abs(p.y) <= reach && std::abs(p.z) <= reach;
}

}  // namespace

std::optional<description::Mesh> split_large_triangles(const description::Mesh& mesh,
                                                       const Transform& to_normalised) {
  if (std::all_of(mesh.positions.begin(), mesh.positions.end(),
                  [&](const Vec3d& p) { return is_near(to_normalised.point(p)); }))
    return std::nullopt;
  description::Mesh split = Splitter(mesh, to_normalised).run();
  if (split.triangles.size() == mesh.triangles.size()) return std::nullopt;
  return split;
}

}  // namespace candela
