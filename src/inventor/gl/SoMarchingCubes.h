// Inventor engine for marching cubes, as in the original thesis. Its inputs are values on a grid.
// Its outputs are a surface, which is made anew whenever an input changes.
//
//     OrganShape {
//       points     = DEF SURFACE MarchingCubes { dims 20 20 20  value [ ... ]  iso 50 } . points
//       normals    = USE SURFACE . normals
//       coordIndex = USE SURFACE . coordIndex
//     }
//
// Every change costs a pass over the whole grid. For an organ in an operation use SurfaceTracker
// (surface/surface_tracker.h), which updates only the part of the grid round a change. Source:
// Lorensen and Cline 1987.
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

  // Number of nodes along x, y and z. The surface is empty if one of the numbers is below 2, or if
  // there are more than 512^3 nodes in all.
  SoSFVec3s dims;
  SoMFFloat value;  // one per node, x fastest; missing values are 0, surplus values are ignored
  SoSFVec3f min;    // position of the first node
  SoSFVec3f max;    // position of the last node
  // A node is inside if its value >= iso. The surface is open where inside nodes lie on the border
  // of the grid.
  SoSFFloat iso;

  SoEngineOutput points;         // SoMFVec3f; adjacent triangles share their points
  SoEngineOutput normals;        // SoMFVec3f; per point: unit, towards falling values, so outwards
  SoEngineOutput coordIndex;     // SoMFInt32, as in IndexedFaceSet: three indices, then -1
  SoEngineOutput triangleCount;  // SoSFInt32

 protected:
  ~SoMarchingCubes() override = default;
  void evaluate() override;
};

}  // namespace resect
