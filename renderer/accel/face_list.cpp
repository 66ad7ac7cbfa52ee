#include "renderer/accel/face_list.h"

#include <algorithm>

#include "renderer/accel/placement.h"
#include "renderer/base/floating_point_traps.h"
#include "renderer/scene/scene.h"

namespace candela {
namespace {

struct SceneTriangle {
  std::uint32_t geometry;
  std::uint32_t triangle;
  std::array<Vec3d, 3> corners;

  [[nodiscard]] const Vec3d& corner(std::size_t i) const { return corners[i % 3]; }
  [[nodiscard]] Vec3d perpendicular() const {
    return cross(corners[1] - corners[0], corners[2] - corners[0]);
  }
};

// Nothing where there are too many, or anything else.
std::vector<SceneTriangle> triangles_of(const Scene& scene,
                                        std::span<const GeometryHandle> geometries) {
  std::vector<SceneTriangle> triangles;
  for (const GeometryHandle handle : geometries) {
    const Geometry& geometry = scene.geometries[handle.index];
    const bool is_too_much =
        triangles.size() + geometry.triangles.size() > 2 * FaceList::most_faces;
    if (is_too_much || geometry.has_cutouts || !geometry.spheres.empty()) return {};
    for (std::uint32_t i = 0; i < geometry.triangles.size(); ++i) {
      const auto& [a, b, c] = geometry.triangles[i];
      const auto& at = geometry.positions;
      if (!is_usable_vertex(at[a]) || !is_usable_vertex(at[b]) || !is_usable_vertex(at[c]))
        continue;
      SceneTriangle t{handle.index, i, {Vec3d(at[a]), Vec3d(at[b]), Vec3d(at[c])}};
      if (dot(t.perpendicular(), t.perpendicular()) > 0) triangles.push_back(t);
    }
  }
  return triangles;
}

// Two triangles make a quad if they lie in one plane and no corner of it is reflex or straight.
struct Quad {
  std::array<Vec3d, 4> corners;  // the diagonal goes from 0 to 2
};
std::optional<Quad> quad_along(const SceneTriangle& a, std::size_t edge, const SceneTriangle& b,
                               std::size_t other_edge) {
  const bool share_edge =
      (a.corner(edge) == b.corner(other_edge + 1) && a.corner(edge + 1) == b.corner(other_edge)) ||
      (a.corner(edge) == b.corner(other_edge) && a.corner(edge + 1) == b.corner(other_edge + 1));
  if (!share_edge) return {};
  const Vec3d normal = normalize(a.perpendicular());
  const Quad quad{
      {a.corner(edge), b.corner(other_edge + 2), a.corner(edge + 1), a.corner(edge + 2)}};
  const Vec3d aside = quad.corners[1] - quad.corners[0];
  constexpr double rounding = 1e-7;  // of floats
  if (std::abs(dot(normal, aside)) > rounding * length(aside)) return {};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d before = quad.corners[(i + 1) % 4] - quad.corners[i];
    const Vec3d after = quad.corners[(i + 2) % 4] - quad.corners[(i + 1) % 4];
    if (!(dot(cross(before, after), normal) > 0)) return {};
  }
  return quad;
}
std::optional<Quad> quad_of(const SceneTriangle& a, const SceneTriangle& b) {
  if (a.geometry != b.geometry) return {};
  for (std::size_t edge = 0; edge < 3; ++edge)
    for (std::size_t other_edge = 0; other_edge < 3; ++other_edge)
      if (const std::optional<Quad> quad = quad_along(a, edge, b, other_edge)) return quad;
  return {};
}

// A barycentric of a triangle: 1 at a corner, 0 along the edge across from it.
void put_triangle(const SceneTriangle& t, const Vec3d& origin, std::size_t which,
                  FaceTriangles& face) {
  for (std::size_t corner = 1; corner < 3; ++corner) {
    const Vec3d foot = t.corner(corner + 1);
    const Vec3d direction = cross(t.perpendicular(), t.corner(corner + 2) - foot);
    const Vec3d scaled = direction / dot(direction, t.corner(corner) - foot);
    const std::size_t j = 2 * which + corner - 1;
    face.x[j] = static_cast<float>(scaled.x);
    face.y[j] = static_cast<float>(scaled.y);
    face.z[j] = static_cast<float>(scaled.z);
    face.at_corner[j] = static_cast<float>(dot(scaled, origin - foot));
  }
  face.geometry[which] = t.geometry;
  face.triangle[which] = t.triangle;
}

// `corners`: three or four, counter-clockwise about the normal.
void put_face(std::span<const Vec3d> corners, const Vec3d& normal, FaceGroups& faces) {
  const std::size_t lane = faces.size % block_size;
  if (lane == 0) faces.groups.emplace_back();
  FaceGroup& group = faces.groups.back();
  group.corner.set(lane, Vec3f(corners[0]));
  group.normal.set(lane, Vec3f(normal));
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d from = corners[i % corners.size()];
    const Vec3d inward = normalize(cross(normal, corners[(i + 1) % corners.size()] - from));
    group.inward[i].set(lane, Vec3f(inward));
    group.distance[i][lane] = static_cast<float>(dot(inward, corners[0] - from));
  }
  for (const Vec3d& corner : corners)
    faces.reach = std::max(faces.reach, static_cast<float>(sum_of_absolutes(corner)));
  ++faces.size;
}

}  // namespace

