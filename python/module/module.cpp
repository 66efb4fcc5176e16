// The Python module resect._core: the library for Python. python/resect/_core.pyi describes it for
// readers.

#include <pybind11/pybind11.h>
#include <resect/version.h>

#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "bindings.h"
#include "io/data_folder.h"

namespace py = pybind11;

namespace {

std::unique_ptr<resect::ThreadLimit> threads;

void setThreads(int most) {
  resect::require(most >= 0, "{} threads were asked for; give 1 or more, or 0 for all", most);
  threads.reset();
  threads = std::make_unique<resect::ThreadLimit>(most);
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "Resect for Python: organs, simulations, recordings and pictures.";
  m.attr("__version__") = RESECT_VERSION;
  py::register_exception<resect::Error>(m, "Error", PyExc_RuntimeError);
  m.def(
      "set_threads", &setThreads, py::arg("most"),
      "Most threads that one step may use; 0: all. The results have the same bits at any number.");
  m.def(
      "data_folder", [] { return resect::dataFolder().string(); },
      "Folder of the scenarios, instruments and organs that come with Resect.");
  setThreads(1);  // several simulations beside each other use the cores better than one on all

  resect::python::bindScenario(m);
  resect::python::bindOrgan(m);
  resect::python::bindEdits(m);
  resect::python::bindReport(m);
  resect::python::bindSimulation(m);
  resect::python::bindRecording(m);
  resect::python::bindPicture(m);
}
