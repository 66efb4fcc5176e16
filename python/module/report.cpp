// resect.Report: what a step did.

#include <pybind11/stl.h>

#include <memory>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "simulation/simulation.h"

namespace resect::python {

namespace {

py::array cells(const py::object& self, std::size_t tool, std::size_t organ) {
  const auto& report = self.cast<const StepReport&>();
  for (const ToolContacts& c : report.contacts)
    if (std::size_t(c.tool) == tool && std::size_t(c.organ) == organ)
      return readOnly(c.cells.data(), {py::ssize_t(c.cells.size())}, self);
  throw usageError("the report has no contacts of tool {} with organ {}; number from 0", tool,
                   organ);
}

std::int64_t touched(const StepReport& report, std::size_t tool) {
  std::int64_t sum = 0;
  for (const ToolContacts& c : report.contacts)
    if (std::size_t(c.tool) == tool) sum += std::int64_t(c.cells.size());
  return sum;
}

std::int64_t substeps(const StepReport& report) {
  std::int64_t sum = 0;
  for (const TissueStep& t : report.tissue) sum += t.substeps;
  return sum;
}

std::vector<TissueEdit> edits(const StepReport& report) {
  std::vector<TissueEdit> all = report.edits;
  all.insert(all.end(), report.caused.begin(), report.caused.end());
  return all;
}

}  // namespace

void bindReport(py::module_& m) {
  py::class_<StepReport, std::shared_ptr<StepReport>>(m, "Report", "What a step did.")
      .def(py::init<>())
      .def_readonly("frame", &StepReport::frame, "Number of the frame, from 0.")
      .def_readonly("time", &StepReport::time, "At the end of the frame, s.")
      .def_readonly("removed", &StepReport::removed, "Particles removed.")
      .def_property_readonly("removed_ml",
                             [](const StepReport& r) { return 1e6 * r.removedVolume; })
      .def_readonly("severed", &StepReport::severed, "Bonds that cuts and edits severed.")
      .def_readonly("torn", &StepReport::torn, "Bonds that tore.")
      .def_readonly("touched_bricks", &StepReport::touchedBricks)
      .def_property_readonly("substeps", &substeps, "Of all tissues together.")
      .def_property_readonly(
          "tool_force",
          [](const py::object& self) {
            return vectors(self.cast<const StepReport&>().toolForce, self);
          },
          "[tools, 3] float64, N: mean force of the tissue on each instrument. Not a copy.")
      .def("contact_cells", &cells, py::arg("tool"), py::arg("organ") = 0,
           "[n] int64: particles that the body of the instrument swept over. Not a copy.")
      .def("touched", &touched, py::arg("tool"), "Number of these in all organs.")
      .def_property_readonly("edits", &edits, "All edits of the frame, in order.")
      .def_property_readonly(
          "bled_ml", [](const StepReport& r) { return 1e-9 * double(r.blood.ledger.bled); },
          "Blood lost so far.")
      .def_property_readonly(
          "bleeding_ml_min", [](const StepReport& r) { return 60e6 * r.blood.rate; },
          "Rate of bleeding in this frame.")
      .def_readonly("faults", &StepReport::faults, "Sentences, each naming the setting to change.");
}

}  // namespace resect::python
