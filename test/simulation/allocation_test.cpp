// Counts what the whole program asks of the heap while a steady step runs. Not under sanitizers,
// which have a heap of their own.
#ifndef RESECT_SANITIZED

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "base/parallel.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t bytes, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole > 0 ? whole : alignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// All other forms of new end in these two.
void* operator new(std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, std::size_t(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace resect;

namespace {

Simulation twoToolsAndABall() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::ballTool(0.012));
  tools.push_back(test::boxTool({{-0.001, -0.01, 0}, {0.001, 0.01, 0.1}}));
  return Simulation(makeOrgan(test::ball(20), {}), std::move(tools));
}

// Frame i of a steady motion: the first tool turns on its way past the organ, the second rests.
void moveTo(FrameInput& input, const Vec3& p, int i) {
  input.tools[0] = {
      {p + Vec3(0, 0, 1e-3 * i), Eigen::Quaterniond(Eigen::AngleAxisd(0.02 * i, Vec3::UnitY()))},
      true};
  input.tools[1] = {{}, false};
}

// A blunt tool that pushes, and one that is put away, on elastic tissue.
Simulation elasticAndTwoTools() {
  std::vector<std::unique_ptr<Tool>> tools;
  for (int i = 0; i < 2; ++i)
    tools.push_back(test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.06}}, "baton", ""));
  return test::elasticBlock({10, 5, 8}, 0.008, std::move(tools));
}

// Most allocations in one of 100 steps, after some to warm up, in which the first tool goes from p
// on by `way` a step. At one thread: without oneTBB, loops that use more start them, which
// allocates.
long mostAllocations(Simulation& simulation, const Vec3& p, const Vec3& way) {
  const ThreadLimit one(1);
  FrameInput input;
  input.tools.resize(2);
  input.tools[1] = {{}, false};
  StepReport report;
  long most = 0;
  for (int i = 0; i < 130; ++i) {
    input.tools[0] = {{p + i * way, Eigen::Quaterniond::Identity()}};
    const long before = allocations;
    simulation.step(input, report);
    if (i >= 30) most = std::max(most, allocations - before);
  }
  CHECK(report.faults.empty());
  return most;
}

// Allocations in 100 steps of that motion, after some to warm up.
long allocationsNear(Simulation& simulation, const Vec3& p) {
  FrameInput input;
  input.tools.resize(2);
  StepReport report;
  StageClock clock;
  int i = 0;
  for (; i < 5; ++i) {
    moveTo(input, p, i);
    simulation.step(input, report, &clock);
  }
  const long before = allocations;
  for (; i < 105; ++i) {
    moveTo(input, p, i);
    simulation.step(input, report, &clock);
  }
  return allocations - before;
}

}  // namespace

TEST_CASE("a step in which no tool is near the organ allocates nothing") {
  Simulation simulation = twoToolsAndABall();
  CHECK(allocationsNear(simulation, {1, 2, 3}) == 0);
}

TEST_CASE("a step in which a tool is in the organ's box but away from tissue allocates nothing") {
  Simulation simulation = twoToolsAndABall();
  const Aabb box = simulation.organ().rest.lattice.box();
  // The corner of the box is farther from the ball in it than the tool's radius.
  const Vec3 corner(box.min.x(), box.min.y(), box.min.z() - 0.05);
  const std::int64_t particles = simulation.organ().particles;
  CHECK(allocationsNear(simulation, corner) == 0);
  CHECK(simulation.organ().particles == particles);
}

TEST_CASE("a step allocates nothing after a cut either") {
  Simulation simulation = twoToolsAndABall();
  FrameInput input;
  input.tools.resize(2);
  moveTo(input, simulation.organ().rest.lattice.box().centre(), 0);
  CHECK(simulation.step(input).removed > 0);
  CHECK(allocationsNear(simulation, {1, 2, 3}) == 0);
}

TEST_CASE("a step of elastic tissue that lies on the table, no tool near it, allocates nothing") {
  Simulation simulation = elasticAndTwoTools();
  CHECK(mostAllocations(simulation, {1, 2, 3}, Vec3::Zero()) == 0);
}

TEST_CASE("a step of elastic tissue that a tool presses, at rest or moving, allocates nothing") {
  for (const Vec3& way : {Vec3(0, 0, 0), Vec3(0, -1e-5, 0), Vec3(1e-4, 0, 0)}) {
    CAPTURE(way.transpose());
    Simulation simulation = elasticAndTwoTools();
    CHECK(mostAllocations(simulation, {0.04, 0.036, 0.01}, way) == 0);
    CHECK(simulation.tools()[0].force.norm() > 0.1);
  }
}

TEST_CASE("the count is a count: a step that cuts does allocate") {
  Simulation simulation = twoToolsAndABall();
  FrameInput input;
  input.tools.resize(2);
  moveTo(input, simulation.organ().rest.lattice.box().centre(), 0);
  const long before = allocations;
  simulation.step(input);
  CHECK(allocations > before);
}

#endif
