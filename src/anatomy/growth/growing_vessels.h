// Trees of vessels while they grow: nodes, their radii, and whether a segment may be added.
//
// Method: constrained constructive optimisation (Schreiner and Buxbaum 1993; Jessen et al. 2022 for
// competing trees). A new terminal, that is, a new end of a tree, can be joined to one of the
// segments nearest to the terminal. Joins by which a vessel would leave the organ or meet another
// vessel are not allowed. Of the allowed joins, the one that adds the least volume is made.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/growth/vessel_growth.h"

namespace resect {

struct GrowingNode {
  Vec3 place;
  // The node at the start of the segment that ends at this node; -1: this node is a root.
  int parent;
  int terminals;  // number of terminals in the subtree that begins at this node
  int tree;       // 0: the portal vein; 1 or more: a hepatic vein
  bool leaf;
  // Two radii of the segment that ends at this node, m. given: radius of a segment that existed
  // before the growth; this radius never changes. If the segment was grown, `given` is 0. most:
  // upper limit of the radius. A branch of an existing vessel is no wider than this vessel.
  double given = 0;
  double most = std::numeric_limits<double>::infinity();
};

class GrowingVessels {
 public:
  GrowingVessels(const OrganInside& inside, const VesselGrowth& settings);

  const std::vector<GrowingNode>& nodes() const { return nodes_; }
  int addRoot(const Vec3& place, int tree) { return add(place, -1, tree, 0, false); }
  int addStem(const Vec3& place, int root) {
    return add(place, root, nodes_[std::size_t(root)].tree, 0, false);
  }
  // Adds existing vessels of one kind. VesselSegment::parent is an index in `vessels`.
  void addGiven(std::span<const VesselSegment> vessels);
  // Adds a main branch with one terminal. The branch runs from the node `from` to the point `to`,
  // through the middle of the organ and past other vessels.
  void addTrunk(int from, const Vec3& to);
  // Searches the points of OrganInside::places() that are at least `depth`, m, deep. Returns the
  // point nearest to p at which a main branch of the tree would keep clear of other vessels. If
  // there is no such point, returns the point nearest to p that is deep enough.
  Vec3 openPlace(const Vec3& p, double depth, int tree) const;
  // Adds a terminal to the portal vein (kind 0) or to one of the hepatic veins (kind 1). If the
  // terminal can be joined to no segment, nothing is added and the result is false.
  bool grow(const Vec3& place, int kind);

  static int kindOf(int tree) { return tree > 0 ? 1 : 0; }
  int terminals(int kind) const { return terminals_[std::size_t(kind)]; }
  double leafRadius(int kind) const { return leafRadius_[std::size_t(kind)]; }
  // Outer radius of a vessel with the radius r. For the portal vein this is the radius of its
  // sheath, which also contains the artery and the bile duct.
  double outer(double r, int kind) const { return kind ? r : r * settings_.sheath; }
  // Radii of the segments that end at the nodes, m; 0 for roots. A segment is narrowed if it would
  // otherwise leave the organ or meet a vessel of the other kind.
  std::vector<double> finalRadii() const;

 private:
  struct Join {  // a way to join a new terminal to a segment
    double cost;
    int node;  // node at the segment's end
    // The point where the new branch begins. On a segment that existed before the growth, this is
    // the end of the segment.
    Vec3 fork;
  };

  // Radius, m, that a segment will have when its tree is fully grown. terminals: present number of
  // terminals in the segment's subtree.
  double radius(int terminals, int kind) const;
  // Radius, m, of the segment that ends at a node, after `more` terminals have been added to the
  // segment. It is computed by radius(), unless the segment existed before the growth.
  double radiusOf(const GrowingNode& node, int more = 0) const;
  double checkRadius(const GrowingNode& node) const;
  int add(const Vec3& place, int parent, int tree, int terminals, bool leaf);
  std::vector<Join> joins(const Vec3& place, int kind) const;
  bool fits(const Join& join, const Vec3& place, int kind) const;
  bool fitsOnGiven(const GrowingNode& from, int node, const Vec3& place, int kind) const;
  void apply(const Join& join, const Vec3& place);
  // A segment of another tree. The middle line of a main branch must stay at least the distance
  // `keep`, m, away from the segment's middle line.
  struct Obstacle {
    Vec3 start, end;
    double keep;
    bool stem;  // the segment comes from outside the organ
  };
  std::vector<Obstacle> obstacles(int tree) const;
  std::vector<Vec3> route(const Vec3& from, const Vec3& to, int tree) const;
  bool kin(int segment, int node) const;
  bool clearOfOthers(const Vec3& a, const Vec3& b, double outer, int tree) const;
  bool clearOfOwn(const Vec3& a, const Vec3& b, double radius, int tree, int first,
                  int second) const;

  // visit(bin) returns whether to continue.
  template <typename Visit>
  void visitBins(const Vec3& a, const Vec3& b, double reach, Visit visit) const;
  void putIntoBins(int node);
  void takeFromBins(int node);

  const OrganInside& inside_;
  VesselGrowth settings_;
  std::vector<GrowingNode> nodes_;
  std::array<int, 2> terminals_{};
  std::array<double, 2> leafRadius_{};
  double widest_ = 0;  // outer radius of the widest vessel, m
  // Results of radius() for one kind of vessel. radius[n]: result for n terminals, m; 0: not
  // computed yet. The results are valid as long as all trees of the kind together have `grown`
  // terminals.
  struct KnownRadii {
    int grown = 0;
    std::vector<double> radius;
  };
  mutable std::array<KnownRadii, 2> knownRadii_;
  // Bins are the boxes of a grid. Per bin: the nodes whose segments pass near the bin.
  std::vector<std::vector<int>> bins_;
  Vec3i binDims_;
  Vec3 binOrigin_;
};

}  // namespace resect
