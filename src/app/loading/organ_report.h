// Makes texts for the window from the JSON that `resect info` prints about a file which is to
// become an organ. Also proposes a spacing for this organ.
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
  std::string about;      // volume, or why there is none: "1378 ml", "open, 12 boundary edges"
  std::string file = {};  // path of the image, if the part is an image of a folder
  std::optional<StructureKind> kind = {};  // kind that the name stands for; empty: none
};

// The parts of a model, the labels of an image or the images of a folder.
std::vector<FilePart> fileParts(const QJsonObject& info);

// Text about a surface: its size and its defects. roles: whether the user can give roles to the
// parts of the surface.
QString surfaceReport(const QJsonObject& info, bool roles);

// Text about a label image: its format, and notes about what Resect took from the image.
QString imageReport(const QJsonObject& info);

// Returns a question to the user: which label of an image is the organ? If `folder` is true: which
// image of a folder is the organ?
QString organQuestion(bool folder);

// Text about the size of an organ, with a warning if the size is not that of any organ. longest:
// longest side of the organ's bounding box, m. area: of the organ's surface, m^2. volume: m^3; 0:
// the surface is open. cavities: whether the volume includes cavities.
QString sizeText(double longest, double area, double volume, bool cavities);

// "about 7,300 particles", with two significant digits; "" for less than one.
QString particlesText(double particles);

// The proposed side of the cells, m. It is at most `usual`. It is less for a small organ, so that
// the organ has enough particles to show its shape. It is also less for a hollow organ, so that the
// wall is two cells thick. However, a thin wall never makes the side so small that the organ has
// more than 30,000 particles. volume: volume of the tissue, m^3, > 0. wall: mean thickness of a
// hollow organ's wall, m; 0: the organ is not hollow.
double proposedSpacing(double usual, double volume, double wall);

// Mean thickness of a hollow organ's wall; 0 if the organ is not hollow. The arguments may have any
// unit of length; the result has the same unit. volume: volume of the organ. area: area of the
// organ's surface. cavities: volume of the cavities that are to be subtracted from `volume`.
// innerShells: whether the surface already has inner shells that bound cavities.
double wallThickness(double volume, double area, double cavities, bool innerShells);

}  // namespace resect
