// What lights the scene from afar: `Skyboxes`, `Environment`, and the ambient term.
#pragma once

#include "scene_io/lab3/fields.h"

namespace candela::lab3 {

// lab3's six pictures; only the first list counts.
void read_skyboxes(Reader& reader, const Fields& root);

// The extension's map or constant.
void read_environment(Reader& reader, const Fields& root);

// AmbientIntensity, or what the options put in its place: kept for whitted, and, where no other
// environment is given, a constant one that camera rays do not see
// (docs/scene_format.md, "Ambient light").
// Comes last: it depends on what else the file holds.
void read_ambient(Reader& reader, const Fields& root);

}  // namespace candela::lab3
