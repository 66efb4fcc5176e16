// Inventor engine for marching cubes, as in the original thesis: its inputs are values on a grid,
// its outputs a surface, which is made anew whenever an input changes.
//
//     OrganShape {
//       points     = DEF SURFACE MarchingCubes { dims 20 20 20  value [ ... ]  iso 50 } . points
//       normals    = USE SURFACE . normals
//       coordIndex = USE SURFACE . coordIndex
//     }
//
// Every change costs a pass over the whole grid. For an organ in an operation use SurfaceTracker
// (surface/surface_tracker.h), where a change costs only the bricks round it. Source: Lorensen and
// Cline 1987.
#pragma once

#include <Inventor/engines/SoEngine.h>
#include <Inventor/engines/SoSubEngine.h>
#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoMFVec3f.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/fields/SoSFVec3s.h>

namespace resect {

class SoMarchingCubes : public SoEngine {
  SO_ENGINE_HEADER(SoMarchingCubes);

 public:
  static void initClass();
  SoMarchingCubes();

  SoSFVec3s dims;   // nodes along x, y, z; no surface below 2 each or above 512^3 in all
  SoMFFloat value;  // one per node, x fastest; missing ones count as 0, surplus ones are ignored
  SoSFVec3f min;    // position of the first node
  SoSFVec3f max;    // position of the last node
  // A node is inside if its value >= iso. Where inside nodes lie on the grid's border the surface
  // is open.
  SoSFFloat iso;

  SoEngineOutput points;         // SoMFVec3f; adjacent triangles share their points
  SoEngineOutput normals;        // SoMFVec3f, unit, outwards: against the gradient of the values
  SoEngineOutput coordIndex;     // SoMFInt32, as in IndexedFaceSet: three indices, then -1
  SoEngineOutput triangleCount;  // SoSFInt32

 protected:
  ~SoMarchingCubes() override = default;
  void evaluate() override;
};

}  // namespace resect
