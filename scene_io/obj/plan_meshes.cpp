#include "scene_io/obj/build_meshes.h"

namespace candela::obj {
namespace {

// Calls body(run) for each stretch of faces between switches, and on_switch(s) for each switch.
template <class OnSwitch, class Body>
void for_each_run(const ObjData& data, const OnSwitch& on_switch, const Body& body) {
  for (const Chunk& chunk : data.chunks) {
    FaceRun run{&chunk, 0, 0, 0, 0};
    const auto end_run = [&](std::uint32_t face, std::uint32_t corner) {
      run.face_end = face;
      if (run.face_end > run.face_begin) body(run);
      run.face_begin = face;
      run.corner_begin = corner;
    };
    for (const Switch& change : chunk.switches) {
      end_run(change.face, change.corner);
      on_switch(change);
    }
    end_run(static_cast<std::uint32_t>(chunk.faces.size()),
            static_cast<std::uint32_t>(chunk.corners.size()));
  }
}

void add_run(MeshPlan& plan, const FaceRun& run) {
  plan.runs.push_back(run);
  plan.face_count += run.face_end - run.face_begin;
}

}  // namespace

MeshPlan plan_whole(const ObjData& data) {
  MeshPlan plan;
  std::uint32_t shape = 0;
  for_each_run(
      data, [&](const Switch& change) { shape += change.kind == Switch::Kind::Shape ? 1 : 0; },
      [&](FaceRun run) {
        run.shape = shape;
        add_run(plan, run);
      });
  return plan;
}

std::vector<MeshPlan> plan_by_material(const ObjData& data, std::size_t material_count,
                                       const MaterialOfName& material_of_name) {
  std::vector<MeshPlan> plans(material_count + 1);
  for (std::size_t i = 0; i < material_count; ++i) {
    plans[i].material = static_cast<std::uint32_t>(i);
  }
  std::size_t current = material_count;
  for_each_run(
      data,
      [&](const Switch& change) {
        if (change.kind != Switch::Kind::Material) return;
        const std::optional<std::uint32_t> material = material_of_name(change.name);
        current = material ? *material : material_count;
      },
      [&](const FaceRun& run) { add_run(plans[current], run); });
  return plans;
}

std::size_t first_offset(const MeshPlan& plan) {
  if (plan.runs.empty()) return 0;
  const FaceRun& run = plan.runs.front();
  return run.chunk->begin + run.chunk->faces[run.face_begin].offset;
}

}  // namespace candela::obj
