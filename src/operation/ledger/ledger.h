// The ledger of an operation: where all tissue is. It counts particles, volume and mass.
//
// In a ledger, volume is always the volume of the tissue in cells (Discretization::cellVolume()).
// It includes skin cells, which hold tissue although their centres lie outside the organ. The
// volume inside the surface is a little different and is no part of the ledger. A label is the
// number of the structure, such as a tumour, to which a cell belongs. Each cell is counted with
// the label and the density that it had before the operation. Volumes are added as whole multiples
// of 2^-24 of a cell's volume, so their sums do not depend on the order of addition. For each label
// and for each organ the equation
//
//   before = body + pieces + debris + removed
//
// holds exactly in particles, and up to rounding in m^3 and kg.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "operation/ledger/structure.h"
#include "operation/scenario.h"

namespace resect {

struct TissueAmount {
  std::int64_t particles = 0;
  double volume = 0;  // m^3
  double mass = 0;    // kg

  TissueAmount& operator+=(const TissueAmount& more) {
    particles += more.particles, volume += more.volume, mass += more.mass;
    return *this;
  }
  bool operator==(const TissueAmount&) const = default;
};

// Where the tissue of an organ or of a label is. A part is a set of particles that bonds connect.
// organ/parts/tissue_parts.h defines which part is the body, and which are pieces or debris.
struct TissueSplit {
  TissueAmount before;   // before the operation
  TissueAmount body;     // in the largest part
  TissueAmount pieces;   // in all other parts except debris
  TissueAmount debris;   // in parts that are too small to be a piece
  TissueAmount removed;  // removed by instruments

  // Body, pieces and debris together.
  TissueAmount left() const {
    TissueAmount sum = body;
    sum += pieces;
    return sum += debris;
  }
  bool operator==(const TissueSplit&) const = default;
};

struct LabelLedger {
  int label = 0;
  std::string name;
  TissueSplit tissue;
  // Least distance, m, of the label's structure from any face that was opened by a cut or by
  // removal of tissue (operation/ledger/wound_faces.h), in the tissue at rest; accurate to half a
  // cell. It is 0 if the structure itself was cut or some of it was removed, and infinite if there
  // is no such face. Set for labels that have a name; not set for label 0.
  std::optional<double> margin;

  bool operator==(const LabelLedger&) const = default;
};

// The body or a piece.
struct PartLedger {
  struct Share {
    int label = 0;
    TissueAmount tissue;
    bool operator==(const Share&) const = default;
  };
  TissueAmount tissue;
  std::vector<Share> labels;    // the part's tissue, label by label, ascending
  std::int64_t firstCell = -1;  // lowest index of its cells

  bool operator==(const PartLedger&) const = default;
};

struct OrganLedger {
  std::string name;
  TissueSplit tissue;
  std::vector<LabelLedger> labels;  // all labels before the operation, ascending
  // The body, then the pieces, the largest first. Empty if nothing is left.
  std::vector<PartLedger> parts;
  std::int64_t debrisParts = 0;
  double cut = 0;    // area of cuts, one side counted, m^2 (operation/ledger/wound_faces.h)
  double bared = 0;  // area of faces that removal of tissue has laid open, m^2

  bool operator==(const OrganLedger&) const = default;
};

struct Ledger {
  std::vector<OrganLedger> organs;

  // Sums over all organs. cut(), bared(): m^2.
  TissueSplit tissue() const;
  std::int64_t pieces() const;
  double cut() const;
  double bared() const;
  bool operator==(const Ledger&) const = default;
};

// The constant data from which the ledgers of an operation are computed.
class LedgerBooks {
 public:
  // simulation: in any state of the operation. scenario: the scenario from which the simulation was
  // made.
  LedgerBooks(const Scenario& scenario, const Simulation& simulation);
  // One setup per organ.
  LedgerBooks(const std::vector<TissueSetup>& setups, const Simulation& simulation);

  // The ledger of the present state. Cost: the cost of woundFaces()
  // (operation/ledger/wound_faces.h), and the time to count the particles. Counting takes 2 ms for
  // 13 000 particles of moving tissue, or for a million particles of tissue that neither moves nor
  // has cuts.
  Ledger ledgerOf(const Simulation& simulation) const;

 private:
  // A particle whose volume, together with the volume of the skin cells that belong to it, differs
  // from that of a full cell.
  struct Odd {
    std::int64_t cell = 0;
    std::int64_t units = 0;  // its volume minus a full cell's, in 2^-24 of a full cell
    // Correction of the number of particles: -1 for a skin cell that Organ treats as a particle,
    // since a ledger does not count it as a particle; otherwise 0.
    std::int32_t particles = 0;
  };
  struct OrganBooks {
    std::vector<std::uint8_t> initial;  // Organ::alive before the operation
    std::vector<Odd> odd;               // ascending by cell
    std::uint8_t place[256] = {};       // per label: its index in before.labels
    std::vector<double> density;        // per entry of before.labels, kg/m^3
    std::vector<Structure> structures;  // of labels that have names
    OrganLedger before;                 // only TissueSplit::before is set
  };
  struct Counts;
  static OrganBooks booksOf(const OperatedOrgan& organ, const TissueSetup& setup);
  static OrganLedger ledgerOf(const OperatedOrgan& organ, const OrganBooks& books);

  std::vector<OrganBooks> organs_;
};

// Checks the sums in a ledger. Returns a sentence about the first sum that is wrong; empty if all
// sums are right. simulation: if given, its own counts are compared with the ledger, too. It must
// be in the state that the ledger describes.
std::string discrepancy(const Ledger& ledger, const Simulation* simulation = nullptr);

}  // namespace resect
