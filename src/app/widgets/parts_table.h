// What each part of a file is: the organ, something in it, or nothing that is wanted.
#pragma once

#include <QTableWidget>
#include <functional>
#include <string>
#include <vector>

#include "operation/scenario.h"

namespace resect {

// A part of a model, or a label of an image.
struct FilePart {
  std::string part;   // as OrganSource::part names it
  std::string name;   // for people
  std::string about;  // "1378 ml", "open, 12 edges"
};

class PartsTable : public QTableWidget {
 public:
  explicit PartsTable(QWidget* parent = nullptr);

  // Roles are proposed by the names. If no name tells an organ, all parts of a model are the organ,
  // as one body, and no label of an image is.
  void fill(const std::vector<FilePart>& parts, bool image);
  void setAbout(int row, const QString& about) { item(row, 1)->setText(about); }
  bool filled() const { return !parts_.empty(); }

  bool hasOrgan() const;  // whether a part is the organ
  // Sets part and structures of a source whose file has these parts.
  void applyTo(OrganSource& source) const;

  QPoint rolePlace(int row) const;  // middle of the row's choice of roles, in screen coordinates

  std::function<void()> changed;  // called when a role was chosen

 private:
  // Of a row: -1 if it is left out, 0 for the organ, else 1 + number of the kind.
  int roleOf(int row) const;

  std::vector<FilePart> parts_;
};

}  // namespace resect
