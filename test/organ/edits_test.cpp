// Edits have the same effect on still and on elastic tissue.
#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "organ/apply_edits.h"
#include "organ/parts/bodies.h"
#include "support/blades.h"
#include "support/block_organ.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/stencil.h"

using namespace resect;

namespace {

const Vec3i kDims(10, 6, 7);
constexpr double kSpacing = 0.005;
constexpr std::int32_t kNumber = 3, kTool = 2;

OperatedOrgan block(bool elastic) {
  Discretization cells = test::fullBlock(kDims, kSpacing);
  std::unique_ptr<TissueModel> tissue;
  if (elastic)
    tissue = std::make_unique<ElasticTissue>(
        TissueCells{cells.lattice, cells.inside, {liverTissue()}, {}}, TissueSettings());
  OperatedOrgan organ = operatedOrgan("block", makeOrgan(std::move(cells), {}), std::move(tissue));
  CHECK(organ.tissue->moves() == elastic);
  return organ;
}

std::int64_t cellAt(int x, int y, int z) { return (z * kDims.y() + y) * kDims.x() + x; }

Vec3 centre(const OperatedOrgan& o, const Vec3& cell) {
  const Lattice& lattice = o.organ.rest.lattice;
  return lattice.origin + lattice.spacing.cwiseProduct(cell);
}

using What = decltype(TissueEdit::what);

TissueEdit edit(What what) { return {kNumber, kTool, std::move(what)}; }

std::vector<TissueEdit> edits(std::vector<What> whats) {
  std::vector<TissueEdit> all;
  for (What& what : whats) all.push_back(edit(std::move(what)));
  return all;
}

struct Applied {
  EditSummary summary;
  std::vector<std::int64_t> removedCells;
};

Applied applyTo(OperatedOrgan& organ, const std::vector<TissueEdit>& edits) {
  Applied applied;
  applied.summary = applyEdits(organ, kNumber, edits, applied.removedCells);
  updateSurface(organ.organ, updateField(organ.organ));
  return applied;
}

// All that edits can change, of either kind of tissue.
struct EditOutcome {
  std::int64_t removed = 0, severedBonds = 0, particles = 0, severedEdges = 0;
  double removedVolume = 0;
  std::vector<std::int64_t> removedCells;
  std::vector<std::uint8_t> alive, labels;
  std::vector<std::uint32_t> bonds;
  std::int32_t gripped = 0;
  std::size_t bodies = 0;
  bool operator==(const EditOutcome&) const = default;
};

// A blade through still tissue severs the grid's edges in the air round it as well.
std::int64_t severedInTissue(const Organ& organ) {
  std::int64_t count = 0;
  const Vec3i nodes = organ.field.nodeDims();
  const std::vector<std::int32_t> pieces = tissuePieces(organ);
  const auto inTissue = [&](const Vec3i& n) {
    return pieces[std::size_t((n.z() * nodes.y() + n.y()) * nodes.x() + n.x())] >= 0;
  };
  for (int z = 0; z < nodes.z(); ++z)
    for (int y = 0; y < nodes.y(); ++y)
      for (int x = 0; x < nodes.x(); ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3i node(x, y, z), next = node + Vec3i::Unit(axis);
          if (organ.severed.at(node, axis) != kWhole && next[axis] < nodes[axis] &&
              inTissue(node) && inTissue(next))
            ++count;
        }
  return count;
}

EditOutcome outcome(const OperatedOrgan& o, const Applied& applied) {
  EditOutcome out;
  out.removed = applied.summary.removed;
  out.severedBonds = applied.summary.severed;
  out.removedVolume = applied.summary.removedVolume;
  out.removedCells = applied.removedCells;
  out.particles = o.organ.particles;
  out.severedEdges = severedInTissue(o.organ);
  out.alive = o.organ.alive;
  for (std::int64_t c = 0; c < o.organ.rest.lattice.cellCount(); ++c) {
    out.bonds.push_back(o.tissue->bonds(c));
    out.labels.push_back(o.organ.label(c));
    CHECK(o.tissue->solid(c) == (o.organ.alive[std::size_t(c)] != 0));
  }
  out.gripped = o.tissue->gripped(kTool);
  out.bodies = bodies(o.organ).size();
  return out;
}

// The same on both kinds of tissue.
EditOutcome outcomeOf(const std::vector<TissueEdit>& edits) {
  OperatedOrgan still = block(false), elastic = block(true);
  const EditOutcome a = outcome(still, applyTo(still, edits));
  const EditOutcome b = outcome(elastic, applyTo(elastic, edits));
  CHECK(a.removed == b.removed);
  CHECK(a.removedCells == b.removedCells);
  CHECK(a.severedBonds == b.severedBonds);
  CHECK(a.severedEdges == b.severedEdges);
  CHECK(a.gripped == b.gripped);
  CHECK(a.labels == b.labels);
  CHECK(a.bonds == b.bonds);
  CHECK(a == b);
  CHECK(topology(still.organ.surface.mesh()).closed());
  return a;
}

const int kRight = directionTo(Vec3i(1, 0, 0)), kLeft = opposite(kRight);

// Severs each bond between cells of x <= `last` and x > `last`, from its lower end.
std::vector<TissueEdit> severAcross(int last) {
  std::vector<TissueEdit> all;
  for (int z = 0; z < kDims.z(); ++z)
    for (int y = 0; y < kDims.y(); ++y)
      for (int d = 0; d < kDirections; ++d)
        if (offsetAlong(d, 0) == 1) all.push_back(edit(SeverBond{cellAt(last, y, z), d}));
  return all;
}

// A blade in the plane x = `cell`, in cells, through the whole block.
Incision incision(const OperatedOrgan& o, double x) {
  Incision cut;
  cut.blade = test::flatBlade(centre(o, {x, 2.5, 3}), Vec3(0, 0.06, 0), Vec3(0, 0, 0.06));
  return cut;
}

}  // namespace