FaceList::FaceList(const Scene& scene, std::span<const GeometryHandle> geometries) {
  const std::vector<SceneTriangle> all = triangles_of(scene, geometries);
  std::vector<bool> is_taken(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_taken[i]) continue;
    if (size() == most_faces) {
      clear();
      return;
    }
    const Vec3d normal = normalize(all[i].perpendicular());
    std::optional<Quad> quad;
    std::size_t partner = i + 1;
    for (; partner < all.size(); ++partner) {
      if (is_taken[partner]) continue;
      quad = quad_of(all[i], all[partner]);
      if (quad) break;
    }
    if (quad) {
      is_taken[partner] = true;
      put_face(quad->corners, normal, faces_);
      const Vec3d& corner = quad->corners[0];
      FaceTriangles& face = triangles_.emplace_back();
      face.corner = Vec3f(corner);
      face.across = Vec3f(cross(normal, quad->corners[2] - corner));
      put_triangle(all[i], corner, 0, face);
      put_triangle(all[partner], corner, 1, face);
    } else {
      put_face(all[i].corners, normal, faces_);
      FaceTriangles& face = triangles_.emplace_back();
      face.corner = Vec3f(all[i].corners[0]);
      put_triangle(all[i], all[i].corners[0], 0, face);
    }
  }
  if (faces_.reach > most_reach) clear();
}

void FaceList::clear() {
  faces_ = {};
  triangles_.clear();
}

FaceList::BlockAnswer FaceList::intersect(const RayBlock& rays, LaneMask lanes) const {
  const FloatingPointTraps traps(Traps::Off);  // planes that rays never meet
  const FaceLanes nearest = find_nearest_faces(faces_, rays);
  BlockAnswer answer{{}, open_lanes(nearest) & lanes};
  const LaneMask met = lanes & ~answer.open & lanes_with_face(nearest);
  set_hits(triangles_, rays, nearest, met, answer.hits);
  return answer;
}

FaceList::BlockOcclusion FaceList::occluded(const RayBlock& rays, LaneMask lanes) const {
  constexpr std::uint32_t fewest_of_block = 5;
  BlockOcclusion answer{};
  if (lane_count(lanes) < fewest_of_block) {
    for_each_lane(lanes, [&](std::uint32_t i) {
      const std::optional<bool> known = occluded(rays[i]);
      answer.occluded |= flag(known.value_or(false)) << i;
      answer.open |= flag(!known) << i;
    });
    return answer;
  }
  const FloatingPointTraps traps(Traps::Off);
  const FaceLanes nearest = find_nearest_faces(faces_, rays);
  answer.occluded = lanes_with_face(nearest) & lanes;
  answer.open = open_lanes(nearest) & lanes & ~answer.occluded;
  return answer;
}

std::optional<Hit> FaceList::intersect(const Ray& ray) const {
  const FloatingPointTraps traps(Traps::Off);
  const NearestFace nearest = find_nearest_face(faces_, ray);
  if (nearest.is_open) return {};
  if (nearest.face == FaceLanes::none) return Hit{};
  return hit_of(triangles_[nearest.face], ray, nearest.t);
}

std::optional<bool> FaceList::occluded(const Ray& ray) const {
  const FloatingPointTraps traps(Traps::Off);
  const NearestFace nearest = find_nearest_face(faces_, ray);
  if (nearest.face != FaceLanes::none) return true;
  if (nearest.is_open) return {};
  return false;
}

}  // namespace candela
