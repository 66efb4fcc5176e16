// What Python's class Simulation holds: a scenario, its simulation, and the recorder while one is
// at work.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "operation/ledger/ledger.h"
#include "operation/scenario.h"
#include "record/recorded_setup.h"
#include "record/recorder.h"
#include "simulation/simulation.h"

namespace resect::python {

class Session {
 public:
  // cells: if given, they take the place of the first organ's. Its labels, materials and
  // attachments are those of the scenario.
  Session(Scenario scenario, std::optional<Discretization> cells);
  // The operation at its start, as a recording keeps it.
  explicit Session(const RecordedSetup& setup);
  ~Session();

  // Computes one frame, and records it if a recording is at work. Throws Error if another thread is
  // stepping this session.
  void step(const FrameInput& input, StepReport& report);
  Bytes save();
  // Throws Error while a recording is at work: it follows one line of time.
  void restore(std::span<const std::byte> state);

  void record(const std::string& path);
  // Ends the recording and closes its file. Throws Error if there is none, or if it could not be
  // written to its end.
  void endRecording();
  bool recording() const { return recorder_.has_value(); }

  // Inputs that leave every tool as it is.
  std::vector<ToolInput> presentInputs() const;
  std::uint64_t stateHash();
  Ledger ledger();
  void requireOrgan(std::size_t organ) const;

  Scenario scenario;
  std::vector<std::string> notes;
  std::unique_ptr<Simulation> simulation;

  // The surface's points of an organ, copied once per frame at most: their place in the library's
  // memory may change with the next frame, and arrays that Python still holds must stay valid.
  using Points = std::shared_ptr<std::vector<Vec3f>>;
  Points points(std::size_t organ);

 private:
  std::unique_lock<std::mutex> mine();
  void makeSimulation(std::optional<Discretization> cells);

  struct Kept {
    Points points;
    std::int64_t change = -1;
  };
  std::mutex busy_;
  std::optional<Recorder> recorder_;
  std::optional<LedgerBooks> books_;  // made when first asked for
  std::vector<Kept> kept_;            // by organ
  std::int64_t changes_ = 0;          // steps and restores so far
};

}  // namespace resect::python
