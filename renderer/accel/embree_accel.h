// Embree behind the Accelerator concept.
#pragma once

#include <memory>

#include "renderer/accel/accelerator.h"
#include "renderer/scene/scene.h"

namespace candela {

struct EmbreeOptions {
  // RTC_SCENE_FLAG_ROBUST: no ray slips between triangles that share an edge, and none meets the
  // face that it left (docs/accuracy_stress.md tells what happens without, and what it costs).
  bool robust = true;
  // Blocks of rays go to Embree as packets, from as many rays on as that pays.
  bool packets = true;
  // Trees as good as Embree builds them (RTC_BUILD_QUALITY_HIGH); false: RTC_BUILD_QUALITY_MEDIUM.
  bool high_quality = true;
  // Scenes of few triangles are looked at face by face, as are walls of rooms with few dense things
  // in them, where that pays (few_faces.h); Embree is asked for the rest, and where rounding
  // matters.
  bool faces = false;
  bool faces_always = false;  // of such rooms, whether it pays or not; for comparisons
  // Building fails as if out of memory beyond this; 0: no limit.
  std::size_t memory_limit_bytes = 0;
};

// Refers to the scene and its arrays (shared buffers): the scene outlives it and does not move.
class EmbreeAccel {
 public:
  // Built by the current arena's threads (base/parallel.h). Throws std::bad_alloc where memory or
  // the limit does not suffice, std::runtime_error for any other complaint of Embree's.
  explicit EmbreeAccel(const Scene& scene, EmbreeOptions options = {});
  EmbreeAccel(EmbreeAccel&&) noexcept;
  EmbreeAccel& operator=(EmbreeAccel&&) noexcept;
  ~EmbreeAccel();

  // Callers have checked is_traceable(ray).
  [[nodiscard]] Hit intersect(const Ray& ray) const;
  [[nodiscard]] bool occluded(const Ray& ray) const;
  [[nodiscard]] HitBlock intersect(const RayBlock& rays, LaneMask lanes, Coherence coherence) const;
  [[nodiscard]] LaneMask occluded(const RayBlock& rays, LaneMask lanes) const;
  // Whether what a block's rays are told, incoherent ones and shadow rays, depends on none of the
  // others in it: so where there is a list of faces.
  [[nodiscard]] bool allows_any_company() const;
  // By Embree alone, whatever the options say.
  [[nodiscard]] Hit intersect_by_tree(const Ray& ray) const;
  [[nodiscard]] bool occluded_by_tree(const Ray& ray) const;
  // How many faces and spheres are looked at one by one, 0 where there is no list of them; and how
  // many boxes there are around the rest, 0 where there is none.
  [[nodiscard]] std::size_t face_count() const;
  [[nodiscard]] std::size_t sphere_count() const;
  [[nodiscard]] std::size_t box_count() const;
  // What Embree has allocated; the scene's own arrays are not counted.
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// "3.13.5" or the like, for reports.
[[nodiscard]] const char* embree_version();

}  // namespace candela
