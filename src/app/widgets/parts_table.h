// A table in which the user gives each part of a file a role. The roles are: the organ; a structure
// in the organ; left out.
#pragma once

#include <QTableWidget>
#include <functional>
#include <string>
#include <vector>

#include "app/loading/organ_report.h"
#include "operation/scenario.h"

namespace resect {

class PartsTable : public QTableWidget {
 public:
  explicit PartsTable(QWidget* parent = nullptr);

  // Fills the table with the parts of a file, and proposes a role for each part by its name
  // (structureKind()). A part is left out if its name stands for no kind, or if it is a
  // gallbladder.
  //
  // If no part has the name of an organ's tissue, other rules apply. In an image, all labels are
  // left out. In a model, the parts that the rules above leave out become the organ, and the other
  // parts keep their roles. If the rules above leave out no part of the model, all parts become the
  // organ.
  void fill(const std::vector<FilePart>& parts, bool image);
  void setAbout(int row, const QString& about) { item(row, 1)->setText(about); }
  bool filled() const { return !parts_.empty(); }

  // Whether any part has the role of the organ. For the images of a folder: whether exactly one
  // image has this role.
  bool hasOrgan() const;
  const FilePart& organ() const;  // the first part that is the organ; hasOrgan() must be true
  bool isCavity(int row) const;
  // Sets source.part and source.structures as the roles say. source.file must be the file that has
  // these parts. If source.file is a folder, it is replaced by the path of the organ's image.
  void applyTo(OrganSource& source) const;

  QPoint rolePlace(int row) const;  // centre of the row's list of roles, in screen coordinates

  std::function<void()> changed;  // called when the user has chosen a role

 private:
  // Role of a row: -1: left out; 0: the organ; 1 + number of a StructureKind: a structure.
  int roleOf(int row) const;

  bool ofFolder() const { return !parts_.empty() && !parts_[0].file.empty(); }

  std::vector<FilePart> parts_;
};

}  // namespace resect
