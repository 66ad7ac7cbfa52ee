// Why compiling leaves out what it leaves out, and how often it did.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>

namespace candela {

// In the order in which they are told.
enum class DropReason : std::uint8_t {
  BlackLights,
  LampInstances,
  SingleInstances,
  InstancesOutOfRange,
  InstancesOfTriangles,
  UnwornMaterials,
  ClearMedia,
  UnplacedMeshes,
  RedundantNormals,
  SpheresOutOfReach,
  SpheresTooSmall,
  ClearSpheres,
  UnreadTextureCoordinates,
  TrianglesTooSmall,
  ClearTriangles,
  TrianglesOutOfReach,
  FlatTriangles,
  UnusedVertices,
};
inline constexpr std::size_t drop_reasons = std::size_t(DropReason::UnusedVertices) + 1;

// As in "12 triangles without area".
[[nodiscard]] std::string_view name_of(DropReason reason);

// Of triangles and spheres.
[[nodiscard]] bool is_of_surfaces(DropReason reason);

// Whether what is left out may be meant to be seen: that is warned of.
[[nodiscard]] bool may_be_missed(DropReason reason);

using DropCounts = std::map<DropReason, std::uint64_t>;

}  // namespace candela
