#include "record/recorded_history.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "record/file/frame_bytes.h"
#include "record/ledger_rows.h"
#include "record/recorder.h"

namespace resect {
namespace {

// parent: of the branch; null for the first one. everyNth: how many of the states that were kept
// are taken, from the first on.
OperationHistory::Course courseOf(RecordingFile& file, const Branch& branch,
                                  const OperationHistory::Course* parent, std::size_t tools,
                                  std::int64_t everyNth, const std::function<void()>& frameRead) {
  OperationHistory::Course course;
  course.branch = branch;
  // What led to the branch was felt on its way too.
  if (parent) course.peaks.emplace_back(branch.from, parent->peaksAt(branch.from));
  const std::vector<std::int64_t> keys = file.keyFrames(branch.number);
  for (std::size_t k = 0; k < keys.size(); k += std::size_t(everyNth))
    if (std::optional<KeyState> key = file.keyState(branch.number, keys[k]))
      course.states[keys[k]] = std::move(key->state);
  if (course.states.empty() || course.states.begin()->first != branch.from)
    throw error("{}: the first state of branch {} is missing; take an earlier copy of it",
                file.name(), branch.number);
  const std::vector<OperationEvent> events = file.events(branch.number);
  auto event = events.begin();
  const std::vector<RecordedSample> samples = file.samples(branch.number);
  auto sample = samples.begin();
  FrameInput before;
  for (std::int64_t number = branch.from + 1;; ++number) {
    const std::optional<RecordedFrame> frame = file.frame(branch.number, number);
    if (!frame) break;
    FrameInput input = frameFromBytes(frame->input, frame->whole ? FrameInput() : before);
    if (input.tools.size() != tools)
      throw error(
          "{}: frame {} of branch {} has {} tools instead of {}; take an earlier copy of it",
          file.name(), number, branch.number, input.tools.size(), tools);
    const auto first = event;
    while (event != events.end() && event->frame <= number) ++event;
    const std::span<const OperationEvent> happened(first, event);
    for (const OperationEvent& one : happened) remember(course.events, one, tools);
    std::vector<double> forces(tools, 0);
    for (; sample != samples.end() && sample->frame <= number; ++sample)
      if (sample->tool >= 0 && std::size_t(sample->tool) < tools)
        forces[std::size_t(sample->tool)] =
            Vec3(sample->force[0], sample->force[1], sample->force[2]).norm();
    course.add(input, happened, forces);
    before = std::move(input);
    before.edits.clear();
    frameRead();
  }
  if (const auto ledgers = file.ledgers(branch.number); !ledgers.empty()) {
    course.pieces = piecesIn(ledgers.back());
    for (const RecordedLedger::Amount& amount : ledgers.back().amounts) {
      if (amount.part == "removed") course.removedVolume += 1e-6 * amount.ml;
      if (amount.part == "piece") course.piecesVolume += 1e-6 * amount.ml;
    }
    for (const RecordedLedger::Wound& wound : ledgers.back().wounds) {
      if (wound.kind == "cut") course.cut += 1e-4 * wound.amount;
      if (wound.kind == "bared") course.bared += 1e-4 * wound.amount;
    }
  }
  // A state beyond the frames would let the operation go on where nothing led.
  course.states.erase(course.states.upper_bound(course.end()), course.states.end());
  return course;
}

Moment clamped(Moment moment, Moment end) {
  return moment.branch == end.branch && moment.frame < end.frame ? moment : end;
}

// States for the starts of all branches, where another version of the program kept some that this
// one cannot restore.
void makeStates(std::vector<OperationHistory::Course>& courses, const RecordedSetup& setup,
                Simulation& simulation, const Progress& progress) {
  for (OperationHistory::Course& course : courses) {
    if (course.branch.number == 0) {
      simulation = simulationOf(setup);
    } else {
      const OperationHistory::Course& parent = courses[std::size_t(course.branch.parent)];
      simulation.restore(parent.states.begin()->second);
      while (simulation.frame() < course.branch.from) {
        simulation.step(*parent.inputs.at(std::size_t(simulation.frame() - parent.branch.from)));
        report(progress, 0.9);
      }
    }
    course.states = {{course.branch.from, simulation.save()}};
  }
}

}  // namespace

RecordedOperation operationOf(RecordingFile& file, RecordedSetup setup,
                              std::optional<std::int64_t> branch, const Progress& progress,
                              std::size_t mostBytes) {
  auto simulation = std::make_unique<Simulation>(simulationOf(setup));
  const std::vector<Branch> branches = file.branches();
  std::int64_t frames = 1, read = 0;
  for (const Branch& one : branches)
    frames += std::max<std::int64_t>(0, file.lastFrame(one.number) - one.from);
  const auto everyNth =
      1 + file.keyStateBytes() / std::int64_t(std::max<std::size_t>(1, mostBytes));
  std::vector<OperationHistory::Course> courses;
  for (const Branch& one : branches) {
    if (one.number != std::int64_t(courses.size()) || one.parent >= one.number ||
        (one.number > 0 && one.parent < 0))
      throw error("{}: its branches are not in order; take an earlier copy of it", file.name());
    const OperationHistory::Course* parent =
        one.number > 0 ? &courses[std::size_t(one.parent)] : nullptr;
    courses.push_back(courseOf(file, one, parent, simulation->tools().size(), everyNth, [&] {
      if (progress && ++read % 64 == 0) report(progress, 0.9 * double(read) / double(frames));
    }));
  }
  if (courses.empty()) throw error("{}: holds no operation; it ended before it began", file.name());
  try {
    simulation->restore(courses[0].states.begin()->second);
  } catch (const Error&) {
    if (file.info().program == programName()) throw;
    makeStates(courses, setup, *simulation, progress);
  }
  const std::int64_t last = branch.value_or(file.moment().branch);
  if (last < 0 || std::size_t(last) >= courses.size())
    throw error("{}: there is no branch {} in it; choose 0 to {}", file.name(), last,
                std::int64_t(courses.size()) - 1);
  const Moment start{last, courses[std::size_t(last)].branch.from};
  const Moment end{last, courses[std::size_t(last)].end()};
  RecordedOperation operation{
      std::move(setup), std::move(simulation),
      OperationHistory(std::move(courses), file.info().frameRate, start, mostBytes)};
  operation.simulation->restore(
      operation.history.courses()[std::size_t(last)].states.begin()->second);
  operation.history.goTo(branch ? end : clamped(file.moment(), end), *operation.simulation);
  return operation;
}

}  // namespace resect
