// F: which particles does an instrument touch, and how much tissue is where it is, on an organ that
// changes? Beside FCL, which refits its tree to the organ's new points and collides the two
// surfaces.

#include <fcl/fcl.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/parallel.h"
#include "geometry/primitives.h"
#include "organ/organ.h"
#include "peers/rows.h"
#include "peers/timing.h"
#include "support/bench_organs.h"
#include "support/references/mesh_reference.h"
#include "tissue/still_tissue.h"
#include "tools/contacts.h"
#include "tools/registry.h"

namespace resect::bench {
namespace {

using FclTree = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<FclTree> treeOf(const TriangleMesh& mesh) {
  auto tree = std::make_shared<FclTree>();
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.emplace_back(std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]));
  tree->beginModel(int(triangles.size()), int(mesh.points.size()));
  tree->addSubModel(mesh.points, triangles);
  tree->endModel();
  return tree;
}

fcl::Transform3d transformOf(const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = pose.rotation.toRotationMatrix();
  transform.translation() = pose.position;
  return transform;
}

// A blunt rod, 10 mm across, its round tip at the origin, handle towards +Z.
std::unique_ptr<Tool> rod() {
  ToolModel model;
  model.name = model.kind = "baton";
  model.mesh = sphereMesh({0, 0, 0.05}, 1, 16);
  for (Vec3& p : model.mesh.points)
    p = (p - Vec3(0, 0, 0.05)).cwiseProduct(Vec3(0.005, 0.005, 0.05)) + Vec3(0, 0, 0.05);
  return makeTool(std::move(model));
}

// Tip 10 mm deep in the liver's front at 16 places, moving 2 mm a frame.
struct Way {
  Pose from, to;
};
std::vector<Way> waysIntoFront(const Organ& organ) {
  std::vector<Way> ways;
  const Lattice& lattice = organ.rest.lattice;
  for (int i = 0; i < 16; ++i) {
    Vec3i c(int((0.25 + 0.5 * i / 15) * lattice.dims.x()), lattice.dims.y() / 2,
            lattice.dims.z() - 1);
    while (c.z() > 0 && !organ.rest.inside[lattice.index(c)]) --c.z();
    const Vec3 tip = lattice.centre(c) - Vec3(0, 0, 0.01);
    ways.push_back({{tip - Vec3(0.002, 0, 0), Eigen::Quaterniond::Identity()},
                    {tip, Eigen::Quaterniond::Identity()}});
  }
  return ways;
}

struct Agreement {
  std::int64_t found = 0, expected = 0, wrong = 0;
};

// By solid angles, at kSteps + 1 places of each way: are the particles that are inside the rod at
// one of them those found? Beyond those, only what the rod grazes between two places.
Agreement checkParticles(const Organ& organ, const Tool& tool, const std::vector<Way>& ways) {
  constexpr int kSteps = 100;
  const StillTissue still(organ.rest.lattice, organ.alive);
  Agreement agreement;
  for (const Way& way : ways) {
    const ToolContacts contacts = findContacts(organ, still, tool, way.from, way.to);
    const double apart = (way.to.position - way.from.position).norm() / kSteps;
    const Aabb near = tool.bounds.padded(1e-6);
    for (std::int64_t cell = 0; cell < organ.rest.lattice.cellCount(); ++cell) {
      if (!organ.alive[cell]) continue;
      const Vec3 centre = organ.rest.lattice.centre(organ.rest.lattice.cell(cell));
      bool inside = false, grazed = false;
      for (int step = 0; step <= kSteps && !inside; ++step) {
        const Vec3 p = interpolate(way.from, way.to, double(step) / kSteps).inverse() * centre;
        if (!near.contains(p)) continue;
        inside = test::solidAngleWinding(tool.model.mesh, p) > 0.5;
        grazed = grazed || test::distanceToMesh(tool.model.mesh, p) < apart;
      }
      const bool found = std::ranges::binary_search(contacts.cells, cell);
      agreement.found += found;
      agreement.expected += inside;
      agreement.wrong += found != inside && !(found && grazed);
    }
  }
  return agreement;
}

