// The obstacles of moving tissue: instruments in hand, the table, and what stands round the organs.
#include <algorithm>

#include "base/parallel.h"
#include "simulation/simulation.h"
#include "tools/contacts.h"

namespace resect {
namespace {

// How far from a body whose grid is coarse its distances are known, in cells of the grid and of the
// tissue. Tissue comes from outside and is pressed out again before it is so deep.
constexpr double kBandCells = 3.5, kBandSpacings = 3;

}  // namespace

void Simulation::surround(Surroundings surroundings) {
  standingShapes_.clear();
  surroundings_ = {};
  if (!moves()) return;
  double coarsest = 0;
  for (const OperatedOrgan& o : organs_)
    coarsest = std::max(coarsest, o.organ.rest.lattice.spacing.x());
  surroundings_ = std::move(surroundings);
  const std::vector<StandingBody>& bodies = surroundings_.bodies;
  standingShapes_.resize(bodies.size());
  parallelFor(bodies.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool coarse = bodies[i].cell > 0;
      standingShapes_[i] = std::make_unique<SignedDistance>(
          bodies[i].shape, 2 * coarsest,
          coarse ? bodies[i].cell : std::clamp(coarsest / 3, 0.001, 0.003),
          coarse ? std::max(kBandCells * bodies[i].cell, kBandSpacings * coarsest)
                 : SignedDistance::kFar);
    }
  });
}

// Lists the tissues of this frame with their obstacles: those that move, and those that edges may
// cut.
void Simulation::listMoving(const FrameInput& input, StepReport& report) {
  work_.moving.clear();
  if (!(input.duration > 0)) return;
  bool cutting = false;
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolState& state = tools_[i];
    work_.edges[i].clear();
    if (!state.inHand) continue;
    for (const auto& part : state.tool->parts)
      part->addEdges(state.tool->model, state.way, work_.edges[i]);
    cutting |= !work_.edges[i].empty();
  }
  for (std::size_t o = 0; o < organs_.size(); ++o) {
    if (!organs_[o].tissue->moves() && !cutting) continue;
    std::vector<Obstacle>& obstacles = work_.obstacles[o];
    obstacles.clear();
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      const ToolState& state = tools_[i];
      const ToolModel& model = state.tool->model;
      if (!state.inHand) continue;
      const bool solid = moves() && model.response != "remove";
      obstacles.push_back({std::int32_t(i), solid ? shapes_[i].get() : nullptr, false,
                           state.way.from.pose, state.way.to.pose, entersTissue(model),
                           model.friction, model.slipForce, work_.edges[i]});
    }
    if (table_) addTable(obstacles);
    for (std::size_t i = 0; i < standingShapes_.size(); ++i)
      obstacles.push_back(standing(*standingShapes_[i], surroundings_.bodies[i].pose));
    work_.moving.push_back({organs_[o].tissue.get(), obstacles, &report.tissue[o]});
  }
}

void Simulation::addTable(std::vector<Obstacle>& obstacles) const {
  const std::optional<TableEdge>& edge = surroundings_.edge;
  obstacles.push_back(tableTop(work_.table[0], work_.table[1]));
  if (!edge) return;
  obstacles.back().halfWidth = edge->halfWidth;
  obstacles.back().halfDepth = edge->halfDepth;
  obstacles.push_back(tableTop());
  Obstacle& floor = obstacles.back();
  floor.from.position.y() = floor.to.position.y() = edge->floor;
}

}  // namespace resect
