#include "renderer/scene/drop_reason.h"

#include <array>

namespace candela {
namespace {

struct Row {
  DropReason reason;
  std::string_view name;
  bool is_of_surfaces = false;
  bool may_be_missed = false;
};

constexpr bool is_surface = true, not_surface = false, is_missed = true;

constexpr std::array rows = {
    Row{DropReason::BlackLights, "black lights"},
    Row{DropReason::LampInstances, "instances that are lamps"},
    Row{DropReason::SingleInstances, "instances that are the only one of their mesh"},
    Row{DropReason::InstancesOutOfRange, "instances that are too small or too large", not_surface,
        is_missed},
    Row{DropReason::InstancesOfTriangles, "instances that only their triangles can be placed of"},
    Row{DropReason::UnwornMaterials, "materials that nothing wears"},
    Row{DropReason::ClearMedia, "media that are clear or nowhere"},
    Row{DropReason::UnplacedMeshes, "meshes without a place"},
    Row{DropReason::RedundantNormals, "normals that say what the winding says"},
    Row{DropReason::SpheresOutOfReach, "spheres that are not finite or too far away", is_surface,
        is_missed},
    Row{DropReason::SpheresTooSmall, "spheres that are too small beside the scene", is_surface,
        is_missed},
    Row{DropReason::ClearSpheres, "spheres that are wholly clear", is_surface},
    Row{DropReason::UnreadTextureCoordinates, "texture coordinates that nothing reads"},
    Row{DropReason::TrianglesTooSmall, "triangles that are too small beside the scene", is_surface,
        is_missed},
    Row{DropReason::ClearTriangles, "triangles that are wholly clear", is_surface},
    Row{DropReason::TrianglesOutOfReach,
        "triangles with vertices that are not finite or too far away", is_surface, is_missed},
    Row{DropReason::FlatTriangles, "triangles without area", is_surface},
    Row{DropReason::UnusedVertices, "vertices that no triangle needs"},
};

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].reason != DropReason(i)) return false;
  return rows.size() == drop_reasons;
}
static_assert(are_in_order());

const Row& row_of(DropReason reason) {
  return rows[static_cast<std::size_t>(reason)];
}

}  // namespace

std::string_view name_of(DropReason reason) {
  return row_of(reason).name;
}

bool is_of_surfaces(DropReason reason) {
  return row_of(reason).is_of_surfaces;
}

bool may_be_missed(DropReason reason) {
  return row_of(reason).may_be_missed;
}

}  // namespace candela
