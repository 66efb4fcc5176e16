// Inventor engine for marching cubes. The inputs of the engine are values at the points of a grid.
// These points are called nodes. The outputs of the engine are a surface. The engine makes the
// surface anew whenever an input changes.
//
//     OrganShape {
//       points     = DEF SURFACE MarchingCubes { dims 20 20 20  value [ ... ]  iso 50 } . points
//       normals    = USE SURFACE . normals
//       coordIndex = USE SURFACE . coordIndex
//     }
//
// Every change costs a pass over the whole grid. For an organ in an operation use SurfaceTracker
// (surface/surface_tracker.h) instead, which updates the surface only round a change. Source:
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

  // Numbers of nodes along x, y and z. The surface is empty if one of the numbers is below 2, or if
  // there are more than 512^3 nodes in all.
  SoSFVec3s dims;
  // One value per node, x fastest. Missing values count as 0, and surplus values are ignored.
  SoMFFloat value;
  SoSFVec3f min;  // position of the first node
  SoSFVec3f max;  // position of the last node
  // The iso level: a node is inside if its value is at least `iso`. The surface is open where
  // inside nodes lie on the border of the grid.
  SoSFFloat iso;

  SoEngineOutput points;         // SoMFVec3f; neighbouring triangles share points
  SoEngineOutput normals;        // SoMFVec3f; for each point a unit normal, which faces outwards
  SoEngineOutput coordIndex;     // SoMFInt32; for each triangle three indices of points, then -1
  SoEngineOutput triangleCount;  // SoSFInt32

 protected:
  ~SoMarchingCubes() override = default;
  void evaluate() override;
};

}  // namespace resect
