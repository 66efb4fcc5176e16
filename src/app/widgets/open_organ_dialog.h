// Dialog shown before a file is opened as an organ. It shows what is wrong with the mesh (open
// edges, wrong orientation) and asks for unit, part, repair, axes and spacing.
#pragma once

#include <QDialog>
#include <QTemporaryDir>
#include <array>
#include <functional>
#include <optional>

#include "app/loading/organ_loader.h"
#include "operation/scenario.h"

class QComboBox;
class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QJsonArray;
class QJsonObject;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace resect {

class PartsTable;
class SurfaceView;

class OpenOrganDialog : public QDialog {
 public:
  // before: source of the organ that was opened last. The dialog proposes the spacing of this
  // organ, and keeps `before.settings`.
  OpenOrganDialog(const std::string& file, const OrganSource& before, QWidget* parent = nullptr);

  // The user's choices; valid after accept(). For a label image, the choices include the structures
  // in the organ. Throws Error if the image can no longer be read.
  OrganSource source() const;

  QPoint openButton() const;        // centre of the Open button, in screen coordinates
  const PartsTable* roles() const;  // null if the user cannot give roles to parts of the file

  // Called after the file, or the chosen part, was examined. Gets the text that the dialog shows
  // about the file: a report or an error.
  std::function<void(const std::string&)> examined;
  // Called when the dialog begins to show the turning surface of the file or of the chosen part.
  std::function<void()> surfaceShown;

 private:
  bool show(const std::string& json, const std::string& problem);
  void tell(const QString& text);
  void unitChanged();
  void propose(double spacing);  // m
  double cavityVolume() const;
  void tellParticles();
  void examine();
  int likelyUnit() const;
  void listParts(const QJsonArray& parts);
  void listRoles(const QJsonObject& info);
  bool hasRoles() const;           // whether source() uses the table of roles
  std::string chosenPart() const;  // as OrganSource::part
  void showSlices();
  void readSurface();
  void showSurface();
  QHBoxLayout* turnRow();
  Eigen::Quaterniond lying() const;  // rotation from the file's axes to the room's axes

  std::string file_;
  bool isFolder_;  // of label images
  OrganSource before_;
  FileExaminer examiner_, surfaceReader_;
  QTemporaryDir folder_;                    // holds the picture of slices and the surface
  std::optional<std::string> surfacePart_;  // part whose surface is shown or being read
  SurfaceView* surface_;
  TriangleMesh mesh_;  // the surface that is shown, in the coordinates of the file
  QProgressBar* busy_;
  QLabel *report_, *slices_, *size_;
  QFormLayout* form_;
  QComboBox *unit_, *part_, *axes_;
  std::array<QSpinBox*, 3> turns_;  // degrees about the room's axes
  PartsTable* roles_;
  QCheckBox* repair_;
  QDoubleSpinBox* spacing_;
  QLabel* particles_;
  QPushButton* open_;
  double longest_ = 0;    // longest side of the bounding box, in units of the file
  double boxVolume_ = 0;  // volume of the bounding box, in units cubed
  // Area and volume of the surface, in units squared and units cubed. The volume is 0 if the
  // surface does not enclose a volume.
  double area_ = 0, volume_ = 0;
  // Volume of each part of a model, ml, computed as if the unit of the file were 1 m; 0: the part
  // is open.
  std::vector<double> partVolumes_;
  int cavities_ = 0;            // number of shells of the surface that bound cavities
  bool unitChosen_ = false;     // the user has chosen a unit
  bool spacingChosen_ = false;  // the user has chosen a spacing
  bool isImage_ = false;        // the file is a label image
};

}  // namespace resect
