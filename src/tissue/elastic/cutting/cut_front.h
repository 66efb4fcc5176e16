// Cutting by energy: a cut in elastic tissue takes a given energy per area. So the area that an
// instrument's edge has cut is limited by the work that the edge has done. docs/methods/cutting.md
// derives the method.
//
// The edge is represented by points on it, the samples, at most half a spacing (half a cell) apart.
// A stiff spring, the tie, connects a sample in tissue to a point of the tissue, the tied point. A
// tie can bear a force up to the cut energy (J/m^2) times the length of edge that the sample stands
// for. If the force would be larger, the tied point moves on through the tissue. This motion is the
// cut: the surface that the tied points sweep in rest space in a frame is the result
// (appendCuts()). Until the tied points move on, the edge only indents the tissue. So the front of
// the cut lags behind the instrument.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/elastic/cutting/rest_point.h"
#include "tissue/obstacle.h"

namespace resect {

// The state of a sample of an edge between two frames.
struct CutSample {
  bool known = false;         // whether tissue is near, so that `place` is known
  bool tied = false;          // whether the sample is tied to the tissue at `place`
  bool cutting = false;       // whether the sample was cutting when the last frame ended
  Vec3 place = Vec3::Zero();  // position of the sample in the tissue, in rest space, m
  // Velocity of the instrument at the sample, smoothed over 0.03 s, m/s.
  Vec3 motion = Vec3::Zero();
  double lean = 1;  // cosine of the angle between `motion` and the direction in which the edge cuts

  template <class Visitor>
  void visit(Visitor& v) {
    v("known", known), v("tied", tied), v("cutting", cutting), v("place", place),
        v("motion", motion), v("lean", lean);
  }
};

struct CutFront {
  std::int32_t tool = -1, edge = 0;  // number of the instrument, and number of its edge
  std::vector<CutSample> samples;    // in order along the edge

  template <class Visitor>
  void visit(Visitor& v) {
    v("tool", tool), v("edge", edge), v("samples", samples);
  }
};

// Work and energy of all edges in a frame. To get the work that the cut took, subtract from `given`
// both `taken` and the increase of `held` since the previous frame.
struct CutWork {
  double area = 0;   // area that was cut, in rest space, m^2
  double given = 0;  // work of the instruments on the ties, J
  double taken = 0;  // work of the ties on the tissue, J
  double held = 0;   // elastic energy of the ties at the end of the frame, J
  double cut = 0;    // energy that the cut should take: cut energy per area times area, J
};

class CutFronts {
 public:
  // Call once per frame: finds where the edges of the obstacles are in the tissue. duration:
  // duration of the frame, s. dt: the tissue's longest substep, s.
  void list(const RestTissue& rest, double duration, double dt,
            std::span<const Obstacle> obstacles);
  // Call after each substep: lets the ties pull the tissue, and lets tied points move on. share:
  // time at which the substep ends, as a fraction of the frame, 0 to 1. dt: length of the substep,
  // s. lookAhead: SubstepConstants::lookAhead.
  void push(const RestTissue& rest, ElasticState& state, double share, double dt, double lookAhead);
  // Appends the cuts made since list(), one for each edge that cut.
  void appendCuts(std::vector<TissueCut>& cuts) const;
  // Restores the state that list() left, so that the frame can be computed again.
  void startAgain(const RestTissue& rest);

  // Per obstacle: momentum that the ties have given to the obstacle since list(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  CutWork work() const { return work_; }
  std::span<const CutFront> fronts() const { return fronts_; }
  // Whether a loaded state is valid: all numbers are finite.
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
    Vec3 point, tangent, outwards;   // in the edge's coordinates; point: m; others: unit
    Vec3 start;                      // CutSample::place where its cut began in this frame, m
    bool swept = false;              // whether it has cut without a break from `start` to here
    bool inside = false;             // whether its piece of the edge was last found in tissue
    bool spent = false;              // untied in this frame; not tied again before the next frame
    Mat3 toRest = Mat3::Identity();  // inverse of the deformation gradient at the tie
    PointCells cells;
    // Values of CutSample::place for which `cells`, `ahead` and `length` were computed.
    Vec3 cellsAt, askedAt, lengthAt;
    bool ahead = false;          // whether an intact bond lies ahead (tissueAhead())
    double length = 0;           // length of edge in tissue that the sample stands for, m
    double toughness = 0;        // cut energy of the tissue times the edge's bluntness, J/m^2
    Vec3 force = Vec3::Zero();   // force of the tie on the tissue, N
    Vec3 motion = Vec3::Zero();  // velocity of the instrument at the sample, m/s
  };
  struct Edge {
    CuttingEdge edge;
    std::size_t obstacle = 0;
    double step = 0;  // length of edge that a sample stands for, m
    std::vector<Sample> samples;
  };
  // Neighbouring samples that are farther apart than this, in units of Edge::step, are not joined
  // to one cut.
  static constexpr double kStretchedSteps = 3;
  // A cell near an edge.
  struct Candidate {
    std::int32_t cell;
    Vec3 place;  // world, m
  };

  Edge& edgeOf(std::size_t number);
  void findCandidates(const RestTissue& rest, const CuttingEdge& edge);
  void locate(const RestTissue& rest, const Vec3& point, double reach, CutSample& sample,
              Sample& now) const;
  // In cut_tie.cpp: computes a substep for the samples of an edge. pose: pose of the edge.
  struct Pull;
  void pullSamples(const RestTissue& rest, Edge& edge, CutFront& front, const Pose& pose,
                   double dt);
  bool tie(Pull& pull);
  void letGo(Pull& pull);
  void pullTie(Pull& pull);

  std::vector<CutFront> fronts_;  // state
  std::vector<CutFront> kept_;    // fronts_ at the beginning of the frame
  std::vector<Edge> edges_;       // the edges of fronts_, in the same order
  std::vector<Vec3> impulse_;
  CutWork work_;
  std::vector<Candidate> candidates_;
  double duration_ = 0;  // duration of the frame, s
  // Stiffness and damping of a tie, divided by the length of its piece of the edge and by the
  // density of the tissue: m^2/s^2 and m^2/s.
  double stiffness_ = 0, damping_ = 0;
};

}  // namespace resect
