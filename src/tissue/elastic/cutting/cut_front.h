// Cutting by energy: the edge of an instrument cuts elastic tissue only as far as it has done the
// work that the cut needs. docs/methods/cutting.md derives the method.
//
// The edge is sampled at points at most half a spacing apart. A sample in tissue is tied to a point
// of the tissue at rest by a stiff spring, the tie. If the force of the spring would exceed the cut
// energy (J/m^2) times the length of edge that the sample stands for, the tied point moves on
// through the tissue at rest. This motion is the cut: the surface that the tied points sweep in a
// frame is passed on as a blade in rest space. Until a tied point moves on, the edge only indents
// the tissue. So the front of the cut lags behind the instrument.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/elastic/cutting/rest_point.h"
#include "tissue/obstacle.h"

namespace resect {

// The state of a sample of an edge between two frames.
struct CutSample {
  bool known = false;          // whether tissue is near, so that `place` is known
  bool tied = false;           // whether the sample is tied to the tissue at `place`
  bool cutting = false;        // whether it swept through tissue at the end of the last frame
  Vec3 place = Vec3::Zero();   // where the sample is in the tissue: a point of rest space, m
  Vec3 motion = Vec3::Zero();  // velocity of the instrument there, m/s, smoothed over 0.03 s
  double lean = 1;             // cosine of the angle between `motion` and the cut's direction

  template <class Visitor>
  void visit(Visitor& v) {
    v("known", known), v("tied", tied), v("cutting", cutting), v("place", place),
        v("motion", motion), v("lean", lean);
  }
};

struct CutFront {
  std::int32_t tool = -1, edge = 0;  // which edge of which instrument
  std::vector<CutSample> samples;    // in order along the edge

  template <class Visitor>
  void visit(Visitor& v) {
    v("tool", tool), v("edge", edge), v("samples", samples);
  }
};

// Work and energy of all edges in a frame. The work that the cut took is `given` minus `taken`,
// minus the increase of `held` since the previous frame.
struct CutWork {
  double area = 0;   // area that was cut, in rest space, m^2
  double given = 0;  // work of the instruments on the ties, J
  double taken = 0;  // work of the ties on the tissue, J
  double held = 0;   // elastic energy of the ties at the end of the frame, J
  double cut = 0;    // energy that the cut should take, J: cut energy per area times area
};

class CutFronts {
 public:
  // Call once per frame: finds where the edges of the obstacles are in the tissue. duration: of the
  // frame, s. dt: the tissue's longest substep, s.
  void list(const RestTissue& rest, double duration, double dt,
            std::span<const Obstacle> obstacles);
  // Call after each substep: pulls the tissue with the edges, and lets ties move on. share: the
  // fraction of the frame at which the substep ends, 0 to 1. dt: length of the substep, s.
  // lookAhead: SubstepConstants::lookAhead.
  void push(const RestTissue& rest, ElasticState& state, double share, double dt, double lookAhead);
  // Appends the cuts made since list(), one for each edge that cut.
  void appendCuts(std::vector<TissueCut>& cuts) const;
  // Sets everything back to the state after list(), for another attempt at the frame.
  void startAgain(const RestTissue& rest);

  // Per obstacle: momentum that the ties have given to it since list(), kg m/s.
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
    Vec3 point, tangent, outwards;  // in the edge's coordinates; m, unit, unit
    Vec3 start;                     // CutSample::place when the present sweep began, m
    bool swept = false;             // whether it has cut since `start` without a break
    bool inside = false;            // whether its length of edge was last found in tissue
    bool spent = false;  // untied in this frame: it is not tied again before the next frame
    Mat3 toRest = Mat3::Identity();  // inverse of the deformation gradient at the tie
    PointCells cells;
    Vec3 cellsAt, askedAt, lengthAt;  // CutSample::place when `cells`, `ahead`, `length` were found
    bool ahead = false;               // whether an intact bond lies ahead (tissueAhead())
    double length = 0;                // length of edge in tissue that the sample stands for, m
    double toughness = 0;             // cut energy of the tissue times the edge's bluntness, J/m^2
    Vec3 force = Vec3::Zero();        // on the tissue, N
    Vec3 motion = Vec3::Zero();       // velocity of the instrument at the sample, m/s
  };
  struct Edge {
    CuttingEdge edge;
    std::size_t obstacle = 0;
    double step = 0;  // length of edge that a sample stands for, m
    std::vector<Sample> samples;
  };
  static constexpr double kStretchedSteps = 3;  // greatest distance of joined samples / Edge::step
  // A cell near an edge.
  struct Candidate {
    std::int32_t cell;
    Vec3 place;  // world, m
  };

  Edge& edgeOf(std::size_t number);
  void findCandidates(const RestTissue& rest, const CuttingEdge& edge);
  void locate(const RestTissue& rest, const Vec3& point, double reach, CutSample& sample,
              Sample& now) const;
  // In cut_tie.cpp: computes a substep of an edge's samples. pose: of the edge.
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