TEST_CASE("a removed cell is gone once, with its bonds, whoever names it again") {
  const std::int64_t cell = cellAt(4, 3, 3);
  const EditOutcome out = outcomeOf(edits({RemoveCell{cell}, RemoveCell{cell}}));
  CHECK(out.removed == 1);
  CHECK(out.removedVolume == doctest::Approx(kSpacing * kSpacing * kSpacing));
  CHECK(out.removedCells == std::vector<std::int64_t>{cell});
  CHECK(out.particles == kDims.prod() - 1);
  CHECK(out.alive[std::size_t(cell)] == 0);
  CHECK(out.bonds[std::size_t(cell)] == 0);
  CHECK((out.bonds[std::size_t(cell) - 1] >> kRight & 1) == 0);
  CHECK(out.severedBonds == 0);
  CHECK(out.severedEdges == 0);
}

TEST_CASE("a severed bond is gone from both its ends, once, and nothing else is") {
  const std::int64_t cell = cellAt(4, 3, 3);
  const EditOutcome out = outcomeOf(edits({SeverBond{cell, kRight}, SeverBond{cell + 1, kLeft}}));
  CHECK(out.severedBonds == 1);
  CHECK(out.bonds[std::size_t(cell)] == (kAllBonds & ~(1u << kRight)));
  CHECK(out.bonds[std::size_t(cell) + 1] == (kAllBonds & ~(1u << kLeft)));
  CHECK(out.bonds[std::size_t(cell) - 1] == kAllBonds);
  CHECK(out.particles == kDims.prod());
  // The two hold each other over third particles: the surface is whole.
  CHECK(out.severedEdges == 0);
}

TEST_CASE("an incision severs the surface's grid and the bonds that cross it, and no others") {
  OperatedOrgan o = block(false);
  const EditOutcome out = outcomeOf(edits({incision(o, 4.4)}));
  CHECK(out.severedEdges > kDims.y() * kDims.z());
  CHECK(out.severedBonds == 0);  // by edits that name bonds
  for (int d = 0; d < kDirections; ++d) {
    INFO("direction ", d);
    const bool whole = out.bonds[std::size_t(cellAt(4, 3, 3))] >> d & 1;
    CHECK(whole == (offsetAlong(d, 0) < 1));
  }
  CHECK(out.bonds[std::size_t(cellAt(2, 3, 3))] == kAllBonds);
  CHECK(out.removed == 0);
}

