// Cutting by energy: where the edge of an instrument is in elastic tissue, it cuts only as far as
// it has done the work that a cut takes. docs/methods/cutting.md derives the method.
//
// The edge is sampled at points at most half a spacing apart. A sample in tissue is tied to a point
// of the tissue by a stiff spring. When the spring bears more than the cut energy times the length
// of the edge, the tie moves on through the tissue at rest, and that is the cut. What the ties
// sweep in a frame is handed on as a blade in rest space. The tissue between the tie and its place
// at rest is indented: the front of the cut lags behind the hand.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/elastic/cutting/rest_point.h"
#include "tissue/obstacle.h"

namespace resect {

// A sample of an edge; the state between two frames.
struct CutSample {
  bool known = false;          // whether `place` is known: tissue is near
  bool tied = false;           // whether the edge is held by tissue there
  bool cutting = false;        // whether it swept through tissue at the end of the last frame
  Vec3 place = Vec3::Zero();   // the point of the tissue at rest where the edge is, m
  Vec3 motion = Vec3::Zero();  // of the hand at the sample, m/s, smoothed over kHandTime
  double lean = 1;             // cosine of the angle between that motion and the cut's direction

  template <class Visitor>
  void visit(Visitor& v) {
    v("known", known), v("tied", tied), v("cutting", cutting), v("place", place),
        v("motion", motion), v("lean", lean);
  }
};

struct CutFront {
  std::int32_t tool = -1, edge = 0;  // which edge of which instrument
  std::vector<CutSample> samples;    // in the order of the edge

  template <class Visitor>
  void visit(Visitor& v) {
    v("tool", tool), v("edge", edge), v("samples", samples);
  }
};

// What the edges have done in a frame. What was given, neither taken nor held, went into the cut.
struct CutWork {
  double area = 0;   // cut, m^2, at rest
  double given = 0;  // work of the hand on the ties, J
  double taken = 0;  // work of the ties on the tissue, J
  double held = 0;   // energy in the ties at the end of the frame, J
  double cut = 0;    // cut energy times area, J: what the cut should take
};

class CutFronts {
 public:
  // Once per frame: finds where the edges of the obstacles are in the tissue. duration: of the
  // frame, s. dt: the tissue's longest substep, s.
  void list(const RestTissue& rest, double duration, double dt,
            std::span<const Obstacle> obstacles);
  // After each substep: pulls the tissue with the edges, and lets ties move on. share: when it
  // ends, as a fraction of the frame, 0 to 1. dt: length of the substep, s. lookAhead:
  // SubstepConstants::lookAhead.
  void push(const RestTissue& rest, ElasticState& state, double share, double dt, double lookAhead);
  // Appends what was cut since list().
  void appendCuts(std::vector<TissueCut>& cuts) const;
  // Sets everything back to the state after list(), for another attempt at the frame.
  void startAgain(const RestTissue& rest);

  // Per obstacle: momentum that tissue has given to it since list(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  CutWork work() const { return work_; }
  std::span<const CutFront> fronts() const { return fronts_; }
  // Throws nothing: whether a loaded state is sound.
  bool fit() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("fronts", fronts_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(kept_, edges_, impulse_, work_, candidates_, duration_, stiffness_, damping_);
  }

 private:
  // A sample in this frame.
  struct Sample {
    Vec3 point, tangent, outwards;  // in the edge's coordinates; m, unit, unit
    Vec3 start;                     // of the sweep: the tie at rest when it began, m
    bool swept = false;             // it has cut since `start`, without a break
    bool inside = false;            // it stood for edge in tissue when it was looked at last
    bool spent = false;  // it was let go in this frame, and is not tied again before the next
    Mat3 toRest = Mat3::Identity();  // inverse of F at the tie
    PointCells cells;
    Vec3 cellsAt, askedAt, lengthAt;  // where `cells`, `ahead` and `length` were found
    bool ahead = false;               // an intact bond lies ahead
    double length = 0;                // of the edge in tissue that the sample stands for, m
    double toughness = 0;             // J of the tissue there times the edge's bluntness, J/m^2
    Vec3 force = Vec3::Zero();        // on the tissue, N
    Vec3 motion = Vec3::Zero();       // of the hand, m/s
  };
  struct Edge {
    CuttingEdge edge;
    std::size_t obstacle = 0;
    double step = 0;  // length of edge that a sample stands for, m
    std::vector<Sample> samples;
  };
  static constexpr double kStretchedSteps = 3;  // samples farther apart are not neighbours
  // A cell near an edge.
  struct Candidate {
    std::int32_t cell;
    Vec3 place;  // world, m
  };

  Edge& edgeOf(std::size_t number);
  void findCandidates(const RestTissue& rest, const CuttingEdge& edge);
  void locate(const RestTissue& rest, const Vec3& point, double reach, CutSample& sample,
              Sample& now) const;
  // In cut_tie.cpp: what happens to the samples of an edge in a substep. pose: of the edge.
  struct Pull;
  void pullSamples(const RestTissue& rest, Edge& edge, CutFront& front, const Pose& pose,
                   double dt);
  bool tie(Pull& pull);
  void letGo(Pull& pull);
  void pullTie(Pull& pull);

  std::vector<CutFront> fronts_;  // state
  std::vector<CutFront> kept_;    // at the beginning of the frame
  std::vector<Edge> edges_;       // of fronts_, in the same order
  std::vector<Vec3> impulse_;
  CutWork work_;
  std::vector<Candidate> candidates_;
  double duration_ = 0;                 // of the frame, s
  double stiffness_ = 0, damping_ = 0;  // of a tie, per length of edge and density
};

}  // namespace resect
