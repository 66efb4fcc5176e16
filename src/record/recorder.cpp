#include "record/recorder.h"

#include <fmt/format.h>
#include <resect/version.h>

#include <chrono>
#include <cmath>

#include "base/error.h"
#include "record/frame_bytes.h"

namespace resect {
namespace {

constexpr auto kCommitPeriod = std::chrono::milliseconds(100);
constexpr std::size_t kMostQueued = std::size_t(256) << 20;  // bytes

std::size_t sizeOf(const RecordedFrame& f) {
  return sizeof f + f.input.size() + 8 * f.hashes.size();
}
std::size_t sizeOf(const KeyState& s) { return sizeof s + s.state.size(); }
template <typename T>
std::size_t sizeOf(const T& item) {
  return sizeof item;
}

const char* instructionSet() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") ? "x86-64 with AVX2" : "x86-64";
#elif defined(__aarch64__)
  return "aarch64";
#else
  return "other";
#endif
}

RecordingInfo infoOf(const Scenario& scenario, FrameHashes& hashes, const Simulation& simulation) {
  hashes.of(simulation);
  return {"resect " RESECT_VERSION, instructionSet(), scenario.frameRate, hashes.fields()};
}

}  // namespace

const std::vector<std::uint64_t>& FrameHashes::of(const Simulation& simulation) {
  hashes_.clear();
  visitState(simulation, hashes_);
  return hashes_.values();
}

std::vector<RecordedEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                    EventMemory& memory) {
  std::vector<RecordedEvent> events;
  const auto note = [&](std::string kind, std::int64_t tool, std::int64_t organ, double amount,
                        std::string text = {}) {
    events.push_back({0, simulation.frame(), simulation.time(), tool, organ, std::move(kind),
                      amount, std::move(text)});
  };
  const std::size_t tools = simulation.tools().size(), organs = simulation.organs().size();
  memory.touching.resize(tools, 0), memory.inHand.resize(tools, 0);
  for (std::size_t t = 0; t < tools; ++t) {
    const bool inHand = simulation.tools()[t].inHand;
    if (inHand != bool(memory.inHand[t]))
      note(inHand ? "take" : "put_back", std::int64_t(t), -1, 0);
    bool touching = t < report.toolForce.size() && report.toolForce[t].squaredNorm() > 0;
    for (std::size_t o = 0; o < organs; ++o)
      touching |= !report.contacts[t * organs + o].cells.empty();
    if (touching != bool(memory.touching[t]))
      note(touching ? "touch" : "release", std::int64_t(t), -1, 0);
    memory.inHand[t] = inHand, memory.touching[t] = touching;
  }
  if (report.removed > 0) note("remove", -1, -1, double(report.removed));
  if (report.severed > 0) note("cut", -1, -1, double(report.severed));
  if (report.torn > 0) note("tear", -1, -1, double(report.torn));
  for (const std::string& fault : report.faults) note("fault", -1, -1, 0, fault);
  return events;
}

std::vector<RecordedSample> samplesOf(const StepReport& report, const Simulation& simulation) {
  std::vector<RecordedSample> samples;
  for (std::size_t t = 0; t < simulation.tools().size(); ++t) {
    const ToolState& tool = simulation.tools()[t];
    if (!tool.inHand) continue;
    RecordedSample sample{0, simulation.frame(), std::int64_t(t), {}, {}};
    const Vec3 tip = tool.pose() * tool.tool->model.tip;
    for (int a = 0; a < 3; ++a) {
      sample.tip[a] = tip[a];
      if (t < report.toolForce.size()) sample.force[a] = report.toolForce[t][a];
    }
    samples.push_back(sample);
  }
  return samples;
}

Recorder::Recorder(const std::filesystem::path& path, const Scenario& scenario,
                   const Simulation& simulation)
    : file_(RecordingFile::create(path, infoOf(scenario, hashes_, simulation),
                                  setupOf(scenario, simulation))),
      framesPerKey_(
          std::max<std::int64_t>(1, std::llround(kKeyStateSeconds * scenario.frameRate))) {
  begin(-1, "first", simulation);
  thread_ = std::thread([this] { write(); });
}

Recorder::~Recorder() { finish(); }

void Recorder::put(Item item) {
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) return;
  queued_ += std::visit([](const auto& one) { return sizeOf(one); }, item);
  queue_.push_back(std::move(item));
  if (queued_ > kMostQueued) failure_ = "the disk is too slow for the recording, which ends here";
}

void Recorder::putKeyState(const Simulation& simulation) {
  keyFrame_ = simulation.frame();
  put(KeyState{presentBranch(), keyFrame_, simulation.save(), simulation.stateHash()});
  before_ = {};
}

void Recorder::record(const FrameInput& input, const StepReport& report,
                      const Simulation& simulation) {
  if (!failure().empty()) return;
  RecordedFrame frame{presentBranch(),       simulation.frame(),           simulation.time(),
                      before_.tools.empty(), frameToBytes(input, before_), {}};
  frame.hashes.push_back(fastHash(frame.input.data(), frame.input.size()));
  const std::vector<std::uint64_t>& fields = hashes_.of(simulation);
  frame.hashes.insert(frame.hashes.end(), fields.begin(), fields.end());
  before_ = input;
  before_.edits.clear();
  put(std::move(frame));
  for (RecordedEvent& event : eventsOf(report, simulation, events_)) {
    event.branch = presentBranch();
    put(std::move(event));
  }
  for (RecordedSample& sample : samplesOf(report, simulation)) {
    sample.branch = presentBranch();
    put(sample);
  }
  if (simulation.frame() - keyFrame_ >= framesPerKey_) putKeyState(simulation);
}

void Recorder::begin(std::int64_t parent, std::string name, const Simulation& simulation) {
  branches_.push_back(
      {std::int64_t(branches_.size()), parent, simulation.frame(), std::move(name)});
  events_ = {};  // as in a replay, which begins here
  put(branches_.back());
  putKeyState(simulation);
}

void Recorder::wentBack(const Simulation& simulation) {
  leftAt_.push_back(presentBranch());
  // The frame may be older than the present branch.
  std::int64_t parent = presentBranch();
  while (parent > 0 && branches_[std::size_t(parent)].from > simulation.frame())
    parent = branches_[std::size_t(parent)].parent;
  begin(parent, fmt::format("undo {}", leftAt_.size()), simulation);
}

void Recorder::wentForward(const Simulation& simulation) {
  require(!leftAt_.empty(), "nothing was taken back; call wentBack() first");
  const std::int64_t parent = leftAt_.back();
  leftAt_.pop_back();
  begin(parent, "redo", simulation);
}

std::string Recorder::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

// The recorder's thread: takes what is queued and keeps it in one transaction.
void Recorder::write() {
  for (bool last = false; !last;) {
    std::deque<Item> items;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, kCommitPeriod, [&] { return ending_; });
      last = ending_;
      items.swap(queue_);
      queued_ = 0;
      if (!failure_.empty()) continue;
    }
    if (items.empty() && !last) continue;
    try {
      file_.begin();
      for (const Item& item : items) std::visit([&](const auto& one) { file_.add(one); }, item);
      file_.commit();
      if (last) file_.finish();
    } catch (const std::exception& e) {
      const std::lock_guard lock(mutex_);
      failure_ = e.what();
    }
  }
}

void Recorder::finish() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

}  // namespace resect
