// Inventor engine for marching cubes, as in the original thesis: values on a grid go in, a surface
// comes out, and follows whenever an input changes.
//
//     OrganShape {
//       points     = DEF SURFACE MarchingCubes { dims 20 20 20  value [ ... ]  iso 50 } . points
//       normals    = USE SURFACE . normals
//       coordIndex = USE SURFACE . coordIndex
//     }
//
// Every change costs a pass over the whole grid; for an organ in an operation use SurfaceTracker
// (surface/surface_tracker.h), whose cost is that of the changes. Source: Lorensen, Cline 1987.
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

  SoSFVec3s dims;   // nodes along x, y, z, >= 2 each for a surface
  SoMFFloat value;  // one per node, x fastest; missing ones count as 0, surplus ones are ignored
  SoSFVec3f min;    // position of the first node
  SoSFVec3f max;    // position of the last node
  SoSFFloat iso;    // inside: value >= iso. The surface is open where the inside reaches the border

  SoEngineOutput points;         // SoMFVec3f, shared by the triangles round them
  SoEngineOutput normals;        // SoMFVec3f, unit, outwards: down the field's gradient
  SoEngineOutput coordIndex;     // SoMFInt32, as IndexedFaceSet has it: three and -1
  SoEngineOutput triangleCount;  // SoSFInt32

 protected:
  ~SoMarchingCubes() override = default;
  void evaluate() override;
};

}  // namespace resect
