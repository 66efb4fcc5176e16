// 03: a blade is drawn through an organ, frame by frame, until it falls in two.
//
// The simulation is driven by poses alone. The blade is thinner than a cell and moves two
// centimetres per frame; it is swept from pose to pose, so nothing in between is skipped. What is
// taken and what is left always add up to what was there.

#include <fmt/core.h>

#include <cmath>

#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "organ/discretize.h"
#include "organ/parts/bodies.h"
#include "simulation/simulation.h"
#include "tools/registry.h"

using namespace resect;

int main() {
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 0.05);
  Organ organ = makeOrgan(discretize(ball, latticeForSpacing(bounds(ball), 0.004)), {});
  const double whole = organ.volume();

  // A blade 3 mm thick, with its tip 15 cm below the handle: a tool's frame has the tip at the
  // origin and the handle along +Z. It is taller than the ball, so that one stroke cuts through.
  ToolModel model;
  model.name = "blade";
  model.kind = "scalpel";
  model.response = "remove";  // it takes out what it touches
  model.mesh = boxMesh({{-0.01, -0.0015, 0}, {0.01, 0.0015, 0.15}});
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(makeTool(std::move(model)));
  Simulation simulation(std::move(organ), std::move(tools));

  double taken = 0;
  for (int frame = 0; frame < 10; ++frame) {
    FrameInput input;
    input.tools.push_back({{Vec3(-0.09 + 0.02 * frame, 0, -0.07), Eigen::Quaterniond::Identity()}});
    const StepReport report = simulation.step(input);
    taken += report.removedVolume;
    fmt::print(
        "frame {}: {:3} particles removed, {:4} bricks meshed again, surface in {} piece(s)\n",
        report.frame, report.removed, report.touchedBricks,
        bodies(simulation.organ().surface.mesh()).size());
  }
  const auto pieces = bodies(simulation.organ().surface.mesh());
  for (const TriangleMesh& piece : pieces)
    fmt::print("piece: {} triangles, {:.1f} ml\n", piece.triangles.size(), 1e6 * volume(piece));
  fmt::print("taken {:.1f} ml + left {:.1f} ml = {:.1f} ml\n", 1e6 * taken,
             1e6 * simulation.organ().volume(), 1e6 * whole);
  const double balance = std::abs(taken + simulation.organ().volume() - whole) / whole;
  return pieces.size() == 2 && taken > 0 && balance < 1e-12 ? 0 : 1;
}
