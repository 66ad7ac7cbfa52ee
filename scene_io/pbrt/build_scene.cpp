#include "scene_io/pbrt/build_scene.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "renderer/base/parallel.h"
#include "scene_io/pbrt/camera.h"
#include "scene_io/pbrt/lights.h"
#include "scene_io/pbrt/shape.h"
#include "scene_io/pbrt/shape_materials.h"
#include "scene_io/pbrt/transforms.h"

namespace candela::pbrt {
namespace {

using description::MaterialHandle;
using description::Mesh;
using description::MeshHandle;

constexpr std::size_t most_instances = std::size_t{1} << 22;

// One mesh of the scene, shared by all shapes with its key.
struct MeshJob {
  ShapeStatement* shape = nullptr;  // the first of them
  bool needs_uvs = false;
  bool keeps_sphere = false;
  Diagnostics diagnostics;
  MeshHandle handle;      // invalid: in error or left out
  std::size_t count = 1;  // of pbrt's shapes in it
};

struct PlacedShape {
  ShapeStatement* shape = nullptr;
  std::size_t job = none;
};

using UsesByObject = std::map<std::string_view, std::vector<const ObjectUse*>>;

UsesByObject uses_by_object(const Program& program) {
  UsesByObject uses;
  for (const ObjectUse& use : program.object_uses) uses[use.name].push_back(&use);
  return uses;
}

// Whether all that a shape of an object is placed by are similarities.
bool keeps_shape(const ShapeStatement& shape, const UsesByObject& uses, std::string_view object) {
  const auto found = uses.find(object);
  if (found == uses.end()) return true;
  return std::all_of(found->second.begin(), found->second.end(), [&](const ObjectUse* use) {
    return similarity_scale(use->world_from_instance * shape.world_from_object) > 0;
  });
}

// All shapes' meshes, made in parallel, in the scene in the order of the shapes.
class Meshes {
 public:
  explicit Meshes(Context& context) : context_(context) {}

  // The shapes in the order in which they are added.
  // `keeps_sphere`: nothing that it is placed by stretches it.
  void add(ShapeStatement& shape, bool keeps_sphere) {
    if (is_curved(shape) && !(keeps_sphere && is_whole_sphere(shape))) ++curved_count_;
    const bool needs_uvs = has_texture(context_.program, shape);
    curved_patch_count_ += curved_patch_count(shape, needs_uvs);
    const std::string key =
        mesh_key(shape, {context_.scene.path, needs_uvs, finest_segments, keeps_sphere});
    std::size_t job = jobs_.size();
    if (!key.empty()) job = job_of_.try_emplace(key, job).first->second;
    if (job == jobs_.size()) jobs_.push_back({&shape, needs_uvs, keeps_sphere, {}, {}, 1});
    shapes_.push_back({&shape, job});
  }

  void make() {
    const std::uint32_t segments = segments_for(curved_count_, curved_patch_count_);
    std::vector<std::optional<ShapeMesh>> meshes(jobs_.size());
    parallel_for(jobs_.size(), [&](std::size_t i) {
      MeshJob& job = jobs_[i];
      const Report report(job.diagnostics);
      const ShapeOptions options{context_.scene.path, job.needs_uvs, segments, job.keeps_sphere};
      meshes[i] = make_mesh(*job.shape, options, report);
      for (Parameter& parameter : job.shape->statement.parameters)
        if (parameter.numbers.size() > 16) parameter.numbers = {};  // it is in the mesh
    });
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      context_.report.append(jobs_[i].diagnostics);
      if (!meshes[i]) continue;
      jobs_[i].handle = MeshHandle(context_.scene.meshes.size());
      jobs_[i].count = meshes[i]->count;
      note_file(*jobs_[i].shape, meshes[i]->mesh);
      context_.scene.meshes.push_back(std::move(meshes[i]->mesh));
    }
  }

  [[nodiscard]] MeshHandle of(std::size_t shape) const { return job(shape).handle; }
  // How many shapes pbrt has in its place.
  [[nodiscard]] std::size_t count_of(std::size_t shape) const { return job(shape).count; }

 private:
  [[nodiscard]] const MeshJob& job(std::size_t shape) const { return jobs_[shapes_[shape].job]; }

  // A PLY file's mesh is named by it.
  void note_file(const ShapeStatement& shape, const Mesh& mesh) {
    auto& files = context_.scene.files;
    if (shape.statement.type == "plymesh") files.push_back(mesh.name);
  }

