// resect.Simulation.

#include "simulation/simulation.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "operation/ledger/ledger.h"
#include "organ_state.h"
#include "session.h"
#include "tool_rows.h"

namespace resect::python {

namespace {

std::shared_ptr<StepReport> step(Session& session, const std::optional<Rows>& tools,
                                 std::optional<double> duration, std::vector<TissueEdit> edits,
                                 std::optional<float> iso, std::shared_ptr<StepReport> report) {
  FrameInput input;
  input.tools =
      tools ? inputsFrom(*tools, session.simulation->tools().size()) : session.presentInputs();
  input.duration = duration.value_or(1 / session.scenario.frameRate);
  input.edits = std::move(edits);
  input.iso = iso;
  if (!report) report = std::make_shared<StepReport>();
  const py::gil_scoped_release free;
  session.step(input, *report);
  return report;
}

py::bytes save(Session& session) {
  Bytes state;
  {
    const py::gil_scoped_release free;
    state = session.save();
  }
  return {reinterpret_cast<const char*>(state.data()), state.size()};
}

void restore(Session& session, const py::bytes& state) {
  const std::string_view bytes = state;
  const py::gil_scoped_release free;
  session.restore(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

py::dict split(const TissueSplit& s) {
  py::dict all;
  const auto add = [&](const char* name, const TissueAmount& amount) {
    py::dict one;
    one["particles"] = amount.particles;
    one["ml"] = 1e6 * amount.volume;
    one["g"] = 1e3 * amount.mass;
    all[name] = one;
  };
  add("before", s.before), add("body", s.body), add("pieces", s.pieces);
  add("debris", s.debris), add("removed", s.removed);
  return all;
}

py::dict ledger(Session& session) {
  const Ledger now = session.ledger();
  py::dict all = split(now.tissue());
  all["piece_count"] = now.pieces();
  all["cut_cm2"] = 1e4 * now.cut();
  all["bared_cm2"] = 1e4 * now.bared();
  py::dict labels;
  for (const OrganLedger& organ : now.organs)
    for (const LabelLedger& label : organ.labels) {
      py::dict one = split(label.tissue);
      one["margin_mm"] = label.margin ? py::object(py::float_(1e3 * *label.margin)) : py::none();
      labels[py::str(label.name.empty() ? fmt::format("label {}", label.label) : label.name)] = one;
    }
  all["labels"] = labels;
  return all;
}

py::array_t<double> rests(const Session& session) {
  std::vector<ToolInput> inputs;
  for (const ScenarioTool& tool : session.scenario.tools) inputs.push_back({tool.rest, false});
  return rowsFrom(inputs);
}

py::array forces(const Session& session, bool felt) {
  std::vector<double> all;
  for (const ToolState& tool : session.simulation->tools())
    for (int a = 0; a < 3; ++a) all.push_back(felt ? tool.feltForce[a] : tool.force[a]);
  const auto count = py::ssize_t(all.size() / 3);
  return owning(std::move(all), {count, 3});
}

OrganState organ(const py::object& self, std::size_t number) {
  auto& session = self.cast<Session&>();
  session.requireOrgan(number);
  return {self, &session, number};
}

}  // namespace

void bindSimulation(py::module_& m) {
  bindOrganState(m);
  py::class_<Session>(
      m, "Simulation",
      "An operation that is stepped frame by frame. The same inputs give the same bits. One "
      "simulation must not be stepped by two threads at once; several may be stepped beside "
      "each other, since a step does not hold Python's lock.")
      .def(py::init([](Scenario& scenario, const std::shared_ptr<Discretization>& cells) {
             std::unique_ptr<Session> session;
             {
               const py::gil_scoped_release free;
               session = std::make_unique<Session>(scenario,
                                                   cells ? std::optional(*cells) : std::nullopt);
             }
             scenario.tools = session->scenario.tools;
             scenario.duration = session->scenario.duration;
             return session;
           }),
           py::arg("scenario"), py::arg("organ") = py::none(),
           "organ: cells of your own in place of those of the scenario's only organ. Ways that the "
           "scenario gives in the organ's coordinates become inputs of the scenario.")
      .def("step", &step, py::arg("tools") = py::none(), py::arg("duration") = py::none(),
           py::arg("edits") = std::vector<TissueEdit>{}, py::arg("iso") = py::none(),
           py::arg("report") = py::none(),
           "Computes one frame. tools: [tools, 10], see TOOL_COLUMNS: poses at its end; None: as "
           "they "
           "are. duration: s, 0 to 1; None: that of the scenario's frames. edits: applied before "
           "those "
           "of the instruments. iso: another iso level. report: to be filled and returned, instead "
           "of "
           "a new one.")
      .def("save", &save, "The whole state, for restore().")
      .def("restore", &restore, py::arg("state"),
           "Continues from a state of save(). From then on the same inputs give the same bits.")
      .def_property_readonly("state_hash", &Session::stateHash,
                             "Digest of state and surface, 64 bits.",
                             py::call_guard<py::gil_scoped_release>())
      .def_property_readonly(
          "time", [](const Session& s) { return s.simulation->time(); }, "s")
      .def_property_readonly(
          "frame", [](const Session& s) { return s.simulation->frame(); }, "Frames done.")
      .def_property_readonly("organ_count",
                             [](const Session& s) { return s.simulation->organs().size(); })
      .def_property_readonly("tool_count",
                             [](const Session& s) { return s.simulation->tools().size(); })
      .def_property_readonly(
          "memory", [](const Session& s) { return s.simulation->bytes(); }, "Bytes held.")
      .def_readonly("scenario", &Session::scenario)
      .def_readonly("notes", &Session::notes, "Sentences about the set-up.")
      .def("organ", &organ, py::arg("number") = 0)
      .def(
          "tools", [](const Session& s) { return rowsFrom(s.presentInputs()); },
          "[tools, 10]: the instruments now, as TOOL_COLUMNS.")
      .def("tool_rests", &rests, "[tools, 10]: where the instruments lie when not in hand.")
      .def(
          "tool_force", [](const Session& s) { return forces(s, false); },
          "[tools, 3] N: mean over the last frame.")
      .def(
          "felt_force", [](const Session& s) { return forces(s, true); },
          "[tools, 3] N: smoothed over 0.05 s, as a hand feels it.")
      .def("ledger", &ledger,
           "Where all tissue is: before, body, pieces, debris, removed, each with particles, ml "
           "and g; "
           "labels, with the margin of each; areas of cuts.")
      .def("record", &Session::record, py::arg("file"),
           "Begins a recording; every step is recorded until end_recording().")
      .def("end_recording", &Session::endRecording, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("recording", &Session::recording);
}

}  // namespace resect::python
