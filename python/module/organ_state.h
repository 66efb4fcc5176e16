// resect.OrganState: an organ of a simulation as numpy arrays.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>

namespace resect::python {

class Session;

// Refers to an organ of a simulation; Python's object keeps the simulation alive.
struct OrganState {
  pybind11::object simulation;
  Session* session = nullptr;
  std::size_t number = 0;
};

void bindOrganState(pybind11::module_& m);

}  // namespace resect::python
