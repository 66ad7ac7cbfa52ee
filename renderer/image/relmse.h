// The relative error of pictures, as all that measures, states or lowers it weighs it.
#pragma once

namespace candela {

// What is added to a squared value that an error is held against, so that black pixels do not
// decide alone: a share of the picture's squared mean, for the error not to change with its scale.
[[nodiscard]] constexpr double relmse_epsilon(double picture_mean) {
  return 1e-2 * picture_mean * picture_mean;
}

}  // namespace candela
