// Trees of vessels while they grow: nodes, their radii, and whether a segment may be added.
//
// Constrained constructive optimisation (Schreiner and Buxbaum 1993; Jessen et al. 2022 for
// competing trees): each new terminal is joined to the segment where the join adds the least
// volume, if no vessel then leaves the organ or meets a vessel of another tree.
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
  int parent;     // node at the other end of the segment; -1: this is a root
  int terminals;  // number of terminals in the subtree that begins at this node
  int tree;       // 0: portal vein; from 1 on: one of the hepatic veins
  bool leaf;
  // Radii of the segment that ends at this node, m. given: the radius of a vessel that was not
  // grown, else 0; it is kept. most: upper limit of the radius; branches of a given vessel are no
  // wider than the vessel.
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
  // Adds existing vessels of one kind. Their parents are indices in `vessels`.
  void addGiven(std::span<const VesselSegment> vessels);
  // Adds a main branch with one terminal, which runs from a node to a place, past other vessels and
  // through the middle of the organ.
  void addTrunk(int from, const Vec3& to);
  // The point nearest to p that is at least `depth`, m, deep and where a main branch of the tree
  // has room; if there is none, the nearest point that is deep enough.
  Vec3 openPlace(const Vec3& p, double depth, int tree) const;
  // Adds a terminal to the portal vein (kind 0) or to one of the hepatic veins (kind 1). Returns
  // false, and adds nothing, if it can be joined to no segment.
  bool grow(const Vec3& place, int kind);

  static int kindOf(int tree) { return tree > 0 ? 1 : 0; }
  int terminals(int kind) const { return terminals_[std::size_t(kind)]; }
  double leafRadius(int kind) const { return leafRadius_[std::size_t(kind)]; }
  // Outer radius of a vessel with the radius r: the portal vein's sheath also contains artery and
  // duct.
  double outer(double r, int kind) const { return kind ? r : r * settings_.sheath; }
  // Radii of the segments that end at the nodes, m; 0 for roots. They are narrowed where a vessel
  // would otherwise leave the organ or meet one of the other kind.
  std::vector<double> finalRadii() const;

 private:
  struct Join {  // a way to join a new terminal to a segment
    double cost;
    int node;   // node at the segment's end
    Vec3 fork;  // where the new branch leaves; for a given segment, its end
  };

  // Radius, m, that a segment will have when its tree is fully grown, if it has `terminals` now.
  double radius(int terminals, int kind) const;
  // Present radius of the segment that ends at a node, m, if `more` terminals are added to it.
  double radiusOf(const GrowingNode& node, int more = 0) const;
  double checkRadius(const GrowingNode& node) const;
  int add(const Vec3& place, int parent, int tree, int terminals, bool leaf);
  std::vector<Join> joins(const Vec3& place, int kind) const;
  bool fits(const Join& join, const Vec3& place, int kind) const;
  bool fitsOnGiven(const GrowingNode& from, int node, const Vec3& place, int kind) const;
  void apply(const Join& join, const Vec3& place);
  struct Obstacle {  // for a main branch: a vessel of another tree, and the distance to keep
    Vec3 start, end;
    double keep;
    bool stem;  // the vessel comes from outside the organ
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
  double widest_ = 0;  // m: outer radius of the widest vessel
  // Cache of radius(): radius[n], m, for n terminals; 0: not computed yet. It is valid as long as
  // the kind has `grown` terminals in all.
  struct KnownRadii {
    int grown = 0;
    std::vector<double> radius;
  };
  mutable std::array<KnownRadii, 2> knownRadii_;
  std::vector<std::vector<int>> bins_;  // nodes whose segments pass near the bin
  Vec3i binDims_;
  Vec3 binOrigin_;
};

}  // namespace resect
