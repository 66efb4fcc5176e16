// 08: the engine SoMarchingCubes and the shape SoOrganShape in a plain .iv file, in any Coin
// program.
//
// The file beside this one connects them: numbers on a grid go into the engine, points, normals and
// triangles come out and into the shape. A Coin program has to know the two classes, nothing else:
// initInventor() instead of SoDB::init(). Then the surface follows whatever the program, or another
// engine, does to the fields; here the iso level is raised, and the ring becomes thinner.

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoSeparator.h>
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "inventor/gl/SoMarchingCubes.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/init.h"
#include "inventor/picture/offscreen_view.h"

using namespace resect;

// What is in the shape's fields.
TriangleMesh meshOf(const SoOrganShape& shape) {
  TriangleMesh mesh;
  for (int i = 0; i < shape.points.getNum(); ++i)
    mesh.points.emplace_back(shape.points[i][0], shape.points[i][1], shape.points[i][2]);
  for (int i = 0; i + 3 < shape.coordIndex.getNum() + 1; i += 4)
    mesh.triangles.push_back(
        {shape.coordIndex[i], shape.coordIndex[i + 1], shape.coordIndex[i + 2]});
  return mesh;
}

int main(int argc, char** argv) {
  if (argc != 2) return fmt::print(stderr, "usage: {} SCENE.iv\n", argv[0]), 2;
  initInventor();
  SoInput file;
  SoSeparator* scene = file.openFile(argv[1]) ? SoDB::readAll(&file) : nullptr;
  if (!scene) return fmt::print(stderr, "{} is not a scene\n", argv[1]), 1;
  scene->ref();
  auto* shape = static_cast<SoOrganShape*>(SoNode::getByName("RING"));
  SoEngineOutput* source = nullptr;
  if (!shape || !shape->points.getConnectedEngine(source)) return 1;
  auto* surface = static_cast<SoMarchingCubes*>(source->getContainer());

  // A ring of radius 0.27 whose tube has a radius of 0.13 at iso 50, and half of it at iso 75.
  bool fine = true;
  for (const auto& [iso, radius] : {std::pair(50.0f, 0.13), std::pair(75.0f, 0.065)}) {
    surface->iso = iso;
    const TriangleMesh mesh = meshOf(*shape);
    const double expected = 2 * std::pow(std::numbers::pi * radius, 2) * 0.27;
    const double share = volume(mesh) / expected;
    fmt::print("iso {}: {} triangles, {}, {:.2f} of the ring's volume\n", iso,
               mesh.triangles.size(), topology(mesh).closed() ? "closed" : "open", share);
    fine = fine && topology(mesh).closed() && std::abs(share - 1) < 0.15;
  }

  surface->iso = 50;
  OffscreenView view(640, 480);
  writePng("surface_in_a_scene.png", view.render(scene));
  fmt::print("surface_in_a_scene.png\n");
  scene->unref();
  return fine ? 0 : 1;
}