  Context& context_;
  std::vector<MeshJob> jobs_;
  std::vector<PlacedShape> shapes_;
  std::map<std::string, std::size_t> job_of_;
  std::size_t curved_count_ = 0, curved_patch_count_ = 0;
};

class SceneBuilder {
 public:
  explicit SceneBuilder(Context& context)
      : context_(context),
        textures_(context),
        materials_(context, textures_),
        media_(context),
        shape_materials_(context, textures_, materials_, media_),
        meshes_(context) {}

  void build() {
    Program& program = context_.program;
    if (!has_room()) return;
    context_.imaging_ratio = read_film(context_);
    read_camera(context_);
    context_.scene.cameras.back().medium = media_.of(program.around_camera);
    read_lights(context_);
    materials_.read_all();
    for (ShapeStatement& shape : program.shapes)
      meshes_.add(shape, similarity_scale(shape.world_from_object) > 0);
    const UsesByObject uses = uses_by_object(program);
    for (auto& [name, shapes] : program.objects)
      for (ShapeStatement& shape : shapes) meshes_.add(shape, keeps_shape(shape, uses, name));
    meshes_.make();
    place_all();
    textures_.check_unused();
    media_.check_unused();
  }

 private:
  struct Part {
    MeshHandle mesh;
    MaterialHandle material;
    const ShapeStatement* shape = nullptr;
  };

  using Objects = std::map<std::string, std::vector<Part>>;

  // The next of the shapes as they were added.
  std::optional<Part> next_part(ShapeStatement& shape) {
    const std::size_t index = next_shape_++;
    const MeshHandle handle = meshes_.of(index);
    if (!handle) return std::nullopt;
    Mesh& mesh = context_.scene.meshes[handle.index];
    const MaterialHandle material = shape_materials_.of(shape, mesh, meshes_.count_of(index));
    if (mesh.materials.empty()) mesh.materials = {material};
    return Part{handle, material, &shape};
  }

  void place(const Part& part, const Transform& world_from_object, const SourceSpan& span) {
    const Mesh& mesh = context_.scene.meshes[part.mesh.index];
    const MaterialHandle override =
        mesh.materials[0] == part.material ? MaterialHandle() : part.material;
    context_.scene.instances.push_back({part.mesh, world_from_object, override, span});
  }

  void place_all() {
    for (ShapeStatement& shape : context_.program.shapes)
      if (const auto part = next_part(shape))
        place(*part, shape.world_from_object, shape.statement.place.span());
    Objects objects;
    for (auto& [name, shapes] : context_.program.objects)
      for (ShapeStatement& shape : shapes) {
        auto& parts = objects[name];
        if (const auto part = next_part(shape)) parts.push_back(*part);
      }
    for (const ObjectUse& use : context_.program.object_uses) place_object(use, objects);
  }

  // Counted before any is made: a short file can ask for more than memory holds.
  bool has_room() {
    std::size_t count = context_.program.shapes.size();
    for (const ObjectUse& use : context_.program.object_uses) {
      const auto found = context_.program.objects.find(use.name);
      if (found != context_.program.objects.end()) count += found->second.size();
      if (count <= most_instances) continue;
      context_.report.error(use.place, fmt::format("more than {} instances", most_instances));
      return false;
    }
    return true;
  }

  void place_object(const ObjectUse& use, const Objects& objects) {
    const auto& known = context_.program.objects;
    if (!known.contains(use.name))
      return context_.report.error(use.place,
                                   fmt::format("there is no object {}{}", text::quoted(use.name),
                                               context_.report.did_you_mean_key(use.name, known)));
    const auto found = objects.find(use.name);
    if (found == objects.end()) return;  // without shapes
    const SourceSpan span = use.place.span();
    for (const Part& part : found->second) {
      const Transform world_from_object = use.world_from_instance * part.shape->world_from_object;
      if (!has_finite_numbers(world_from_object) || is_singular(world_from_object.linear))
        return context_.report.error(
            use.place,
            "the transform of this instance is singular or has numbers that are not "
            "finite");
      place(part, world_from_object, span);
    }
  }

  Context& context_;
  Textures textures_;
  Materials materials_;
  Media media_;
  ShapeMaterials shape_materials_;
  Meshes meshes_;
  std::size_t next_shape_ = 0;
};

}  // namespace

void build_scene(Context& context) {
  SceneBuilder(context).build();
}

}  // namespace candela::pbrt
