#include "record/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "operation/live/sight.h"
#include "record/file/frame_bytes.h"
#include "record/ledger_rows.h"

namespace resect {
namespace {

// The stage of Simulation::step() that writes the fields below a path.
std::string stageOf(const std::string& field) {
  constexpr std::array<std::pair<const char*, const char*>, 5> kWriters{{
      {"tools", "moveTools"},
      {"organs.organ", "applyEdits"},
      {"organs.tissue", "moveTissue"},
      {"joints", "applyEdits"},
      {"breath", "moveTissue"},
  }};
  for (const auto& [path, stage] : kWriters)
    if (field.starts_with(path)) return stage;
  return "step";
}

bool same(const OperationEvent& a, const OperationEvent& b) {
  return a.frame == b.frame && a.time == b.time && a.tool == b.tool && a.organ == b.organ &&
         a.kind == b.kind && a.amount == b.amount && a.text == b.text;
}

bool same(const RecordedSample& a, const RecordedSample& b) {
  return a.tool == b.tool && std::memcmp(a.tip, b.tip, sizeof a.tip) == 0 &&
         std::memcmp(a.force, b.force, sizeof a.force) == 0;
}

// Whether a key state was saved by an older version of the program.
bool isOlder(const Bytes& state) try {
  return stateFromBytes(state).version < kStateVersion;
} catch (const Error&) {
  return false;  // it is damaged
}

class Verifier {
 public:
  Verifier(const std::filesystem::path& path, const Progress& progress)
      : replay_(path),
        progress_(progress),
        books_(replay_.setup().scenario, replay_.simulation()),
        hashes_(replay_.file().info().fields) {}

  Verification run() {
    found_.complete = replay_.file().complete();
    found_.program = replay_.file().info().program;
    found_.otherProgram = found_.program != programName();
    if (const std::string page = replay_.file().damagedPage(); !page.empty()) {
      found_.first = Difference{0, 0, "file", page};
      return found_;
    }
    const std::vector<Branch> branches = replay_.file().branches();
    if (branches.empty()) throw error("the recording holds no operation; it ended before it began");
    for (const Branch& branch : branches) {
      ++found_.branches;
      try {
        check(branch);
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& e) {
        differ(branch.number, replay_.simulation().frame(), "file", e.what());
      }
      if (found_.first) break;
    }
    return found_;
  }

 private:
  void differ(std::int64_t branch, std::int64_t frame, std::string stage, std::string what) {
    if (!found_.first) found_.first = Difference{branch, frame, std::move(stage), std::move(what)};
  }

  void check(const Branch& branch) {
    RecordingFile& file = replay_.file();
    const std::int64_t b = branch.number;
    const std::vector<std::int64_t> keys = file.keyFrames(b);
    if (keys.empty() || keys[0] != branch.from)
      return differ(b, branch.from, "file", "the branch's first state is missing");
    replay_.goTo(b, branch.from);
    if (b == 0 && branch.parent == -1) {
      const Simulation start = simulationOf(replay_.setup());
      if (!found_.otherProgram && start.save() != replay_.simulation().save())
        return differ(b, branch.from, "file", "the first state is not that of the scenario");
    }
    checkKeyState(b);
    ledgers_ = file.ledgers(b);
    nextLedger_ = 0;
    if (file.lastFrame(b) >= 0 || !ledgers_.empty()) checkLedger(b);
    std::int64_t pieces = nextLedger_ > 0 ? piecesIn(ledgers_[0]) : 0;
    std::vector<OperationEvent> events = file.events(b);
    std::erase_if(events, isSight);  // nothing computes these again
    std::size_t nextEvent = 0;
    const auto expect = [&](const OperationEvent& event) {
      if (nextEvent >= events.size() || !same(events[nextEvent++], event))
        differ(b, event.frame, "measure", fmt::format("event \"{}\"", event.kind));
    };
    samples_ = file.samples(b);
    nextSample_ = 0;
    EventMemory memory;
    const std::int64_t last = file.lastFrame(b);
    StepReport stepped;
    while (!found_.first && replay_.step(nullptr, &stepped)) {
      const std::int64_t frame = replay_.simulation().frame();
      checkHashes(b, frame);
      for (const OperationEvent& event : eventsOf(stepped, replay_.simulation(), memory))
        expect(event);
      checkSamples(b, frame, stepped);
      const bool kept = nextLedger_ < ledgers_.size() && ledgers_[nextLedger_].frame == frame;
      if (kept || ledgerIsDue(frame, file.info().frameRate)) {
        checkLedger(b);
        if (found_.first) break;
        const RecordedLedger& ledger = ledgers_[nextLedger_ - 1];
        if (const auto event = pieceEvent(ledger, pieces)) expect(*event);
        pieces = piecesIn(ledger);
      }
      if (std::ranges::binary_search(keys, frame)) checkKeyState(b);
      ++found_.frames;
      if (progress_ && found_.frames % 16 == 0)
        report(progress_,
               last > branch.from ? double(frame - branch.from) / double(last - branch.from) : 1.0);
    }
    if (found_.first) return;
    if (nextLedger_ != ledgers_.size()) differ(b, last, "measure", "a ledger that was not due");
    if (nextEvent != events.size()) differ(b, last, "measure", "an event that did not happen");
    if (nextSample_ != samples_.size()) differ(b, last, "measure", "a sample of no frame");
    if (last >= 0 && replay_.simulation().frame() != last)
      differ(b, replay_.simulation().frame() + 1, "file", "a frame is missing");
  }

