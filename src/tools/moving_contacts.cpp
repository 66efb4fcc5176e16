#include "tools/moving_contacts.h"

#include <algorithm>
#include <cmath>

#include "collision/inside.h"
#include "collision/swept_blade.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

// Does the edge move along its blade and not back out of the cut? `motion`: of the edge's middle,
// in the tool's frame, m.
bool cuts(const ToolModel& tool, const Vec3& motion) {
  const Vec3 chord = (tool.edge.back() - tool.edge.front()).normalized();
  const Vec3 middle = 0.5 * (tool.edge.back() + tool.edge.front());
  // The flat's normal: across the belly of the edge, or across edge and spine when it is straight.
  Vec3 normal = Vec3::Zero();
  for (const Vec3& p : tool.edge) {
    const Vec3 n = chord.cross(p - tool.edge.front());
    if (n.squaredNorm() > normal.squaredNorm()) normal = n;
  }
  if (normal.norm() < 1e-6) normal = chord.cross(bounds(tool.mesh).centre() - middle);
  if (normal.norm() < 1e-9) return true;
  normal.normalize();
  Vec3 outwards = chord.cross(normal);
  if (outwards.dot(bounds(tool.mesh).centre() - middle) > 0) outwards = -outwards;
  const double across = std::abs(motion.dot(normal));
  const Vec3 along = motion - motion.dot(normal) * normal;
  return along.norm() > across && along.dot(outwards) > -0.5 * along.norm();
}

Vec3 middleOf(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / double(points.size());
}

void append(SweptBlade& blade, const SweptBlade& more) {
  blade.triangles.insert(blade.triangles.end(), more.triangles.begin(), more.triangles.end());
  blade.bounds.grow(more.bounds);
}

// One edge of the jaws, `side` 1 or -1, in the world; from tip to heel for one, back for the other,
// so that both strips look to the same side where they meet.
std::vector<Vec3> jawEdge(const ToolModel& tool, const ToolStance& at, double side) {
  const Eigen::AngleAxisd turn(side * 0.5 * (1 - at.squeeze) * tool.jaws.opening, tool.jaws.axis);
  std::vector<Vec3> edge;
  for (const Vec3& p : tool.edge)
    edge.push_back(at.pose * (tool.jaws.pivot + turn * (p - tool.jaws.pivot)));
  if (side < 0) std::reverse(edge.begin(), edge.end());
  return edge;
}

// What the edges of closing jaws sweep; nothing while they open.
SweptBlade sweepOfJaws(const ToolModel& tool, const ToolStance& from, const ToolStance& to) {
  constexpr double kStep = 0.06;  // rad: an edge of 40 mm strays 0.02 mm from its arc
  SweptBlade blade;
  if (!(to.squeeze > from.squeeze)) return blade;
  const double angle = 0.5 * (to.squeeze - from.squeeze) * tool.jaws.opening;
  const int steps = std::max(1, int(std::ceil(angle / kStep)));
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec3> before = jawEdge(tool, from, side);
    for (int k = 1; k <= steps; ++k) {
      const double share = double(k) / steps;
      const std::vector<Vec3> after = jawEdge(tool,
                                              {interpolate(from.pose, to.pose, share),
                                               from.squeeze + share * (to.squeeze - from.squeeze)},
                                              side);
      append(blade, ruledBlade(before, after));
      before = after;
    }
  }
  return blade;
}

// What the tool's edges part in this frame: on their way in it, and in the one before.
SweptBlade sweepOf(const ToolModel& tool, const ToolWay& way) {
  SweptBlade blade;
  if (tool.edge.empty()) return blade;
  if (tool.jaws.opening > 0) {
    blade = sweepOfJaws(tool, way.from, way.to);
    if (!blade.empty()) append(blade, sweepOfJaws(tool, way.earlier, way.from));
    return blade;
  }
  const Vec3 middle = middleOf(tool.edge);
  const Vec3 motion =
      way.to.pose.inverse().rotation * (way.to.pose * middle - way.from.pose * middle);
  if (!cuts(tool, motion)) return blade;
  blade = sweepBlade(tool.edge, way.earlier.pose, way.from.pose);
  append(blade, sweepBlade(tool.edge, way.from.pose, way.to.pose));
  return blade;
}

