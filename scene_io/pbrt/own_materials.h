// Materials that pbrt has no word for, by candela's own parameters (token.h). `candela convert`
// writes them; beside them stands what is nearest in pbrt.
#pragma once

#include "scene_io/pbrt/materials.h"

namespace candela::pbrt {

// The model of "string model"; false where there is none. pbrt's own parameters count as known.
[[nodiscard]] bool set_own_model(MaterialReader& reader, description::Material& material);

// What candela adds to pbrt's models.
void add_own_parameters(MaterialReader& reader, description::Material& material);

}  // namespace candela::pbrt
