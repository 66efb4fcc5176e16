// How an instrument presses and holds tissue at the end of a frame, point by point. A simulation
// step computes only the mean force of a contact. The details here are computed on request
// (TissueModel::touchOf()); no result of a step depends on them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "tissue/material.h"

namespace resect {

// A patch of the tissue's surface that an instrument presses. The pressure is modelled by a damped
// spring, the patch's spring (docs/methods/tissue.md, "Contact, grips, attachments").
struct PressedPoint {
  Vec3 place;                      // middle of the patch, world, m
  Vec3 outwards;                   // normal of the instrument's surface there, unit
  double area;                     // area at rest that the instrument covers, m^2
  double force;                    // force on the tissue along `outwards`, N, > 0
  double stiffness;                // stiffness of the patch's spring at this depth, N/m
  double damping;                  // damping of the patch's spring, N s/m
  const TissueMaterial* material;  // of the tissue under the patch; valid until the next step
};

// A cell that the instrument grips. A spring leads from the cell to an anchor that moves with the
// tool.
struct HeldPoint {
  Vec3 place;                      // the anchor; world, m
  Vec3 force;                      // force on the instrument, N
  double stiffness, damping;       // of the spring, N/m, N s/m
  const TissueMaterial* material;  // of the cell; valid until the next step
};

struct TissueTouch {
  double spacing = 0;  // side of the tissue's cells, m; 0: the tissue does not move
  std::vector<PressedPoint> pressed;
  std::vector<HeldPoint> held;

  void clear() {  // keeps the memory
    spacing = 0;
    pressed.clear(), held.clear();
  }
};

}  // namespace resect
