// OBJ, MTL, PLY.
#include "scene_io/obj/read_mtl.h"
#include "scene_io/obj/read_obj.h"
#include "scene_io/ply/read_ply.h"
#include "tests/fuzz/check_errors.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/scene_folder.h"
#include "tests/scene_io/obj/check_model.h"

namespace candela::fuzz {
namespace {

std::string try_obj_with(std::string_view bytes, obj::MtlUse use) {
  obj::ObjOptions options;
  options.materials = use;
  Diagnostics diagnostics;
  obj::ObjModel model =
      obj::parse_obj(scene_folder() + "fuzzed.obj", std::string(bytes), options, diagnostics);
  if (model.meshes.empty() && use == obj::MtlUse::Ignore) return fault_of_failure(diagnostics);
  const std::string fault = obj::fault_of(model);
  return fault.empty() ? fault_of(diagnostics) : fault;
}

std::string try_mtl_with(std::string_view bytes, obj::MtlUse use) {
  Diagnostics diagnostics;
  obj::MtlLibrary library = obj::parse_mtl(scene_folder() + "fuzzed.mtl", bytes, use, diagnostics);
  obj::ObjModel model;
  model.materials = std::move(library.materials);
  model.images = std::move(library.images);
  const std::string fault = obj::fault_of(model);
  return fault.empty() ? fault_of(diagnostics) : fault;
}

}  // namespace

std::string try_obj(std::string_view bytes) {
  const std::string fault = try_obj_with(bytes, obj::MtlUse::Ignore);
  return fault.empty() ? try_obj_with(bytes, obj::MtlUse::Full) : fault;
}

std::string try_mtl(std::string_view bytes) {
  const std::string fault = try_mtl_with(bytes, obj::MtlUse::Lab);
  return fault.empty() ? try_mtl_with(bytes, obj::MtlUse::Full) : fault;
}

std::string try_ply(std::string_view bytes) {
  Diagnostics diagnostics;
  const auto mesh = ply::parse_ply("fuzzed.ply", bytes, {}, diagnostics);
  if (!mesh) return fault_of_failure(diagnostics);
  const std::string fault = obj::fault_of(*mesh, 0);
  return fault.empty() ? fault_of(diagnostics) : fault;
}

}  // namespace candela::fuzz
