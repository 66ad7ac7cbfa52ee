// The accelerator a render uses, chosen once.
#pragma once

#include <variant>

#include "renderer/accel/bvh_accel.h"
#include "renderer/accel/embree_accel.h"

namespace candela {

// Auto: what is fastest, Embree with a list of faces for scenes of few (face_list.h).
enum class AcceleratorKind : std::uint8_t { Auto, Embree, Bvh };

using AnyAccelerator = std::variant<EmbreeAccel, BvhAccel>;

// Only the one that is asked for is built, by the current arena's threads. Throws std::bad_alloc
// where memory (or the options' limit) does not suffice: the command line's exit 5.
[[nodiscard]] inline AnyAccelerator build_accelerator(const Scene& scene, AcceleratorKind kind,
                                                      EmbreeOptions embree = {}) {
  if (kind == AcceleratorKind::Bvh) return BvhAccel(scene);
  embree.faces = kind == AcceleratorKind::Auto;
  return EmbreeAccel(scene, embree);
}

[[nodiscard]] inline std::size_t memory_bytes(const AnyAccelerator& accelerator) {
  return std::visit([](const auto& a) { return a.memory_bytes(); }, accelerator);
}

}  // namespace candela
