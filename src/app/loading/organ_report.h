// Makes texts for the window from the JSON that `resect info` prints about a file which is to
// become an organ. Also proposes a spacing for this organ.
#pragma once

#include <QJsonObject>
#include <QString>

namespace resect {

// Text about a surface: its size and its defects. roles: whether the user can give roles to the
// parts of the surface.
QString surfaceReport(const QJsonObject& info, bool roles);

// Text about the open edges of a part. A part with open edges has no volume. The text is "" if
// there are no open edges.
QString openEdges(int boundaryEdges);

// Text about a label image: its format, and the notes about what was taken from it.
QString imageReport(const QJsonObject& info);

// "about 7,300 particles", with two significant digits; "" for less than one.
QString particlesText(double particles);

// The proposed side of the cells, m. It is at most `usual`. It is less for a small organ, so that
// the organ has enough particles to show its shape. It is also less for a hollow organ, so that the
// wall is two cells thick. However, a thin wall never makes the side so small that the organ has
// more than 30,000 particles. volume: volume of the tissue, m^3, > 0. wall: mean thickness of a
// hollow organ's wall, m; 0: the organ is not hollow.
double proposedSpacing(double usual, double volume, double wall);

}  // namespace resect
