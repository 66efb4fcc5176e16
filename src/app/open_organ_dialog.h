// Dialog before a file is opened as an organ: its health, unit and part.
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

  // What was chosen; meaningful after accept().
  OrganSource source() const;

  QPoint openButton() const;  // its middle on the screen

  // Called with the displayed report when the file was examined.
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
  double longest_ = 0;            // of the bounds, file units
  double area_ = 0, volume_ = 0;  // squared and cubed; volume 0: the surface is open
  bool unitChosen_ = false;
};

}  // namespace resect
