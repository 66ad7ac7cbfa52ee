#include "renderer/scene/drop_reason.h"

namespace candela {

std::string_view name_of(DropReason reason) {
  switch (reason) {
    case DropReason::BlackLights:
      return "black lights";
    case DropReason::LampInstances:
      return "instances that are lamps";
    case DropReason::SingleInstances:
      return "instances that are the only one of their mesh";
    case DropReason::InstancesOutOfRange:
      return "instances that are too small or too large";
    case DropReason::InstancesOfTriangles:
      return "instances that only their triangles can be placed of";
    case DropReason::UnwornMaterials:
      return "materials that nothing wears";
    case DropReason::ClearMedia:
      return "media that are clear or nowhere";
    case DropReason::UnplacedMeshes:
      return "meshes without a place";
    case DropReason::RedundantNormals:
      return "normals that say what the winding says";
    case DropReason::SpheresOutOfReach:
      return "spheres that are not finite or too far away";
    case DropReason::SpheresTooSmall:
      return "spheres that are too small beside the scene";
    case DropReason::ClearSpheres:
      return "spheres that are wholly clear";
    case DropReason::UnreadTextureCoordinates:
      return "texture coordinates that nothing reads";
    case DropReason::TrianglesTooSmall:
      return "triangles that are too small beside the scene";
    case DropReason::ClearTriangles:
      return "triangles that are wholly clear";
    case DropReason::TrianglesOutOfReach:
      return "triangles with vertices that are not finite or too far away";
    case DropReason::FlatTriangles:
      return "triangles without area";
    case DropReason::UnusedVertices:
      return "vertices that no triangle needs";
  }
  return "";
}

bool is_of_surfaces(DropReason reason) {
  switch (reason) {
    case DropReason::SpheresOutOfReach:
    case DropReason::SpheresTooSmall:
    case DropReason::ClearSpheres:
    case DropReason::TrianglesTooSmall:
    case DropReason::ClearTriangles:
    case DropReason::TrianglesOutOfReach:
    case DropReason::FlatTriangles:
      return true;
    default:
      return false;
  }
}

bool may_be_missed(DropReason reason) {
  switch (reason) {
    case DropReason::InstancesOutOfRange:
    case DropReason::SpheresOutOfReach:
    case DropReason::SpheresTooSmall:
    case DropReason::TrianglesTooSmall:
    case DropReason::TrianglesOutOfReach:
      return true;
    default:
      return false;
  }
}

}  // namespace candela
