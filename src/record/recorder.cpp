#include "record/recorder.h"

#include <fmt/format.h>
#include <resect/version.h>

#include <chrono>
#include <cmath>

#include "base/error.h"
#include "io/output/output_target.h"
#include "io/output/temporary_file.h"
#include "record/file/frame_bytes.h"
#include "record/ledger_rows.h"

namespace resect {
namespace {

constexpr auto kCommitPeriod = std::chrono::milliseconds(100);
constexpr std::size_t kMostQueued = std::size_t(256) << 20;  // bytes

std::size_t sizeOf(const RecordedFrame& f) {
  return sizeof f + f.input.size() + 8 * f.hashes.size();
}
std::size_t sizeOf(const KeyState& s) { return sizeof s + s.state.size(); }
std::size_t sizeOf(const RecordedLedger& l) {
  return sizeof l + sizeof(RecordedLedger::Amount) * l.amounts.size();
}
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

RecordingInfo infoOf(const Scenario& scenario, const FrameHashes& hashes) {
  return {programName(), instructionSet(), scenario.frameRate, hashes.fields()};
}

FrameHashes hashesLike(const RecordingFile& done, const Simulation& simulation) {
  FrameHashes hashes(done.info().fields);
  hashes.of(simulation);
  if (hashes.strange())
    throw error(
        "{}: was recorded by {}, which keeps other fields; what is done from now on is not "
        "recorded: to go on with it, take that version",
        done.name(), done.info().program);
  return hashes;
}

std::int64_t framesPerKey(double frameRate) {
  return std::max<std::int64_t>(1, std::llround(Recorder::kKeyStateSeconds * frameRate));
}

}  // namespace

std::string programName() { return "resect " RESECT_VERSION; }

FrameHashes::FrameHashes(const Simulation& start) {
  visitState(start, hashes_);
  hashes_.seal();
}

const std::vector<std::uint64_t>& FrameHashes::of(const Simulation& simulation) {
  hashes_.clear();
  visitState(simulation, hashes_);
  return hashes_.values();
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
    : path_(path),
      hashes_(simulation),
      file_(RecordingFile::create(
          path, infoOf(scenario, hashes_), setupOf(scenario, simulation),
          {0, -1, simulation.frame(), kFirstBranch},
          {0, simulation.frame(), simulation.save(), simulation.stateHash()})),
      books_(scenario, simulation),
      frameRate_(scenario.frameRate),
      framesPerKey_(framesPerKey(frameRate_)) {
  keyFrame_.push_back(simulation.frame());
  lastLedger_.push_back({-1, 0});
  std::vector<Item> items;
  addLedger(items, {0, simulation.frame()}, simulation);
  put(std::move(items));
  thread_ = std::thread([this] { write(); });
}

Recorder::Recorder(const std::filesystem::path& path, RecordingFile& done, const Scenario& scenario,
                   const Simulation& simulation)
    : path_(path),
      hashes_(hashesLike(done, simulation)),
      file_(RecordingFile::goOn(path, done)),
      books_(scenario, simulation),
      frameRate_(done.info().frameRate),
      framesPerKey_(framesPerKey(frameRate_)) {
  for (const Branch& branch : file_.branches()) {
    keyFrame_.push_back(file_.keyFrames(branch.number).back());
    const auto ledgers = file_.ledgers(branch.number);
    lastLedger_.push_back(ledgers.empty()
                              ? LastLedger{}
                              : LastLedger{ledgers.back().frame, piecesIn(ledgers.back())});
  }
  thread_ = std::thread([this] { write(); });
}

Recorder::~Recorder() { finish(); }

void Recorder::put(std::vector<Item> items) {
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) return;
  for (Item& item : items) {
    queued_ += std::visit([](const auto& one) { return sizeOf(one); }, item);
    queue_.push_back(std::move(item));
  }
  if (queued_ > kMostQueued) failure_ = "the disk is too slow for the recording, which ends here";
}

KeyState Recorder::keyState(Moment moment, const Simulation& simulation) {
  keyFrame_[std::size_t(moment.branch)] = moment.frame;
  last_ = {-1, 0};
  return {moment.branch, moment.frame, simulation.save(), simulation.stateHash()};
}

void Recorder::addLedger(std::vector<Item>& items, Moment moment, const Simulation& simulation) {
  RecordedLedger ledger = rowsOf(books_.ledgerOf(simulation), moment.branch, simulation);
  LastLedger& last = lastLedger_[std::size_t(moment.branch)];
  if (last.frame >= 0)  // pieces that a branch begins with have come off before
    if (const auto event = pieceEvent(ledger, last.pieces)) items.push_back(*event);
  last = {moment.frame, piecesIn(ledger)};
  items.push_back(std::move(ledger));
}

void Recorder::begin(const Branch& branch, const Simulation& simulation) {
  require(branch.number == std::int64_t(keyFrame_.size()),
          "branch {} begins after {} branches; number them in the order in which they begin",
          branch.number, keyFrame_.size());
  keyFrame_.push_back(branch.from);
  lastLedger_.push_back({});
  const Moment moment{branch.number, branch.from};
  std::vector<Item> items{branch, keyState(moment, simulation)};
  addLedger(items, moment, simulation);
  put(std::move(items));
}

void Recorder::stood(Moment moment, const Simulation& simulation) {
  if (!failure().empty() || lastLedger_[std::size_t(moment.branch)].frame >= moment.frame) return;
  std::vector<Item> items;
  addLedger(items, moment, simulation);
  put(std::move(items));
}

void Recorder::rename(const Branch& branch) { put({branch}); }

void Recorder::record(Moment moment, const FrameInput& input, const StepReport& report,
                      std::span<const OperationEvent> events, const Simulation& simulation) {
  if (!failure().empty()) return;
  const bool follows = last_.branch == moment.branch && last_.frame + 1 == moment.frame;
  RecordedFrame frame{moment.branch, moment.frame, simulation.time(), !follows, {}, {}};
  frame.input = frameToBytes(input, follows ? before_ : FrameInput());
  frame.hashes.push_back(fastHash(frame.input.data(), frame.input.size()));
  const std::vector<std::uint64_t>& fields = hashes_.of(simulation);
  frame.hashes.insert(frame.hashes.end(), fields.begin(), fields.end());
  last_ = moment;
  before_ = input;
  before_.edits.clear();
  std::vector<Item> items{std::move(frame)};
  items.insert(items.end(), events.begin(), events.end());
  for (RecordedSample& sample : samplesOf(report, simulation)) {
    sample.branch = moment.branch;
    items.push_back(sample);
  }
  if (ledgerIsDue(moment.frame, frameRate_)) addLedger(items, moment, simulation);
  if (moment.frame - keyFrame_[std::size_t(moment.branch)] >= framesPerKey_)
    items.push_back(keyState(moment, simulation));
  put(std::move(items));
}

void Recorder::record(const FrameInput& input, const StepReport& report,
                      const Simulation& simulation) {
  record({0, simulation.frame()}, input, report, eventsOf(report, simulation, events_), simulation);
}

std::uintmax_t Recorder::size() const {
  std::uintmax_t sum = 0;
  for (const char* end : {"", "-wal"}) {
    std::error_code ec;
    const std::uintmax_t bytes = std::filesystem::file_size(path_.string() + end, ec);
    if (!ec) sum += bytes;
  }
  return sum;
}

void Recorder::saveAs(const std::filesystem::path& path, Moment moment) {
  for (const auto& own : filesOfRecording(path_))
    if (identityOf(path) == identityOf(own))
      throw error("{}: is where this operation is being recorded; choose another name",
                  path.string());
  const OutputTarget at = findTarget(path);
  if (at.kind != OutputTarget::Kind::File)
    throw error("{}: is no file; choose a name in a folder", path.string());
  TemporaryFile file(at.path);
  std::string failed, ended;
  {
    std::unique_lock lock(mutex_);
    save_ = {file.path(), path.string(), moment, ""};
    wake_.notify_all();
    wake_.wait(lock, [&] { return save_.file.empty(); });
    failed = save_.failure;
    ended = failure_;
  }
  if (!failed.empty()) throw error("{}", failed);
  Database::removeBeside(at.path);
  file.rename();
  if (!ended.empty()) throw error("{}; all until then is saved", ended);
}

std::string Recorder::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

// The recorder's thread: takes what is queued and keeps it in one transaction.
void Recorder::write() {
  for (bool last = false; !last;) {
    std::deque<Item> items;
    Save save;
    std::string failed;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, kCommitPeriod, [&] { return ending_ || !save_.file.empty(); });
      last = ending_;
      save = save_;
      items.swap(queue_);
      queued_ = 0;
      failed = failure_;
    }
    if (failed.empty()) failed = keep(items, last);
    try {
      if (!save.file.empty()) file_.copyTo(save.file, save.name, save.moment);
    } catch (const std::exception& e) {
      save.failure = e.what();
    }
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = failed;
    if (save.file.empty()) continue;
    save_ = {{}, {}, {}, save.failure};
    wake_.notify_all();
  }
}

// Returns why nothing more can be kept; nothing if all is well.
std::string Recorder::keep(const std::deque<Item>& items, bool last) {
  try {
    if (!items.empty()) {
      file_.begin();
      for (const Item& item : items) std::visit([&](const auto& one) { file_.add(one); }, item);
      file_.commit();
      if (size() > mostBytes_)
        return fmt::format(
            "{}: has {} MB, the most that a recording may have, and ends here; save the operation, "
            "open it and go on",
            path_.string(), mostBytes_ >> 20);
    }
    if (last) file_.finish();
    return "";
  } catch (const std::exception& e) {
    file_.rollback();
    return e.what();
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
