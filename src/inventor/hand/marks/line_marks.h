// Lines in the scene that inform the user. The lines are drawn without lighting, and the mouse
// cannot pick them.
#pragma once

#include <vector>

#include "geometry/aabb.h"

class SoBaseColor;
class SoCoordinate3;
class SoLineSet;
class SoSeparator;
class SoSwitch;

namespace resect {

struct MarkLine {
  Vec3f colour;              // screen colour (sRGB), 0 to 1
  std::vector<Vec3> points;  // world, m
};

// Points along a closed circle. middle, radius: m. axis: normal of the circle's plane, unit.
std::vector<Vec3> circle(const Vec3& middle, double radius, const Vec3& axis);

class LineMarks {
 public:
  struct Style {
    float width = 2;            // pixels
    bool throughTissue = true;  // the lines can be seen through tissue
    double seen = 0.5e-3;       // m: show() ignores smaller motions of the lines
  };
  LineMarks(SoSeparator* parent, const Style& style);
  ~LineMarks();
  LineMarks(const LineMarks&) = delete;
  LineMarks& operator=(const LineMarks&) = delete;

  // Shows `lines` instead of the previous lines. If `lines` is empty, no line is shown. Returns the
  // box that must be drawn again; world, m. The box is empty if nothing has changed visibly.
  Aabb show(std::vector<MarkLine> lines);

 private:
  bool alike(const std::vector<MarkLine>& lines) const;

  SoSeparator* parent_;
  SoSwitch* root_;
  SoBaseColor* colours_;
  SoCoordinate3* corners_;
  SoLineSet* lines_;
  double seen_;
  std::vector<MarkLine> shown_;
  Aabb box_;  // bounds of the lines as shown now, world, m
};

}  // namespace resect
