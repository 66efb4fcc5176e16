// One function per file of bindings; module.cpp calls them in this order.
#pragma once

#include <pybind11/pybind11.h>

namespace resect::python {

void bindScenario(pybind11::module_& m);
void bindOrgan(pybind11::module_& m);
void bindEdits(pybind11::module_& m);
void bindReport(pybind11::module_& m);
void bindSimulation(pybind11::module_& m);
void bindRecording(pybind11::module_& m);
void bindPicture(pybind11::module_& m);

}  // namespace resect::python
