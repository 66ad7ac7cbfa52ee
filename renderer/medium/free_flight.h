// Free flights: how far a path's light goes before it collides with a medium, in three channels at
// once and through any number of media.
//
// Distances are sampled in one channel, picked by the path's throughput; the density of what came
// out is that over all channels, which is the balance heuristic over the choice [Wilkie14, eq. 6].
// So weights stay below the sum of the throughput's channels. Media that only absorb are no event:
// they dim by Beer's law.
#pragma once

#include <cstdint>

#include "renderer/math/constants.h"
#include "renderer/medium/medium.h"

namespace candela {

struct FreeFlight {
  Rgb choice{1, 0, 0};     // probability of each channel
  int channel = 0;         // in which distances are sampled
  float left = infinity;   // optical depth before the collision, in this channel
  Rgb sampled_depth{0};    // so far, in media that scatter
  Rgb absorbing_depth{0};  // and in those that do not
};

// `bits`: 32 random bits, which pick the channel and, stretched again, the depth.
[[nodiscard]] inline FreeFlight start_flight(const Rgb& throughput, std::uint32_t bits) {
  FreeFlight flight;
  const float sum = throughput.x + throughput.y + throughput.z;
  flight.choice = sum > 0 ? throughput / sum : Rgb(1.0f / 3);
  const double u = (static_cast<double>(bits) + 0.5) * 0x1p-32;
  double low = 0;
  double share = static_cast<double>(flight.choice.x);
  while (flight.channel < 2 && !(u < low + share)) {
    low += share;
    share = static_cast<double>(flight.choice[++flight.channel]);
  }
  // Rounded sums may leave u a little beyond the last channel, or pick one of no share.
  const double stretched = share > 0 ? std::min((u - low) / share, 1 - 0x1p-33) : 0.5;
  flight.left = static_cast<float>(-binary_logarithm(1 - stretched) * 0.693147180559945309417);
  return flight;
}

// Whether the flight does not end within `distance` of a medium that scatters.
[[nodiscard]] inline bool may_pass(const Medium& medium, float distance, const FreeFlight& flight) {
  return flight.left >= medium.extinction[flight.channel] * distance;
}

// Through `distance` of a medium: how far in it the flight ends, or infinity where it passes.
[[nodiscard]] inline float fly_through(const Medium& medium, float distance, FreeFlight& flight) {
  if (!medium.scatters()) {
    flight.absorbing_depth += optical_depth(medium.extinction, distance);
    return infinity;
  }
  Rgb depth = optical_depth(medium.extinction, distance);
  const float depth_here = depth[flight.channel];
  if (flight.left < depth_here) {
    const float way = std::min(flight.left / medium.extinction[flight.channel], distance);
    flight.sampled_depth += optical_depth(medium.extinction, way);
    return way;
  }
  flight.left -= depth_here;
  flight.sampled_depth += depth;
  return infinity;
}

// What the throughput is multiplied by where the flight met a surface, or nothing.
[[nodiscard]] inline Rgb passing_weight(const FreeFlight& flight) {
  Rgb weight(1);
  if (!is_black(flight.absorbing_depth)) weight = transmittance_of(flight.absorbing_depth);
  if (is_black(flight.sampled_depth)) return weight;
  Rgb passed = transmittance_of(flight.sampled_depth);
  const float probability = dot(flight.choice, passed);
  return probability > 0 ? weight * passed / probability : Rgb(0);
}

// What it is multiplied by where the flight ended in `medium`: light that scatters on.
[[nodiscard]] inline Rgb collision_weight(const FreeFlight& flight, const Medium& medium) {
  Rgb passed = transmittance_of(flight.sampled_depth);
  const float density = dot(flight.choice, passed * medium.extinction);
  if (!(density > 0)) return Rgb(0);
  return transmittance_of(flight.absorbing_depth) * passed * medium.scattering / density;
}

}  // namespace candela
