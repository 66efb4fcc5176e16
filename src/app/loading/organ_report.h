// Text for the window from the JSON of `resect info` about a file that is to become an organ, and
// the spacing that is proposed for this organ.
#pragma once

#include <QJsonObject>
#include <QString>

namespace resect {

// About the health of a surface. roles: whether the user can give its parts roles.
QString surfaceReport(const QJsonObject& info, bool roles);

// What keeps a part from having a volume; "" if nothing does.
QString openEdges(int boundaryEdges);

// What was taken from a label image: the notes about it.
QString imageReport(const QJsonObject& info);

// "about 7,300 particles", with two significant digits; "" for less than one.
QString particlesText(double particles);

// Side of the cells, m: `usual`, or less for a small organ, which would have too few particles to
// show its shape, or for a hollow one, whose wall has to be two cells thick. volume: of tissue,
// m^3, > 0. wall: mean thickness of a hollow organ's wall, m; 0: the organ is not hollow.
double proposedSpacing(double usual, double volume, double wall);

// Mean thickness of a hollow organ's wall; 0 if the organ is not hollow. In any unit of length: the
// organ's volume and the area of its surface, and the volume of the cavities that are to be taken
// from it. innerShells: whether shells of the surface bound cavities already.
double wallThickness(double volume, double area, double cavities, bool innerShells);

}  // namespace resect
