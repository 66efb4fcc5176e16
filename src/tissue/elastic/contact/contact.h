// Contact of tissue with obstacles: instruments, the table, the tool box.
//
// Once per frame the points of the surface (contact/points.h) and the cells that can come near an
// obstacle are listed. After every substep the depth of each listed point inside the obstacle is
// computed. A point inside the obstacle is pressed out by a spring. The spring's force is spread to
// the cells with which the point moves. The spring stands for tissue that the lattice does not
// resolve: the half cell between the outermost cell centres and the surface, and dents that are
// smaller than a cell (docs/methods/tissue.md).
//
// Friction is computed cell by cell. A pressed cell loses the tangential part of its velocity
// relative to the obstacle, up to Coulomb's limit. The displacement that the lost velocity caused
// in the substep is undone. The force on the obstacle is the momentum that cells give to the
// obstacle in a frame, divided by the frame's duration.
//
// If the centre of a cell nevertheless lies too deep inside an obstacle, the centre is moved out.
// No centre may lie inside the table or the tool box. A centre may lie at most one spacing (side of
// a cell) deep inside an instrument. Instruments with blades, jaws or hooks are different, since
// they must be able to enter tissue (Obstacle::enters). Such an instrument presses no points, but
// cell centres are kept a tenth of a spacing away from it.
#pragma once

#include <vector>

#include "tissue/elastic/contact/dent.h"
#include "tissue/elastic/contact/mean_normals.h"
#include "tissue/elastic/contact/points.h"
#include "tissue/elastic/elastic_state.h"
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/tissue_model.h"

namespace resect {

class TissueContacts {
 public:
  // As TissueModel::setSurface().
  void setSurface(const ElasticState& state, const Lattice& lattice,
                  std::span<const SurfacePatch> patches) {
    points_.setSurface(state, lattice, patches);
  }

  // Call once per frame: lists the points and cells that can come near an obstacle in the frame.
  // duration: duration of the frame, s. origin: rest position of cell (0, 0, 0), m. gripper: for
  // each cell of the box, the number of the tool that grips the cell, or -1. If `gripper` is empty,
  // no cell is gripped. A tool does not push the cells that it grips.
  void list(const ElasticState& state, const ElasticKernel& kernel, const Vec3& origin,
            double duration, std::span<const Obstacle> obstacles,
            std::span<const std::int32_t> gripper);

  // Call after each substep: presses the tissue out of the obstacles. share: time at which the
  // substep ends, as a fraction of the frame, 0 to 1. dt: length of the substep, s. lookAhead:
  // SubstepConstants::lookAhead.
  void push(ElasticState& state, double share, double dt, double lookAhead);

  const ContactPoints& points() const { return points_; }
  // Per obstacle: momentum that cells have given to the obstacle since list(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  // Sets impulse() to zero.
  void forgetImpulses();
  // Discards the obstacles of the last list().
  void forgetObstacles() { bodyCount_ = 0; }

  // Appends the points at which the tool, in its pose at the end of the frame, presses the tissue.
  // The points are in the order of the cells. Takes as long as one substep takes for the points of
  // this tool.
  void pressedBy(const ElasticState& state, std::int32_t tool,
                 std::vector<PressedPoint>& points) const;
  // The obstacle that stands for the tool in the last list(); null if there is none.
  const Obstacle* obstacleOf(std::int32_t tool) const;

  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(points_, bodies_, bodyCount_, impulse_, slot_, found_, mean_, moved_, given_);
  }

 private:
  // A cell that an obstacle may push.
  struct Cell {
    std::int32_t cell;
    bool near;  // true: the centre may come near the obstacle; false: only points of the cell may
    Vec3 rest;  // rest position, m
  };
  // A point that an obstacle may press. Its position is `base` plus the mean displacement of the
  // cells that it follows.
  struct Point {
    Vec3f base;                 // m
    Vec3f inwards;              // unit, into the tissue
    float width;                // square root of the area of its patch, m
    float stiffness, damping;   // N/m, N s/m
    std::int32_t first, count;  // range of Body::shares that belongs to the point
  };
  struct Share {
    std::int32_t cell;  // index in Body::cells
    float weight;
  };
  // An obstacle in this frame, with the cells and points that it may press.
  struct Body {
    Obstacle obstacle;
    Vec3 velocity, spin;                   // of the obstacle, world, m/s and rad/s
    std::vector<std::int32_t> candidates;  // cells with points or centres that may come near it
    std::vector<Cell> cells;
    std::vector<Point> points;
    std::vector<Share> shares;
    Pose back;   // from the world to the obstacle's coordinates at the frame's end
    Aabb box;    // where the obstacle can touch cells, in its coordinates at the frame's end
    Aabb world;  // bounds of `box` in the world
    Vec3 up[2];  // if a half space: its outward normal at the start and at the end of the frame
  };
  // An obstacle's pose at the end of a substep, and its rotation as a matrix.
  struct Stance {
    Pose pose;
    Mat3 turn;
  };
  void listCells(const ElasticState& state, const Vec3& origin, double duration,
                 std::span<const std::int32_t> gripper);
  void listPoints(const ElasticState& state, const ElasticKernel& kernel, const Vec3& origin,
                  double duration, Body& body);
  void listPoint(const ElasticState& state, std::int32_t cell, const ContactPoint& point,
                 const Mat3& cof, const Vec3& normal, const Vec3& origin, double way, Body& body);
  std::int32_t slotOf(const ElasticState& state, std::int32_t cell, const Vec3& origin, Body& body);
  bool reaches(const Body& body, const Vec3& place, double way) const;
  void pressPoints(const ElasticState& state, const Body& body, const Stance& stance, double dt);
  static Dent dentOf(const Body& body, const Point& point, const Stance& stance, double spacing,
                     const Vec3& fromOrigin);
  void pushCentre(const ElasticState& state, const Body& body, const Stance& stance,
                  std::size_t cell, Vec3f& way, Vec3f& change) const;
  Vec3 pushCell(ElasticState& state, const Body& body, const Stance& stance, std::size_t cell,
                float dt, float lookAhead) const;

  ContactPoints points_;
  std::vector<Body> bodies_;  // the first bodyCount_ are in use
  std::size_t bodyCount_ = 0;
  std::vector<Vec3> impulse_;  // per obstacle, kg m/s

  // Work space, kept so that its memory is reused.
  std::vector<std::int32_t> slot_;   // per cell of the box: index in Body::cells, or -1
  std::vector<ContactPoint> found_;  // points of one cell
  MeanNormals mean_;
  std::vector<Column> moved_;  // displacements of Body::cells, m
  // Per entry of Body::cells: the momentum that points give to the cell in this substep, kg m/s.
  // The fourth component is above 0 if points gave the cell any momentum.
  std::vector<Column> given_;
};

}  // namespace resect