TEST_CASE("a tool grips each cell once, and lets go of its own alone") {
  const std::int64_t cell = cellAt(4, 3, 3);
  const Grip first{cell, Pose()}, second{cell + 1, Pose()};
  CHECK(outcomeOf(edits({first, first, second})).gripped == 2);
  CHECK(outcomeOf(edits({first, second, Release{}})).gripped == 0);
  CHECK(outcomeOf(edits({first, Release{}, second})).gripped == 1);
  CHECK(outcomeOf(edits({first, second, RemoveCell{cell}})).gripped == 1);
  CHECK(outcomeOf(edits({RemoveCell{cell}, first})).gripped == 0);
  // What one tool holds another can not take, nor let go of.
  std::vector<TissueEdit> two = edits({first, first, second, Release{}});
  two[0].tool = kTool + 1;
  CHECK(outcomeOf(two).gripped == 0);
  for (const bool elastic : {false, true}) {
    OperatedOrgan o = block(elastic);
    applyTo(o, two);
    CHECK(o.tissue->gripped(kTool + 1) == 1);
    two[3].tool = kTool + 1;
    OperatedOrgan other = block(elastic);
    applyTo(other, two);
    CHECK(other.tissue->gripped(kTool + 1) == 0);
    CHECK(other.tissue->gripped(kTool) == 1);
    two[3].tool = kTool;
  }
}

TEST_CASE("a label is the cell's until another one is given, and changes nothing else") {
  const std::int64_t cell = cellAt(4, 3, 3);
  const EditOutcome whole = outcomeOf({});
  EditOutcome out = outcomeOf(edits({SetLabel{cell, 3}, SetLabel{cell + 1, 9}, SetLabel{cell, 5}}));
  CHECK(out.labels[std::size_t(cell)] == 5);
  CHECK(out.labels[std::size_t(cell) + 1] == 9);
  CHECK(out.labels[std::size_t(cell) - 1] == 0);
  out.labels = whole.labels;
  CHECK(out == whole);
}

TEST_CASE("without its bonds across a plane still tissue is two bodies") {
  OperatedOrgan o = block(false);
  CHECK(bodies(o.organ).size() == 1);
  std::vector<TissueEdit> all = severAcross(3);
  const auto isLast = [&](const TissueEdit& one) {
    const auto& bond = std::get<SeverBond>(one.what);
    return bond.cell == cellAt(3, 3, 3) && bond.direction == kRight;
  };
  const TissueEdit last = *std::ranges::find_if(all, isLast);
  std::erase_if(all, isLast);
  applyTo(o, all);
  CHECK(bodies(o.organ).size() == 1);
  applyTo(o, {last});
  const std::vector<Body> parts = bodies(o.organ);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].particles == 6 * kDims.y() * kDims.z());
  CHECK(parts[1].particles == 4 * kDims.y() * kDims.z());
  for (const Body& part : parts) CHECK(topology(part.mesh).closed());
  CHECK(volume(parts[0].mesh) + volume(parts[1].mesh) ==
        doctest::Approx(volume(block(false).organ.surface.mesh())).epsilon(1e-6));

  const EditOutcome both = outcomeOf(severAcross(3));
  // 1 + 4 + 4 bonds over a face, an edge, a corner, but for those that would leave the lattice.
  const int y = kDims.y(), z = kDims.z();
  CHECK(both.severedBonds == y * z + 2 * ((y - 1) * z + y * (z - 1)) + 4 * (y - 1) * (z - 1));
  CHECK(both.bodies == 2);
  // The two nodes a cell's side that lie in tissue.
  CHECK(both.severedEdges == (2 * y - 1) * (2 * z - 1));
}