  void checkHashes(std::int64_t branch, std::int64_t frame) {
    const RecordedFrame& recorded = replay_.recorded();
    const std::vector<std::uint64_t>& now = hashes_.of(replay_.simulation());
    if (hashes_.strange())
      return differ(branch, frame, "step",
                    "the state has fields that " + replay_.file().info().program + " did not keep");
    if (recorded.hashes.size() != now.size() + 1)
      return differ(branch, frame, "file", "it has another number of digests");
    if (recorded.hashes[0] != fastHash(recorded.input.data(), recorded.input.size()))
      return differ(branch, frame, "file", "the input is damaged");
    for (std::size_t i = 0; i < now.size(); ++i)
      if (now[i] != recorded.hashes[i + 1])
        return differ(branch, frame, stageOf(hashes_.fields()[i]), hashes_.fields()[i]);
    if (recorded.time != replay_.simulation().time())
      differ(branch, frame, "file", "its time is damaged");
  }

  void checkSamples(std::int64_t branch, std::int64_t frame, const StepReport& stepped) {
    bool equal = true;
    for (const RecordedSample& now : samplesOf(stepped, replay_.simulation())) {
      const bool there = nextSample_ < samples_.size();
      equal = equal && there && samples_[nextSample_].frame == frame &&
              same(samples_[nextSample_], now);
      if (there) ++nextSample_;
    }
    if (nextSample_ < samples_.size() && samples_[nextSample_].frame <= frame) equal = false;
    if (!equal) differ(branch, frame, "measure", "a sample of a tool");
  }

  void checkLedger(std::int64_t branch) {
    const Simulation& now = replay_.simulation();
    if (nextLedger_ >= ledgers_.size() ||
        ledgers_[nextLedger_++] != rowsOf(books_.ledgerOf(now), branch, now))
      differ(branch, now.frame(), "measure", "the ledger");
  }

  void checkKeyState(std::int64_t branch) {
    const std::int64_t frame = replay_.simulation().frame();
    const std::optional<KeyState> key = replay_.file().keyState(branch, frame);
    if (!key || key->frame != frame) return differ(branch, frame, "file", "a key state is missing");
    if (found_.otherProgram) return;
    if (key->state != replay_.simulation().save()) {
      if (isOlder(key->state)) return;  // it lacks fields of the present states
      differ(branch, frame, "file", "the key state is damaged");
    } else if (key->stateHash != replay_.simulation().stateHash())
      differ(branch, frame, "updateSurface", "the surface");
    ++found_.keyStates;
  }

  Replay replay_;
  const Progress& progress_;
  LedgerBooks books_;
  std::vector<RecordedLedger> ledgers_;  // of the branch
  std::size_t nextLedger_ = 0;
  FrameHashes hashes_;
  std::vector<RecordedSample> samples_;  // of the branch
  std::size_t nextSample_ = 0;
  Verification found_;
};

}  // namespace

Replay::Replay(const std::filesystem::path& path)
    : file_(RecordingFile::open(path)),
      setup_(file_.setup()),
      simulation_(std::make_unique<Simulation>(simulationOf(setup_))) {}

void Replay::goTo(std::int64_t branch, std::int64_t frame) {
  const std::int64_t now = simulation_->frame();
  std::optional<KeyState> key;
  if (branch != branch_ || frame < now || before_.tools.empty()) {
    key = file_.keyState(branch, frame);
    if (!key)
      throw error("the recording holds no frame {} of branch {}; choose another", frame, branch);
  } else if (key = file_.keyState(branch, frame); key && key->frame <= now) {
    key.reset();  // playing on is nearer
  }
  if (key) {
    try {
      simulation_->restore(key->state);
    } catch (const Error&) {
      if (file_.info().program == programName()) throw;
      playFromStart(branch);
    }
    branch_ = branch;
    before_ = {};
  }
  while (simulation_->frame() < frame)
    if (!step())
      throw error("the recording ends at frame {}; choose an earlier one than {}",
                  simulation_->frame(), frame);
}

// To the start of a branch, without any state that was kept.
void Replay::playFromStart(std::int64_t branch) {
  for (const Branch& one : file_.branches()) {
    if (one.number != branch) continue;
    if (one.parent >= 0 && one.parent < branch) {
      playFromStart(one.parent);
      branch_ = one.parent;
      before_ = {};
      while (simulation_->frame() < one.from && step()) {
      }
    } else {
      simulation_->restore(simulationOf(setup_).save());
    }
  }
}

bool Replay::step(FrameInput* input, StepReport* stepped) {
  auto next = file_.frame(branch_, simulation_->frame() + 1);
  if (!next) return false;
  recorded_ = std::move(*next);
  FrameInput now;
  try {
    now = frameFromBytes(recorded_.input, recorded_.whole ? FrameInput() : before_);
    simulation_->step(now, stepped ? *stepped : report_);
  } catch (const Error& e) {
    throw error("{}: frame {} of branch {} cannot be played ({}); take an earlier copy of it",
                file_.name(), recorded_.frame, branch_, e.what());
  }
  if (input) *input = now;
  before_ = std::move(now);
  before_.edits.clear();
  return true;
}

Verification verify(const std::filesystem::path& path, const Progress& progress) {
  return Verifier(path, progress).run();
}

}  // namespace resect
