// 05: an instrument of one's own in twenty lines.
//
// A tool answers one question: what does it do to the particles that it touches? It queues edits
// and never changes tissue itself; the simulation does the rest. This one is an aspirator that
// sucks away only a few particles per frame, however many it touches.

#include <fmt/core.h>

#include <algorithm>

#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "simulation/simulation.h"

using namespace resect;

class Aspirator : public Tool {
 public:
  explicit Aspirator(double tipRadius) : Tool(modelWithTip(tipRadius)) {}

  void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const override {
    const std::size_t taken = std::min(contacts.cells.size(), kPerFrame);
    for (std::size_t i = 0; i < taken; ++i)
      edits.push_back({TissueEdit::Kind::Remove, contacts.tool, contacts.cells[i]});
  }

  static constexpr std::size_t kPerFrame = 6;

 private:
  static ToolModel modelWithTip(double radius) {
    ToolModel model;
    model.name = "aspirator";
    model.mesh = sphereMesh({0, 0, 0}, radius);
    return model;
  }
};

int main() {
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 0.04);
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::make_unique<Aspirator>(0.012));
  Simulation simulation(makeOrgan(discretize(ball, latticeForSpacing(bounds(ball), 0.004)), {}),
                        std::move(tools));

  // Held still in the skin until nothing is left under its tip.
  FrameInput input;
  input.tools.push_back({{Vec3(0, 0.04, 0), Eigen::Quaterniond::Identity()}});
  bool good = true;
  std::int64_t removed = 0, frames = 0;
  for (StepReport report; frames == 0 || report.removed > 0; ++frames) {
    simulation.step(input, report);
    removed += report.removed;
    good = good && report.removed <= std::int64_t(Aspirator::kPerFrame) && frames < 1000;
    fmt::print("frame {:2}: touches {:2}, takes {}\n", report.frame,
               report.contacts[0].cells.size(), report.removed);
    if (!good) return 1;
  }
  fmt::print("{} particles in {} frames; {} left\n", removed, frames, simulation.organ().particles);
  return removed > 10 && topology(simulation.organ().surface.mesh()).closed() ? 0 : 1;
}
