// Renders held against what must come out, number by number.
#pragma once

#include <functional>
#include <string>

#include "tests/stress/undisturbed.h"

namespace candela::test {

struct ClosedForm {
  double allowed_relative = 1e-6;  // of rounding, or of what is known of the expectation
  double resolution = 2e-3;        // what the test must be able to see: its relative standard error
  double level = 1e-4;             // for one false alarm
};

// The mean over all pixels and channels: t-test of the renders.
void expect_mean(const Renders& renders, double expected, const ClosedForm& options = {});

// Every pixel's mean of the channels; the level holds over all of them [Sidak67], the resolution
// for their root mean square.
void expect_pixels(const Renders& renders, const std::function<double(int x, int y)>& expected,
                   const ClosedForm& options = {});

}  // namespace candela::test
