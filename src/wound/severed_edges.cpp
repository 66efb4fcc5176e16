#include "wound/severed_edges.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace resect {
namespace {

// The surface in a cell depends on nodes from two below its lowest corner to two above its highest.
constexpr int kNodesBelow = 3, kNodesAbove = 2;    // cells affected, from an edge's lower node
constexpr std::uint8_t kInSight = 1, kWithin = 2;  // bits of a brick pending for update()
constexpr float kSamePoint = 1e-4f;                // ends closer than this are one point
constexpr float kStraight = 1e-3f;                 // traces that bend by less are joined

float distanceToLine(const Eigen::Vector2f& p, const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  const Eigen::Vector2f d = b - a, r = p - a;
  const float length = d.norm();
  return length > 0 ? std::abs(d.x() * r.y() - d.y() * r.x()) / length : r.norm();
}

// If `next` continues `line` straight, extends line to next's end and returns true.
bool extend(FaceTrace& line, const FaceTrace& next) {
  const bool on = (next.from - line.to).norm() < kSamePoint &&
                  (line.to - line.from).dot(next.to - next.from) > 0 &&
                  distanceToLine(line.to, line.from, next.to) < kStraight;
  if (on) line.to = next.to;
  return on;
}

FaceTrace reversed(const FaceTrace& line) { return {line.to, line.from}; }

}  // namespace

SeveredEdges::Record::Record() {
  for (auto& along : share) along.fill(kWhole);
  for (auto& along : normal) along.fill(Vec3f::Zero());
  firstTrace.fill(-1);
}

SeveredEdges::Record& SeveredEdges::takeRecord(const Vec3i& node, int axis) {
  require(
      contains(node) && axis >= 0 && axis < 3,
      "there is no edge or face at node ({}, {}, {}) along axis {}; give a node of the grid and "
      "an axis from 0 to 2",
      node.x(), node.y(), node.z(), axis);
  const std::size_t bricks = std::size_t(brickDims_.x()) * brickDims_.y() * brickDims_.z();
  if (recordOf_.empty()) {
    recordOf_.assign(bricks, -1);
    near_.assign(bricks, 0);
    pendingOf_.assign(bricks, 0);
  }
  std::int32_t& r = recordOf_[std::size_t(brickIndex(node / 4))];
  if (r < 0) {
    r = std::int32_t(records_.size());
    records_.emplace_back();
  }
  return records_[std::size_t(r)];
}

// visit(brick) for the bricks of the nodes low to high.
template <typename Visit>
void SeveredEdges::visitBricks(const Vec3i& lowNode, const Vec3i& highNode, Visit visit) const {
  const Vec3i low = lowNode.cwiseMax(0) / 4,
              high = (highNode / 4).cwiseMin(brickDims_ - Vec3i::Ones());
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) visit(std::size_t(brickIndex({x, y, z})));
}

// visit(brick) for the bricks whose cells, or lattice cubes, the edges and faces at `node` lie in.
template <typename Visit>
void SeveredEdges::visitNear(const Vec3i& node, Visit visit) const {
  // With three nodes a cell the lattice's cubes cross the borders of bricks.
  const int below = refine_ == 3 ? kNodesBelow : 1, above = refine_ == 3 ? kNodesAbove : 0;
  visitBricks(node - Vec3i::Constant(below), node + Vec3i::Constant(above), visit);
}

// Marks the bricks whose surface depends on the edges and faces at `node`.
void SeveredEdges::touch(const Vec3i& node) {
  visitBricks(node - Vec3i::Constant(kNodesBelow), node + Vec3i::Constant(kNodesAbove),
              [&](std::size_t b) {
                if (!pendingOf_[b]) pending_.push_back(std::int64_t(b));
                pendingOf_[b] |= kInSight;
              });
  visitNear(node, [&](std::size_t b) {
    near_[b] = 1;
    pendingOf_[b] |= kWithin;
  });
}

bool SeveredEdges::betweenCells(const Vec3i& node, int axis) const {
  Vec3i n = node;
  n[axis] -= n[axis] % refine_;  // every refine-th node from 0 on lies on the mid-plane of a cell
  for (int k = 0; k < refine_; ++k, ++n[axis])
    if (at(n, axis) != kWhole) return true;
  return false;
}

bool SeveredEdges::sever(const Vec3i& node, int axis, double t, const Vec3& normal) {
  require(!std::isnan(t), "an edge is severed at no share of its length; give 0 to 1");
  Record& r = takeRecord(node, axis);
  const int s = slot(node, 0);
  std::uint64_t& mask = r.severed[std::size_t(axis)];
  if (mask >> s & 1) return false;
  mask |= std::uint64_t(1) << s;
  r.share[std::size_t(axis)][std::size_t(s)] = std::clamp(float(t), kCutMargin, 1 - kCutMargin);
  const Vec3 up = normal[axis] < 0 ? Vec3(-normal) : normal;
  const double length = up.norm();
  r.normal[std::size_t(axis)][std::size_t(s)] =
      length > 0 ? Vec3f((up / length).cast<float>()) : Vec3f(Vec3f::Unit(axis));
  ++count_;
  touch(node);
  return true;
}

