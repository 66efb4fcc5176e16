// resect.Scenario.

#include "operation/scenario.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_files.h"
#include "tool_rows.h"

namespace resect::python {

namespace {

std::vector<std::string> toolModels(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const ScenarioTool& tool : scenario.tools) names.push_back(tool.model);
  return names;
}

py::array_t<double> inputs(const Scenario& scenario, std::int64_t frame) {
  require(frame >= 0 && frame < frameCount(scenario), "frame {} was asked for; give 0 to {}", frame,
          frameCount(scenario) - 1);
  return rowsFrom(frameInput(scenario, frame).tools);
}

}  // namespace

void bindScenario(py::module_& m) {
  m.def(
      "scenario_names", [] { return shippedNames("scenarios", ".toml"); },
      "Names of the scenarios that come with Resect.");
  m.def(
      "task_names", [] { return shippedNames("tasks", ".toml"); },
      "Names of the tasks that come with Resect; each is a scenario too.");
  py::class_<Scenario>(m, "Scenario",
                       "The set-up of an operation and the motions of its instruments.")
      .def(py::init([](const std::string& name) { return readScenario(findScenario(name)); }),
           py::arg("name"), "name: of a scenario or task that comes with Resect, or a file.")
      .def_static("parse", &parseScenario, py::arg("text"), py::arg("name") = "text",
                  "A scenario from its text in TOML; name stands for the file in errors.")
      .def_readonly("name", &Scenario::name)
      .def_readonly("title", &Scenario::title)
      .def_readonly("description", &Scenario::description)
      .def_property_readonly(
          "duration",
          [](const Scenario& s) {
            frameCount(s);  // which knows whether the ways are placed
            return s.duration;
          },
          "s; as frame_count, known once a Simulation was made of the scenario")
      .def_readonly("frame_rate", &Scenario::frameRate, "Frames per simulated second.")
      .def_property_readonly("frame_count", &frameCount)
      .def_property_readonly("tools", &toolModels, "Models of the instruments, in order.")
      .def("inputs", &inputs, py::arg("frame"),
           "Inputs of the instruments in a frame, [tools, 10] float64: see TOOL_COLUMNS.")
      .def("__repr__", [](const Scenario& s) { return "<resect.Scenario " + s.name + ">"; });
}

}  // namespace resect::python