TEST_CASE("edits are applied in the order in which they are queued") {
  const std::int64_t cell = cellAt(4, 3, 3);
  // A bond of a cell that is gone is no more there to be severed.
  CHECK(outcomeOf(edits({SeverBond{cell, kRight}, RemoveCell{cell}})).severedBonds == 1);
  CHECK(outcomeOf(edits({RemoveCell{cell}, SeverBond{cell, kRight}})).severedBonds == 0);
  // Nor does a blade cut what has been taken out: what it does depends on which comes first.
  OperatedOrgan o = block(false);
  std::vector<What> removals;
  for (int z = 2; z < 5; ++z)
    for (int y = 1; y < 5; ++y)
      for (int x = 3; x < 7; ++x) removals.emplace_back(RemoveCell{cellAt(x, y, z)});
  std::vector<What> cutFirst = removals, cutLast = removals;
  cutFirst.insert(cutFirst.begin(), incision(o, 4.4));
  cutLast.push_back(incision(o, 4.4));
  const EditOutcome first = outcomeOf(edits(cutFirst)), last = outcomeOf(edits(cutLast));
  CHECK(first.removed == 48);
  CHECK(last.removed == 48);
  CHECK(first.severedEdges > 0);
  CHECK(last.severedEdges > 0);
  // Queued together they do what they do one call after the other.
  for (const bool elastic : {false, true})
    for (const auto& whats : {cutLast, std::vector<What>{incision(o, 4.4), incision(o, 6.3)}}) {
      OperatedOrgan together = block(elastic), apart = block(elastic);
      applyTo(together, edits(whats));
      for (const What& what : whats) {
        std::vector<std::int64_t> removed;
        const TissueEdit one = edit(what);
        applyEdits(apart, kNumber, {&one, 1}, removed);
      }
      updateSurface(apart.organ, updateField(apart.organ));
      CHECK(apart.organ.severed.count() == together.organ.severed.count());
      CHECK(apart.organ.alive == together.organ.alive);
      CHECK(apart.organ.surface.mesh().points == together.organ.surface.mesh().points);
    }
}

TEST_CASE("edits for another organ are passed over, and those of a place that there is not") {
  const std::int64_t cell = cellAt(4, 3, 3);
  OperatedOrgan o = block(false);
  std::vector<TissueEdit> others = edits({RemoveCell{cell}, SeverBond{cell, kRight},
                                          incision(o, 4.4), Grip{cell, Pose()}, SetLabel{cell, 3}});
  for (TissueEdit& other : others) other.organ = kNumber - 1;
  const EditOutcome whole = outcomeOf({});
  CHECK(outcomeOf(others) == whole);
  const std::int64_t none = kDims.prod();
  for (const std::int64_t cell : {std::int64_t(-1), none, std::int64_t(1) << 40})
    CHECK(outcomeOf(edits({RemoveCell{cell}, SeverBond{cell, kRight}, Grip{cell, Pose()},
                           SetLabel{cell, 3}})) == whole);
  for (const int direction : {-1, kDirections, 40})
    CHECK(outcomeOf(edits({SeverBond{cell, direction}})) == whole);
  CHECK(outcomeOf(edits({Incision{}})) == whole);
  CHECK(outcomeOf(edits({incision(o, 40.4)})) == whole);
}

TEST_CASE("a grip or a release by nobody leaves what the tissue is attached to as it is") {
  Discretization cells = test::fullBlock(kDims, kSpacing);
  auto tissue = std::make_unique<ElasticTissue>(
      TissueCells{cells.lattice, cells.inside, {liverTissue()}, {}}, TissueSettings());
  TissueAttachment attachment;
  attachment.kind = TissueAttachment::Kind::Ligament;
  attachment.stiffness = 10;
  attachment.shape = Region::Shape::Whole;
  CHECK(tissue->attach(attachment) == kDims.prod());
  OperatedOrgan o = operatedOrgan("block", makeOrgan(std::move(cells), {}), std::move(tissue));
  const auto attached = [&] { return o.tissue->gripped(-1); };
  REQUIRE(attached() == kDims.prod());
  std::vector<TissueEdit> all = edits({Grip{cellAt(4, 3, 3), Pose()}, Release{}});
  for (TissueEdit& one : all) one.tool = -1;
  applyTo(o, all);
  CHECK(attached() == kDims.prod());
}
