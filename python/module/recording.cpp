// Recordings: resect.Recording, resect.verify(), resect.score().

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_files.h"
#include "record/replay.h"
#include "session.h"
#include "skills/attempt/read_attempt.h"
#include "skills/report/report_json.h"
#include "skills/score/verdict.h"
#include "tool_rows.h"

namespace resect::python {

namespace {

// Lets Ctrl-C end long work.
bool goOn(double) {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return true;
}

Verification verified(const std::string& file) {
  const py::gil_scoped_release free;
  return verify(file, goOn);
}

std::string difference(const Verification& v) {
  if (!v.first) return "";
  return fmt::format("branch {}, frame {}, stage {}: {}", v.first->branch, v.first->frame,
                     v.first->stage, v.first->what);
}

py::object scored(const std::string& file, const std::optional<std::string>& task,
                  const std::optional<std::string>& level, bool graded,
                  const std::string& learner) {
  AttemptOptions options;
  options.learner = learner;
  if (task) {
    options.task = readScenario(findScenario(*task)).task;
    if (!options.task) throw usageError("{} has no task; name a scenario that has one", *task);
  }
  std::optional<TaskLevel> wanted;
  if (level) {
    wanted = taskLevel(*level);
    if (!wanted) throw usageError("level is \"{}\"; use easy, medium or hard", *level);
  }
  std::string text;
  {
    const py::gil_scoped_release free;
    Attempt attempt = readAttempt(file, options, goOn);
    if (!attempt.task) throw error("{}: was recorded without a task; name one by task", file);
    text = toJson(score(std::move(attempt), wanted, graded)).dump();
  }
  return py::module_::import("json").attr("loads")(text);
}

// also: a session that is stepped by the same input, if given.
py::object nextFrame(Replay& replay, Session* also) {
  FrameInput input;
  auto report = std::make_shared<StepReport>();
  bool more = false;
  {
    const py::gil_scoped_release free;
    more = replay.step(&input, report.get());
    StepReport ignored;
    if (more && also) also->step(input, ignored);
  }
  if (!more) return py::none();
  return py::make_tuple(rowsFrom(input.tools), input.duration, report);
}

py::dict samples(Replay& replay, std::int64_t branch) {
  const std::vector<RecordedSample> all = replay.file().samples(branch);
  std::vector<std::int64_t> frame, tool;
  std::vector<double> tip, force;
  for (const RecordedSample& s : all) {
    frame.push_back(s.frame), tool.push_back(s.tool);
    tip.insert(tip.end(), s.tip, s.tip + 3), force.insert(force.end(), s.force, s.force + 3);
  }
  const auto count = py::ssize_t(all.size());
  py::dict table;
  table["frame"] = owning(std::move(frame), {count});
  table["tool"] = owning(std::move(tool), {count});
  table["tip"] = owning(std::move(tip), {count, 3});
  table["force"] = owning(std::move(force), {count, 3});
  return table;
}

}  // namespace

void bindRecording(py::module_& m) {
  py::class_<Verification>(m, "Verification", "What resect.verify() found.")
      .def_readonly("frames", &Verification::frames)
      .def_readonly("key_states", &Verification::keyStates)
      .def_readonly("branches", &Verification::branches)
      .def_readonly("complete", &Verification::complete, "Whether the recording was ended.")
      .def_readonly("program", &Verification::program, "That recorded.")
      .def_property_readonly(
          "equal", [](const Verification& v) { return !v.first; },
          "Whether playing it computes the same bits.")
      .def_property_readonly("difference", &difference, "The first one, as text; empty: none.")
      .def("__bool__", [](const Verification& v) { return !v.first; });
  m.def("verify", &verified, py::arg("file"),
        "Plays a recording and compares every frame with what was recorded.");
  m.def("score", &scored, py::arg("file"), py::arg("task") = py::none(),
        py::arg("level") = py::none(), py::arg("graded") = true, py::arg("learner") = "",
        "Scores a recorded attempt at a task: a dictionary with measures, checks and verdict, as "
        "`resect report --json` writes it. task: name of a scenario with a task, instead of the "
        "recording's own.");

  py::class_<Replay>(m, "Recording", "A recorded operation that can be moved to any frame.")
      .def(py::init<const std::string&>(), py::arg("file"),
           py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("scenario", [](const Replay& r) { return r.setup().scenario; })
      .def_property_readonly("branches",
                             [](Replay& r) {
                               std::vector<std::int64_t> numbers;
                               for (const Branch& b : r.file().branches())
                                 numbers.push_back(b.number);
                               return numbers;
                             })
      .def(
          "last_frame", [](Replay& r, std::int64_t branch) { return r.file().lastFrame(branch); },
          py::arg("branch") = 0)
      .def("go_to", &Replay::goTo, py::arg("branch"), py::arg("frame"),
           py::call_guard<py::gil_scoped_release>(),
           "To the end of a frame, from the nearest key state.")
      .def(
          "simulation", [](Replay& r) { return std::make_unique<Session>(r.setup()); },
          "The operation at its start, as a simulation of its own.",
          py::call_guard<py::gil_scoped_release>())
      .def("step", &nextFrame, py::arg("also") = py::none(),
           "Plays the next frame: (tools [n, 10], duration in s, Report), or None at the end. "
           "also: a simulation from simulation(), which gets the same input.")
      .def("samples", &samples, py::arg("branch") = 0,
           "Every instrument in hand in every frame: arrays frame [n], tool [n], tip [n, 3] m, "
           "force [n, 3] N.")
      .def_property_readonly("frame", [](Replay& r) { return r.simulation().frame(); })
      .def_property_readonly("state_hash", [](Replay& r) { return r.simulation().stateHash(); });
}

}  // namespace resect::python
