// Dialog shown before a file is opened as an organ: health of the mesh, unit, part, repair,
// spacing.
#pragma once

#include <QDialog>
#include <functional>

#include "app/organ_loader.h"
#include "operation/scenario.h"

class QComboBox;
class QCheckBox;
class QDoubleSpinBox;
class QJsonArray;
class QLabel;
class QPushButton;

namespace resect {

class OpenOrganDialog : public QDialog {
 public:
  OpenOrganDialog(const std::string& file, const OrganSource& before, QWidget* parent = nullptr);

  // The user's choices; valid after accept().
  OrganSource source() const;

  QPoint openButton() const;  // centre of the button on the screen

  // Called with the displayed report each time the file has been examined.
  std::function<void(const std::string&)> examined;

 private:
  bool show(const std::string& json, const std::string& problem);
  void tell(const QString& text);
  void unitChanged();
  void examine();
  int likelyUnit() const;
  bool listParts(const QJsonArray& parts);

  std::string file_;
  OrganSource before_;
  FileExaminer examiner_;
  QLabel *report_, *size_;
  QComboBox *unit_, *part_;
  QCheckBox* repair_;
  QDoubleSpinBox* spacing_;
  QPushButton* open_;
  double longest_ = 0;            // side of the bounding box, file units
  double area_ = 0, volume_ = 0;  // file units squared and cubed; volume 0: open surface
  bool unitChosen_ = false;
};

}  // namespace resect