// Is a point of the tool's frame held by the hook: within the bend's circle, or not a cell away?
bool inBend(const ToolModel& tool, const Vec3& p, double spacing) {
  const Vec3 first = tool.hook.front(), last = tool.hook.back();
  const Vec3 centre = 0.5 * (first + last);
  double radius = 0;
  for (const Vec3& q : tool.hook) radius = std::max(radius, (q - centre).norm());
  const Vec3 plane = (first - centre).cross(tool.hook[tool.hook.size() / 2] - centre).normalized();
  const double off = (p - centre).dot(plane);
  return std::abs(off) < spacing && (p - centre - off * plane).norm() < radius + 0.5 * spacing;
}

}  // namespace

double standOff(const ToolModel& tool, double spacing) {
  return (tool.edge.empty() && tool.hook.empty() ? 0.5 : 0.1) * spacing;
}

ToolContacts findMovingContacts(const Organ& organ, const TissueModel& tissue, const Tool& tool,
                                std::int32_t toolIndex, const ToolWay& way) {
  ToolContacts contacts;
  contacts.tool = toolIndex;
  contacts.tissueMoves = true;
  contacts.gripped = tissue.gripped(toolIndex);
  const ToolModel& model = tool.model();
  const Lattice& lattice = organ.rest.lattice;
  const double spacing = lattice.spacing.x();
  const Pose &from = way.from.pose, &to = way.to.pose, toTool = to.inverse();

  const Vec3 motion = toTool.rotation * (to.position - from.position);
  contacts.pulls = motion.dot(model.axis) > 0.2 * motion.norm() && motion.norm() > 0;
  contacts.blade = sweepOf(model, way);
  const SweptBlade& blade = contacts.blade;
  const Aabb nearBlade = blade.bounds.padded(2 * spacing);

  // The tool's box on its way, in its frame at the end.
  Aabb box = tool.bounds();
  for (int corner = 0; corner < 8; ++corner)
    box.grow(toTool * (from * tool.bounds().corner(corner)));
  for (const Vec3& p : model.hook) box.grow(p);
  box = box.padded((model.hook.empty() ? 0.5 : 1.5) * spacing);
  Aabb boxInWorld;
  for (int corner = 0; corner < 8; ++corner) boxInWorld.grow(to * box.corner(corner));
  boxInWorld = boxInWorld.padded(1e-6 * spacing);  // rounding

  std::vector<std::int64_t> near;
  std::vector<Vec3> positions;
  Aabb around = boxInWorld;
  if (!blade.empty()) around.grow(nearBlade);
  for (const std::int64_t c : tissue.cellsIn(around)) {
    if (!organ.alive[c]) continue;
    const Vec3 x = lattice.centre(lattice.cell(c)) + tissue.displacement(c);
    const bool atBlade = !blade.empty() && nearBlade.contains(x);
    if (!atBlade && !boxInWorld.contains(x)) continue;
    const Vec3 local = toTool * x;
    if (box.contains(local)) {
      near.push_back(c);
      positions.push_back(x);
      contacts.volumeOfInterest.grow(x);
      if (!model.hook.empty() && contacts.pulls && inBend(model, local, spacing))
        contacts.caught.push_back(c);
    }
    if (!atBlade) continue;
    contacts.nearBlade.push_back(c);
    const Vec3i at = lattice.cell(c);
    for (int d = kFirstForward; d < kDirections; ++d) {
      if (!(tissue.bonds(c) >> d & 1)) continue;
      const Vec3i other = at + offsetOf(d);
      const Vec3 y = lattice.centre(other) + tissue.displacement(lattice.index(other));
      if (crossing(blade, x, y)) contacts.crossed.push_back({c, d});
    }
  }
  if (near.empty()) return contacts;
  const std::vector<std::uint8_t> touched = sweptInside(model.mesh, from, to, positions);
  for (std::size_t i = 0; i < near.size(); ++i)
    if (touched[i]) contacts.cells.push_back(near[i]);
  return contacts;
}

}  // namespace resect
