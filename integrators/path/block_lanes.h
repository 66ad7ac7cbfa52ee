// From a block's paths to lanes that step together (plain_lanes.h), and back, where each path keeps
// its lane: whole arrays are copied in vectors.
#pragma once

#include "integrators/path/block_numbers.h"
#include "integrators/path/path_block.h"
#include "integrators/path/plain_lanes.h"

namespace candela {

// All paths of a block at the camera.
void begin_paths(PathLanes& paths);

// Of the given lanes' paths all that a block has by component; surfaces and lamps are still to
// come.
void put_paths(const PathBlock& block, const BlockNumbers& numbers, std::uint32_t bounce,
               LaneMask lanes, PlainLanes& plain);

// The light samples of the given lanes become the block's shadow rays.
void take_shadow_rays(const LightSampleLanes& samples, LaneMask lanes, PathBlock& block);

// The paths of the given lanes go on.
void take_scattered(const PlainLanes& plain, LaneMask lanes, PathBlock& block);

// Adds what the shadow rays of the given lanes bring.
void add_unshadowed(LaneMask lanes, PathBlock& block);

}  // namespace candela
