// Text for the window from the JSON of `resect info` about a file that is to become an organ, and
// the spacing that is proposed for this organ.
#pragma once

#include <QJsonObject>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/structure_kind.h"

namespace resect {

// A part of a model, a label of an image, or an image of a folder.
struct FilePart {
  std::string part;       // as OrganSource::part names it
  std::string name;       // for people
  std::string about;      // its volume, or why it has none: "1378 ml", "open, 12 boundary edges"
  std::string file = {};  // of a folder's image
  std::optional<StructureKind> kind = {};  // what its name tells
};

// The parts of a model, the labels of an image or the images of a folder.
std::vector<FilePart> fileParts(const QJsonObject& info);

// About the health of a surface. roles: whether the user can give its parts roles.
QString surfaceReport(const QJsonObject& info, bool roles);

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