// What it costs to find that no particle is touched: of all places, the median and the most.
Figure costWithoutContact(const Organ& organ, const Tool& tool, const std::vector<Way>& ways,
                          const Vec3& moved, const std::string& what) {
  const StillTissue still(organ.rest.lattice, organ.alive);
  std::vector<double> medians;
  std::size_t touched = 0;
  for (Way way : ways) {
    way.from.position += moved;
    way.to.position += moved;
    std::vector<double> times;
    for (int i = 0; i < 200; ++i)
      times.push_back(secondsOf(
          [&] { touched += findContacts(organ, still, tool, way.from, way.to).cells.size(); }));
    medians.push_back(median(times));
  }
  return {"F", what,
          fmt::format("{:.2f} us, at most {:.2f} of {} places; {} particles touched",
                      1e6 * median(medians), 1e6 * std::ranges::max(medians), ways.size(), touched),
          "at most 20 us"};
}

}  // namespace

Findings contactsAgainstFcl(const Effort& effort) {
  struct Case {
    double triangles, goal;
  };
  std::vector<Case> cases = {{2e4, 100}};
  if (!effort.quick) cases.push_back({2e5, 1000});
  Findings findings;
  const std::unique_ptr<Tool> tool = rod();
  for (const Case& c : cases) {
    const Organ organ = makeOrgan(liverCells(particlesFor(c.triangles)), {});
    const StillTissue still(organ.rest.lattice, organ.alive);
    const std::vector<Way> ways = waysIntoFront(organ);
    const TriangleMesh surface = organ.surface.mesh();
    const std::shared_ptr<FclTree> organTree = treeOf(surface), toolTree = treeOf(tool->model.mesh);
    double overlap = 0;
    int touching = 0;
    const auto resectFrames = [&] {
      overlap = 0;
      for (const Way& way : ways)
        overlap += findContacts(organ, still, *tool, way.from, way.to).overlapVolume;
    };
    const auto collideFrames = [&](bool refit) {
      touching = 0;
      for (const Way& way : ways) {
        if (refit) {
          organTree->beginUpdateModel();
          organTree->updateSubModel(surface.points);
          organTree->endUpdateModel();
        }
        const fcl::CollisionObjectd a(organTree), b(toolTree, transformOf(way.to));
        fcl::CollisionRequestd request(1'000'000, true);
        fcl::CollisionResultd result;
        fcl::collide(&a, &b, request, result);
        touching += result.isCollision();
      }
    };
    const Agreement agreement = checkParticles(organ, *tool, ways);
    const auto compare = [&](bool refit, int threads) {
      const ThreadLimit limit(threads);
      Comparison line;
      line.row = "F";
      line.work = refit ? "particles touched and ml shared, organ changed"
                        : "particles touched and ml shared, organ unchanged";
      line.peer = refit ? "FCL 0.7 refit + collide" : "FCL 0.7 collide alone";
      line.size = double(surface.triangles.size());
      line.sizeUnit = "triangles";
      line.threads = threads;
      line.goal = refit ? c.goal : 0;
      collideFrames(refit);
      line.agrees = agreement.wrong == 0 && touching == int(ways.size());
      line.agreement = fmt::format(
          "FCL touches at {} of {} places; {} particles found, {} by solid angles, {} "
          "wrong",
          touching, ways.size(), agreement.found, agreement.expected, agreement.wrong);
      timeBoth(
          resectFrames, [&] { collideFrames(refit); }, effort, line);
      line.resect /= double(ways.size());
      line.peerTime /= double(ways.size());
      findings.comparisons.push_back(std::move(line));
    };
    for (const int threads : threadCounts())
      for (const bool refit : {true, false}) compare(refit, threads);
    const ThreadLimit limit(1);
    const auto size = surface.triangles.size();
    findings.figures.push_back(costWithoutContact(
        organ, *tool, ways, {0, 0.5, 0}, fmt::format("away from the organ, {} triangles", size)));
    findings.figures.push_back(
        costWithoutContact(organ, *tool, ways, {0, 0, 0.012},
                           fmt::format("2 mm beside the skin, {} triangles", size)));
  }
  return findings;
}

}  // namespace resect::bench
