// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "support/sentence.h"
#include "support/tissue_blocks.h"
#include "tissue/joint.h"
#include "tissue/move_tissues.h"
#include "tissue/still_tissue.h"

using namespace resect;
using test::refuses;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

TissueCells block() { return test::solidBlock({4, 3, 2}, 0.005, liverTissue()); }

// Is tissue refused that differs from a right one by `change`?
template <typename Change>
bool cellsRefused(Change change, const char* what) {
  TissueCells cells = block();
  change(cells);
  return refuses([&] { ElasticTissue(cells, {}); }, what);
}
template <typename Change>
bool settingsRefused(Change change, const char* what) {
  TissueSettings settings;
  change(settings);
  return refuses([&] { ElasticTissue(block(), settings); }, what);
}

}  // namespace

TEST_CASE("cells that do not fit their lattice make no tissue") {
  CHECK(cellsRefused([](TissueCells& c) { c.solid.pop_back(); }, "23 flags"));
  CHECK(cellsRefused([](TissueCells& c) { c.solid.assign(24, 0); }, "no solid cell"));
  CHECK(cellsRefused([](TissueCells& c) { c.material.assign(5, 0); }, "5 materials"));
  CHECK(cellsRefused([](TissueCells& c) { c.material.assign(24, 1); },
                     "a material that there is not"));
  CHECK(cellsRefused([](TissueCells& c) { c.materials.clear(); }, "no material"));
  for (const double wrong : {0.0, -0.005, kNaN, kEndless})
    CHECK(
        cellsRefused([&](TissueCells& c) { c.lattice.spacing.setConstant(wrong); }, "24 cells of"));
  CHECK(refuses([] { StillTissue(block().lattice, {1, 1}); }, "2 flags"));
}

TEST_CASE("materials and settings out of range make no tissue") {
  for (const double wrong : {-1.0, kNaN, kEndless}) {
    CHECK(cellsRefused([&](TissueCells& c) { c.materials[0].young = wrong; }, "young"));
    CHECK(cellsRefused([&](TissueCells& c) { c.materials[0].density = wrong; }, "density"));
    CHECK(cellsRefused([&](TissueCells& c) { c.materials[0].poisson = wrong; }, "poisson"));
    CHECK(settingsRefused([&](TissueSettings& s) { s.damping = wrong; }, "damping"));
    CHECK(settingsRefused([&](TissueSettings& s) { s.drag = wrong; }, "drag"));
    CHECK(settingsRefused([&](TissueSettings& s) { s.penalty = wrong; }, "penalty"));
    CHECK(settingsRefused([&](TissueSettings& s) { s.stepShare = wrong; }, "stepShare"));
  }
  CHECK(cellsRefused([](TissueCells& c) { c.materials[0].tearEnergy = kNaN; }, "tearEnergy"));
  CHECK(cellsRefused([](TissueCells& c) { c.materials[0].tearEnergy = 0; }, "tearEnergy"));
  CHECK(settingsRefused([](TissueSettings& s) { s.gravity.x() = kNaN; }, "gravity"));
}

TEST_CASE("attachments, joints and frames that are none are refused, and nothing moves") {
  ElasticTissue tissue(block(), {});
  TissueAttachment attachment;
  attachment.shape = Region::Shape::Whole;
  attachment.kind = TissueAttachment::Kind::Ligament;
  for (const double wrong : {-1.0, kNaN, kEndless}) {
    attachment.stiffness = wrong;
    CHECK(refuses([&] { tissue.attach(attachment); }, "stiffness"));
  }
  attachment.landmark = "hilum";
  attachment.stiffness = 1;
  CHECK(refuses([&] { tissue.attach(attachment); }, "not yet placed"));
  CHECK(tissue.gripped(-1) == 0);
  TissueMaterial odd;
  odd.young = kNaN;
  CHECK(refuses([&] { tissue.setMaterial(0, odd); }, "young"));

  const JoinedOrgan organ{0, &tissue.lattice(), &tissue};
  for (const double wrong : {-1.0, kNaN, kEndless}) {
    CHECK(refuses([&] { joinNear(organ, organ, wrong, 1, 1e-4); }, "springs"));
    CHECK(refuses([&] { joinNear(organ, organ, 0.01, wrong, 1e-4); }, "springs"));
  }
  TissueStep step;
  for (const double wrong : {0.0, -0.1, kNaN})
    CHECK(refuses([&] { moveTissue(tissue, {}, wrong, step); }, "a time above 0"));
  CHECK(tissue.displacement(0) == Vec3::Zero());
}
