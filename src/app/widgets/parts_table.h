// A table in which the user gives each part of a file its role: it is the organ, it is a structure
// in the organ, or it is left out.
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

  // Proposes a role for each part by its name (structureKind()). Parts whose names tell no kind,
  // and gallbladders, are left out. If no part's name means the organ, then: in an image, all
  // labels are left out; in a model, the parts that would be left out are the organ, or, if there
  // are none, all parts are.
  void fill(const std::vector<FilePart>& parts, bool image);
  void setAbout(int row, const QString& about) { item(row, 1)->setText(about); }
  bool filled() const { return !parts_.empty(); }

  // Whether any part has the role of the organ; of a folder's images, whether exactly one has it.
  bool hasOrgan() const;
  const FilePart& organ() const;  // the first one with this role; hasOrgan() must be true
  bool isCavity(int row) const;
  // Sets source.part and source.structures by the roles. The file of `source` has these parts. Of a
  // folder's images, source.file becomes the organ's.
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