void SeveredEdges::trace(const Vec3i& node, int axis, const FaceTrace& line) {
  Record& r = takeRecord(node, axis);
  std::int32_t* last = &r.firstTrace[std::size_t(slot(node, axis))];
  touch(node);
  while (*last >= 0) {
    Trace& t = r.traces[std::size_t(*last)];
    if (extend(t.line, line) || extend(t.line, reversed(line))) return;
    FaceTrace back = reversed(t.line);
    if (extend(back, line) || extend(back, reversed(line))) {
      t.line = reversed(back);
      return;
    }
    last = &t.next;
  }
  *last = std::int32_t(r.traces.size());
  r.traces.push_back({line, -1});
}

float SeveredEdges::at(const Vec3i& node, int axis) const {
  const Record* r = record(node);
  return r ? r->share[std::size_t(axis)][std::size_t(slot(node, 0))] : kWhole;
}

Vec3f SeveredEdges::normal(const Vec3i& node, int axis) const {
  const Record* r = record(node);
  return r ? r->normal[std::size_t(axis)][std::size_t(slot(node, 0))] : Vec3f(Vec3f::Unit(axis));
}

std::span<const TouchedBrick> SeveredEdges::update() {
  touched_.clear();
  std::sort(pending_.begin(), pending_.end());
  for (const std::int64_t b : pending_) {
    std::uint8_t& pending = pendingOf_[std::size_t(b)];
    if (near_[std::size_t(b)]) touched_.push_back({b, (pending & kWithin) != 0});
    pending = 0;
  }
  pending_.clear();
  return touched_;
}

bool SeveredEdges::fit() const {
  const std::size_t bricks = std::size_t(brickDims_.x()) * brickDims_.y() * brickDims_.z();
  for (const std::size_t size : {recordOf_.size(), near_.size(), pendingOf_.size()})
    if (size != (records_.empty() ? 0 : bricks)) return false;
  const auto below = [](std::int64_t i, std::size_t end) { return i < std::int64_t(end); };
  std::vector<std::uint8_t> owned(records_.size(), 0);
  for (const std::int32_t r : recordOf_)
    if (r < -1 || !below(r, records_.size()) || (r >= 0 && owned[std::size_t(r)]++)) return false;
  std::vector<std::uint8_t> unlisted = pendingOf_;
  for (const std::int64_t b : pending_) {
    if (b < 0 || !below(b, unlisted.size())) return false;
    std::uint8_t& pending = unlisted[std::size_t(b)];
    if (pending == 0 || pending > (kInSight | kWithin)) return false;
    pending = 0;
  }
  if (std::ranges::any_of(unlisted, [](std::uint8_t pending) { return pending != 0; }))
    return false;
  return std::ranges::all_of(records_, [](const Record& record) { return record.fit(); }) &&
         countAndNearFit();
}

bool SeveredEdges::Record::fit() const {
  for (std::size_t k = 0; k < 192; ++k) {
    const float cut = share[k / 64][k % 64];
    if (!(cut == kWhole || (cut >= kCutMargin && cut <= 1 - kCutMargin))) return false;
    if ((severed[k / 64] >> k % 64 & 1) != (cut != kWhole)) return false;
    if (!normal[k / 64][k % 64].allFinite()) return false;
    const std::int32_t t = firstTrace[k];
    if (t < -1 || t >= std::int64_t(traces.size())) return false;
  }
  // Indices ascend along a face's list, so that the list ends.
  for (std::size_t t = 0; t < traces.size(); ++t) {
    const auto& [line, next] = traces[t];
    if (!line.from.allFinite() || !line.to.allFinite()) return false;
    if (next != -1 && (next <= std::int64_t(t) || next >= std::int64_t(traces.size())))
      return false;
  }
  return true;
}

// Are as many edges severed as are counted, and the bricks near them those that are noted?
bool SeveredEdges::countAndNearFit() const {
  std::vector<std::uint8_t> near(near_.size(), 0);
  std::int64_t count = 0;
  for (std::size_t b = 0; b < recordOf_.size(); ++b) {
    const Record* record = recordOfBrick(std::int64_t(b));
    if (!record) continue;
    const auto x = std::size_t(brickDims_.x()), y = std::size_t(brickDims_.y());
    const Vec3i brick(int(b % x), int(b / x % y), int(b / x / y));
    for (int k = 0; k < 192; ++k) {
      const bool cut = record->severed[std::size_t(k / 64)] >> k % 64 & 1;
      count += cut;
      if (cut || record->firstTrace[std::size_t(k)] >= 0)
        visitNear(4 * brick + Vec3i(k % 4, k / 4 % 4, k / 16 % 4),
                  [&](std::size_t there) { near[there] = 1; });
    }
  }
  return near == near_ && count == count_;
}

std::size_t SeveredEdges::bytes() const {
  std::size_t sum = records_.capacity() * sizeof(Record) + recordOf_.capacity() * 4 +
                    near_.capacity() + pendingOf_.capacity();
  for (const Record& r : records_) sum += r.traces.capacity() * sizeof(Trace);
  return sum;
}

}  // namespace resect
