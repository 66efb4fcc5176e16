#include "inventor/reading/scene_limits.h"

#include <Inventor/VRMLnodes/SoVRMLElevationGrid.h>
#include <Inventor/VRMLnodes/SoVRMLExtrusion.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/elements/SoProfileCoordinateElement.h>
#include <Inventor/nodes/SoArray.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoMultipleCopy.h>
#include <Inventor/nodes/SoNurbsSurface.h>
#include <Inventor/nodes/SoProfile.h>

#include <cmath>

#include "base/error.h"

namespace resect {
namespace {

constexpr double kMostCopies = 10'000;
constexpr int kMostControlPoints = 10'000;
constexpr int kHighestOrder = 24;  // of the GL utility library

void checkKnots(const SoMFFloat& knots, int controlPoints, const char* name,
                const std::string& path) {
  const int order = knots.getNum() - controlPoints;
  if (controlPoints < 2 || controlPoints > kMostControlPoints || order < 2 ||
      order > kHighestOrder || order > controlPoints)
    throw error(
        "{}: a NURBS surface has {} control points and {} knots along {}; export the model "
        "again",
        path, controlPoints, knots.getNum(), name);
  for (int i = 0; i < knots.getNum(); ++i)
    if (!std::isfinite(knots[i]) || (i > 0 && knots[i] < knots[i - 1]))
      throw error("{}: the knots of a NURBS surface do not grow along {}; export the model again",
                  path, name);
  if (!(knots[controlPoints] > knots[order - 1]))
    throw error("{}: the knots of a NURBS surface span nothing along {}; export the model again",
                path, name);
}

template <typename Surface>
void checkSurface(const Surface& surface, const std::string& path) {
  checkKnots(surface.uKnotVector, surface.numUControlPoints.getValue(), "u", path);
  checkKnots(surface.vKnotVector, surface.numVControlPoints.getValue(), "v", path);
}

void checkPoints(std::int64_t needed, std::int64_t available, const std::string& path) {
  if (needed > available)
    throw error(
        "{}: a NURBS surface has {} control points, but there are only {}; export the model "
        "again",
        path, needed, available);
}

void checkGrid(const SoVRMLElevationGrid& grid, const std::string& path) {
  const std::int64_t x = grid.xDimension.getValue(), z = grid.zDimension.getValue();
  const std::int64_t heights = grid.height.getNum();
  if (x < 0 || z < 0 || (x > 0 && z > heights / x))
    throw error("{}: an ElevationGrid has {} x {} places but {} heights; export the model again",
                path, x, z, heights);
}

void checkExtrusion(const SoVRMLExtrusion& extrusion, const std::string& path) {
  const std::int64_t along = extrusion.spine.getNum(), across = extrusion.crossSection.getNum();
  if (along * across > 10'000'000 || extrusion.scale.getNum() < 1 ||
      extrusion.orientation.getNum() < 1)
    throw error(
        "{}: an Extrusion has {} x {} points, {} scales and {} orientations; export the "
        "model again",
        path, along, across, extrusion.scale.getNum(), extrusion.orientation.getNum());
}

}  // namespace

void checkNodeLimits(const SoNode& node, SoCallbackAction& action, const std::string& path) {
  const auto is = [&](SoType type) { return node.isOfType(type); };
  if (is(SoArray::getClassTypeId())) {
    const auto& array = static_cast<const SoArray&>(node);
    const double copies = double(array.numElements1.getValue()) * array.numElements2.getValue() *
                          array.numElements3.getValue();
    if (copies > kMostCopies)
      throw error("{}: an Array of {:g} copies; export the model without it", path, copies);
  } else if (is(SoMultipleCopy::getClassTypeId())) {
    const int copies = static_cast<const SoMultipleCopy&>(node).matrix.getNum();
    if (copies > kMostCopies)
      throw error("{}: a MultipleCopy of {} copies; export the model without it", path, copies);
  } else if (is(SoNurbsSurface::getClassTypeId())) {
    const auto& surface = static_cast<const SoNurbsSurface&>(node);
    checkSurface(surface, path);
    checkPoints(
        std::int64_t(surface.numUControlPoints.getValue()) * surface.numVControlPoints.getValue(),
        action.getNumCoordinates(), path);
  } else if (is(SoIndexedNurbsSurface::getClassTypeId())) {
    const auto& surface = static_cast<const SoIndexedNurbsSurface&>(node);
    checkSurface(surface, path);
    checkPoints(
        std::int64_t(surface.numUControlPoints.getValue()) * surface.numVControlPoints.getValue(),
        surface.coordIndex.getNum(), path);
    for (int i = 0; i < surface.coordIndex.getNum(); ++i)
      if (surface.coordIndex[i] < 0 || surface.coordIndex[i] >= action.getNumCoordinates())
        throw error("{}: a NURBS surface uses point {} of only {}; export the model again", path,
                    surface.coordIndex[i], action.getNumCoordinates());
  } else if (is(SoProfile::getClassTypeId())) {
    const auto& profile = static_cast<const SoProfile&>(node);
    const int available = SoProfileCoordinateElement::getInstance(action.getState())->getNum();
    for (int i = 0; i < profile.index.getNum(); ++i)
      if (profile.index[i] < 0 || profile.index[i] >= available)
        throw error("{}: a profile uses point {} of only {}; export the model again", path,
                    profile.index[i], available);
  } else if (is(SoVRMLElevationGrid::getClassTypeId())) {
    checkGrid(static_cast<const SoVRMLElevationGrid&>(node), path);
  } else if (is(SoVRMLExtrusion::getClassTypeId())) {
    checkExtrusion(static_cast<const SoVRMLExtrusion&>(node), path);
  }
}

}  // namespace resect
