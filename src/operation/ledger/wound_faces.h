// The faces that an operation has opened in an organ, computed from the mesh of its surface.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "operation/ledger/structure.h"
#include "organ/organ.h"

namespace resect {

// Areas, m^2, and margins, measured on the present surface in rest space.
struct WoundFaces {
  // Area of the cuts that blades, jaws and tears have opened without removing tissue. A cut has two
  // sides, but its area is counted once. If the tissue on one side of a cut is removed later, the
  // other side is no longer a cut but a bared face.
  double cut = 0;
  // Area of bared faces: faces that were laid open when tissue was removed. A face counts as bared
  // if the tissue at the point three quarters of a cell in front of the face was removed. Accurate
  // to 7 %.
  double bared = 0;
  // Per structure: its least distance from any cut or bared face, m; infinite if there is no such
  // face.
  std::vector<double> margins;
};

// structures: the structures whose margins are wanted. Cost: 10 ns for each triangle in bricks
// (blocks of 4 x 4 x 4 grid nodes) where tissue was cut or removed, plus the time to compute the
// distances of the corners of these triangles from the structures.
WoundFaces woundFaces(const Organ& organ, std::span<const Structure> structures);

// A point of a cut or bared face, in rest space, and its distance from a structure, m.
struct MarginPlace {
  Vec3 place = Vec3::Zero();
  double distance = 0;
};
// The centres of triangles of cut or bared faces. Only centres whose distance from the structure is
// less than `within`, m, are included.
std::vector<MarginPlace> marginPlaces(const Organ& organ, const Structure& structure,
                                      double within);

}  // namespace resect
