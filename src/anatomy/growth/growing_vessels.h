// Trees of vessels while they grow: nodes, their radii, and which segments may be added.
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
  int terminals;  // below this node
  int tree;       // 0: portal vein; from 1: the trunks of the hepatic veins
  bool leaf;
  // Of the segment that ends here, m. A vessel that was given keeps its radius; what grows from it
  // is no wider.
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
  // Vessels of one kind that are there already; their parents count from the first one.
  void addGiven(std::span<const VesselSegment> vessels);
  // A first branch with one terminal from a node to a place, round corners.
  void addTrunk(int from, const Vec3& to);
  // The place nearest to p that is `depth` deep and where a first branch of the tree has room.
  Vec3 openPlace(const Vec3& p, double depth, int tree) const;
  // Adds a terminal to the portal vein (kind 0) or to any trunk of the hepatic veins (1). Returns
  // false if it fits nowhere.
  bool grow(const Vec3& place, int kind);

  static int kindOf(int tree) { return tree > 0 ? 1 : 0; }
  int terminals(int kind) const { return terminals_[std::size_t(kind)]; }
  double leafRadius(int kind) const { return leafRadius_[std::size_t(kind)]; }
  // Outer radius of a vessel of radius r: the portal vein's sheath holds artery and duct.
  double outer(double r, int kind) const { return kind ? r : r * settings_.sheath; }
  // Radii of the segments that end at the nodes, narrowed where a vessel would still leave the
  // organ or meet one of the other kind.
  std::vector<double> finalRadii() const;

 private:
  struct Join {  // of a terminal with a segment
    double cost;
    int node;   // at the segment's end
    Vec3 fork;  // within the segment; of one that was given, its end
  };

  double radius(int terminals, int kind) const;  // when all have grown
  // The same for a segment, if so many terminals are added to it.
  double radiusOf(const GrowingNode& node, int more = 0) const;
  double checkRadius(const GrowingNode& node) const;
  int add(const Vec3& place, int parent, int tree, int terminals, bool leaf);
  std::vector<Join> joins(const Vec3& place, int kind) const;
  bool fits(const Join& join, const Vec3& place, int kind) const;
  bool fitsOnGiven(const GrowingNode& from, int node, const Vec3& place, int kind) const;
  void apply(const Join& join, const Vec3& place);
  struct Obstacle {  // to a first branch: a vessel of another tree, and the distance to keep
    Vec3 start, end;
    double keep;
    bool stem;  // it comes from outside
  };
  std::vector<Obstacle> obstacles(int tree) const;
  std::vector<Vec3> route(const Vec3& from, const Vec3& to, int tree) const;
  bool kin(int segment, int node) const;
  bool clearOfOthers(const Vec3& a, const Vec3& b, double outer, int tree) const;
  bool clearOfOwn(const Vec3& a, const Vec3& b, double radius, int tree, int first,
                  int second) const;

  // visit(bin) gives whether to go on.
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
  struct KnownRadii {  // by terminals, while as many have grown; 0: not asked for yet
    int grown = 0;
    std::vector<double> radius;
  };
  mutable std::array<KnownRadii, 2> knownRadii_;
  std::vector<std::vector<int>> bins_;  // nodes whose segments pass near the bin
  Vec3i binDims_;
  Vec3 binOrigin_;
};

}  // namespace resect
