// Inputs of tools as rows of an array: x y z (m), qx qy qz qw (unit quaternion), squeeze, pedal, in
// hand (0 or 1).
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "simulation/simulation.h"

namespace resect::python {

inline constexpr int kToolColumns = 10;

using Rows = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

// Throws Error unless the array is [tools, 10] and each quaternion has about the length 1.
std::vector<ToolInput> inputsFrom(const Rows& rows, std::size_t tools);
pybind11::array_t<double> rowsFrom(const std::vector<ToolInput>& inputs);

}  // namespace resect::python
