#include "app/widgets/open_organ_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/language/words.h"
#include "app/loading/organ_report.h"
#include "app/say.h"
#include "app/widgets/parts_table.h"
#include "app/widgets/surface_view.h"
#include "base/error.h"
#include "formats/labels/brought_organ.h"
#include "inventor/scene/scene_file.h"
#include "io/organ_size.h"
#include "io/plain_mesh.h"
#include "io/scenario/length.h"
#include "io/scenario/orientation.h"

namespace resect {

OpenOrganDialog::OpenOrganDialog(const std::string& file, const OrganSource& before,
                                 QWidget* parent)
    : QDialog(parent),
      file_(file),
      isFolder_(std::filesystem::is_directory(file)),
      before_(before) {
  setWindowTitle(Words::tr("Open organ"));
  auto* columns = new QHBoxLayout(this);
  auto* form = form_ = new QFormLayout;
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addStretch();
  columns->addLayout(left, 1);
  auto* pictures = new QVBoxLayout;
  columns->addLayout(pictures);
  surface_ = new SurfaceView;
  pictures->addWidget(surface_, 0, Qt::AlignHCenter);
  form->addRow(
      new QLabel("<b>" + shownInHtml(std::filesystem::path(file).filename().string()) + "</b>"));
  report_ = new QLabel(Words::tr("Reading ..."));
  report_->setTextFormat(Qt::PlainText);
  report_->setWordWrap(true);
  report_->setMinimumWidth(440);
  form->addRow(report_);
  slices_ = new QLabel;
  slices_->setToolTip(Words::tr(
      "From below, from the front and from the left; the patient's right is on the left"));
  slices_->setAlignment(Qt::AlignCenter);
  slices_->hide();
  pictures->addWidget(slices_);
  pictures->addStretch();
  busy_ = new QProgressBar;
  busy_->setRange(0, 0);
  busy_->setTextVisible(false);
  busy_->setFixedHeight(6);
  form->addRow(busy_);
  unit_ = new QComboBox;
  const std::pair<const char*, double> units[] = {
      {QT_TRANSLATE_NOOP("window", "metre"), 1},
      {QT_TRANSLATE_NOOP("window", "centimetre"), 0.01},
      {QT_TRANSLATE_NOOP("window", "millimetre"), 0.001},
      {QT_TRANSLATE_NOOP("window", "micrometre"), 1e-6},
      {QT_TRANSLATE_NOOP("window", "inch"), 0.0254}};
  for (const auto& [name, metres] : units) unit_->addItem(Words::tr(name), metres);
  size_ = new QLabel;
  unit_->setToolTip(
      Words::tr("What the file's numbers count; the guess is the one that gives an organ's size"));
  size_->setToolTip(Words::tr("Of what is opened, in that unit"));
  form->addRow(Words::tr("One unit of the file is a"), unit_);
  form->addRow(Words::tr("Size"), size_);
  part_ = new QComboBox;
  part_->addItem(Words::tr("all parts together"), QString());
  part_->setToolTip(Words::tr("One named part of the file, or all of them as one body"));
  form->addRow(Words::tr("Part"), part_);
  roles_ = new PartsTable;
  roles_->changed = [this] { examine(); };
  form->addRow(roles_);
  form->setRowVisible(roles_, false);
  repair_ = new QCheckBox(Words::tr("Close holes"));
  repair_->setToolTip(Words::tr("An open surface has no inside; its holes can be closed"));
  form->addRow(repair_);
  spacing_ = new QDoubleSpinBox;
  spacing_->setRange(1, 30);
  spacing_->setDecimals(1);
  spacing_->setSuffix(" mm");
  spacing_->setValue(before.spacing.value_or(0.005) * 1e3);
  spacing_->setToolTip(
      Words::tr("Side of the cells: smaller shows and cuts finer, and costs more"));
  connect(spacing_, &QDoubleSpinBox::valueChanged, this, [this] {
    spacingChosen_ = true;
    tellParticles();
  });
  particles_ = new QLabel;
  particles_->setToolTip(
      Words::tr("Particles that the organ will have; more of them cost more time"));
  auto* cells = new QHBoxLayout;
  cells->addWidget(spacing_, 1);
  cells->addWidget(particles_, 1);
  form->addRow(Words::tr("Spacing"), cells);
  axes_ = new QComboBox;
  axes_->addItem(Words::tr("x left, y front, z feet: as the room"), "");
  axes_->addItem(Words::tr("x left, y back, z head: LPS, as DICOM"), "LPS");
  axes_->addItem(Words::tr("x right, y front, z head: RAS, as 3D Slicer"), "RAS");
  axes_->addItem(Words::tr("x left, y head, z front: as glTF"), "LSA");
  axes_->setToolTip(Words::tr("Where the file's axes point in the patient, who lies on the back"));
  connect(axes_, &QComboBox::currentIndexChanged, this, [this] { showSurface(); });
  form->addRow(Words::tr("Axes of the file"), axes_);
  form->addRow(Words::tr("Turn about X, Y, Z"), turnRow());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  open_ = buttons->button(QDialogButtonBox::Open);
  open_->setEnabled(false);
  open_->setToolTip(
      Words::tr("Makes the organ; what is operated on now is replaced when it is ready"));
  buttons->button(QDialogButtonBox::Cancel)->setToolTip(Words::tr("Nothing changes"));
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, [this] {
    examiner_.cancel();
    surfaceReader_.cancel();
    reject();
  });
  connect(unit_, &QComboBox::currentIndexChanged, this, [this] { unitChanged(); });
  connect(unit_, &QComboBox::activated, this, [this] { unitChosen_ = true; });
  connect(part_, &QComboBox::activated, this, [this] {
    form_->setRowVisible(roles_, hasRoles());
    examine();
  });
  examine();
}

// Examines the file or its chosen part.
void OpenOrganDialog::examine() {
  open_->setEnabled(false);
  busy_->setRange(0, 0);
  const bool image = isLabelled(file_) && slices_->isHidden();
  const QString picture = image && folder_.isValid() ? folder_.filePath("slices.png") : "";
  examiner_.examine(file_, chosenPart(), picture.toStdString(),
                    [this](const std::string& json, const std::string& problem) {
                      // A finished process must not be replaced from its own signal.
                      if (!show(json, problem))
                        return QTimer::singleShot(0, this, [this] { examine(); });
                      busy_->setRange(0, 1);
                      if (problem.empty()) readSurface();
                      if (examined) examined(report_->text().toStdString());
                    });
}

// The surface of what is opened, for its picture.
void OpenOrganDialog::readSurface() {
  const std::string part = chosenPart();
  if (surfacePart_ == part || !folder_.isValid() || (hasRoles() && !roles_->hasOrgan())) return;
  surfacePart_ = part;
  busy_->setRange(0, 0);
  const std::string ply = folder_.filePath("surface.ply").toStdString();
  const bool ofFolder = isFolder_ && roles_->filled();
  surfaceReader_.writeSurface(ofFolder ? roles_->organ().file : file_, ofFolder ? "" : part, ply,
                              [this, ply](const std::string& problem) {
                                busy_->setRange(0, 1);
                                if (!problem.empty()) return;
                                mesh_ = merged(readPlainMesh(ply));
                                showSurface();
                                if (surfaceShown && surface_->pictures() > 0) surfaceShown();
                              });
}

// Without OpenGL there is no picture, and the organ can be opened all the same.
void OpenOrganDialog::showSurface() {
  if (mesh_.triangles.empty()) return;
  try {
    surface_->setSurface(transformed(mesh_, {Vec3::Zero(), lying()}));
  } catch (const Error&) {
  }
}

QHBoxLayout* OpenOrganDialog::turnRow() {
  auto* row = new QHBoxLayout;
  const QString axes[] = {Words::tr("the patient's left"), Words::tr("up"),
                          Words::tr("the patient's feet")};
  for (int a = 0; a < 3; ++a) {
    QSpinBox* turn = turns_[std::size_t(a)] = new QSpinBox;
    turn->setRange(-180, 180);
    turn->setSingleStep(90);
    turn->setSuffix("\u00b0");
    turn->setToolTip(Words::tr("Turns the organ about the axis that points to %1").arg(axes[a]));
    connect(turn, &QSpinBox::valueChanged, this, [this] { showSurface(); });
    row->addWidget(turn);
  }
  return row;
}

Eigen::Quaterniond OpenOrganDialog::lying() const {
  const std::string letters = isImage_ ? "LPS" : axes_->currentData().toString().toStdString();
  const auto own = letters.empty() ? Eigen::Quaterniond::Identity() : orientationOf(letters);
  const QString turn =
      QString("%1,%2,%3").arg(turns_[0]->value()).arg(turns_[1]->value()).arg(turns_[2]->value());
  return (turnOf(turn.toStdString()) * own).normalized();
}

// Shows text and enlarges the dialog for it.
void OpenOrganDialog::tell(const QString& text) {
  report_->setText(text);
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
  // A dialog that grows must not lead its buttons out of the screen.
  const QRect all = screen()->availableGeometry();
  if (const int over = frameGeometry().bottom() - all.bottom(); over > 0)
    move(x(), std::max(all.top(), y() - over));
}

void OpenOrganDialog::unitChanged() {
  const double metres = unit_->currentData().toDouble();
  const double cavities = cavityVolume();
  size_->setText(sizeText(longest_ * metres, area_ * metres * metres, volume_ * std::pow(metres, 3),
                          cavities > 0));
  // An open surface will enclose about what an ellipsoid in its box does.
  const double about = (volume_ > 0 ? volume_ : std::numbers::pi / 6 * boxVolume_) - cavities;
  if (!spacingChosen_ && about > 0)
    propose(proposedSpacing(before_.spacing.value_or(0.005), about * std::pow(metres, 3),
                            metres * wallThickness(volume_, area_, cavities, cavities_ > 0)));
  // An open part has none.
  for (std::size_t i = 0; roles_->filled() && i < partVolumes_.size(); ++i)
    if (partVolumes_[i] > 0)
      roles_->setAbout(int(i),
                       QString("%1 ml").arg(partVolumes_[i] * std::pow(metres, 3), 0, 'g', 4));
  tellParticles();
}

void OpenOrganDialog::tellParticles() {
  const double cells = std::pow(unit_->currentData().toDouble() / (1e-3 * spacing_->value()), 3);
  particles_->setText(particlesText(cells * (volume_ - cavityVolume())));
}

void OpenOrganDialog::propose(double spacing) {
  const QSignalBlocker quiet(spacing_);
  spacing_->setValue(0.1 * std::floor(1e4 * spacing));
}

// The volume of the parts that are cavities, in units cubed.
double OpenOrganDialog::cavityVolume() const {
  double volume = 0;
  for (std::size_t i = 0; hasRoles() && i < partVolumes_.size(); ++i)
    if (roles_->isCavity(int(i))) volume += 1e-6 * partVolumes_[i];
  return volume;
}

// False if the result changes the choice of part, so that another examination follows.
bool OpenOrganDialog::show(const std::string& json, const std::string& problem) {
  if (!problem.empty()) {
    for (int row = 2; longest_ == 0 && row + 1 < form_->rowCount(); ++row)
      form_->setRowVisible(row, false);  // there is nothing to choose
    tell(translated(problem, kLongestSentence));
    return true;
  }
  const QJsonObject info = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
  if (info.isEmpty()) {
    tell(Words::tr("the report cannot be read"));
    return true;
  }
  isImage_ = info.contains("labels");
  if (isImage_) showSlices();
  if (!roles_->filled()) listRoles(info);
  if (isImage_ && !info.contains("closed")) {  // no organ was found in it
    tell(hasRoles() ? organQuestion(isFolder_)
                    : translated(info["refusal"].toString(), kLongestSentence));
    return true;
  }
  if (isFolder_ && hasRoles())
    tell(Words::tr("%1 label images").arg(info["files"].toArray().size()));
  else
    tell(isImage_ ? imageReport(info) : surfaceReport(info, hasRoles()));
  repair_->setChecked(!info["closed"].toBool());
  const QJsonArray bounds = info["bounds_m"].toArray();
  area_ = info["area_m2"].toDouble();
  volume_ = info["organ_ml"].toDouble() * 1e-6;  // 0 if it is refused
  cavities_ = info["cavities"].toInt();
  longest_ = 0, boxVolume_ = 1;
  for (int a = 0; a < 3; ++a) {
    const double side = bounds[1].toArray()[a].toDouble() - bounds[0].toArray()[a].toDouble();
    longest_ = std::max(longest_, side);
    boxVolume_ *= side;
  }
  if (!isImage_ && part_->count() == 1) {
    listParts(info["parts"].toArray());
    form_->setRowVisible(roles_, hasRoles());
    if (!chosenPart().empty()) return false;
  }
  // In a scene that was saved from here the organ is in metres, and a .3mf tells its unit.
  const bool toldByFile = isImage_ || info["format"].toString() == "3MF";
  if (toldByFile && unit_->isEnabled()) {
    unit_->setEnabled(false);
    unit_->insertItem(0, Words::tr("metre, converted from the file's own unit"), 1.0);
  }
  if (toldByFile || part_->currentData().toString() == kOrganNode)
    unit_->setCurrentIndex(0);
  else if (!unitChosen_)
    unit_->setCurrentIndex(likelyUnit());
  unitChanged();
  open_->setEnabled(!hasRoles() || roles_->hasOrgan());
  if (!part_->hasFocus()) open_->setFocus();
  open_->setDefault(true);
  return true;
}

void OpenOrganDialog::showSlices() {
  const QPixmap picture(folder_.filePath("slices.png"));
  if (picture.isNull() || !slices_->isHidden()) return;
  constexpr int kWidth = 450;
  slices_->setPixmap(picture.scaledToWidth(kWidth, Qt::SmoothTransformation));
  slices_->show();
}

// A table of the parts, labels or images that the file holds, if there are several.
void OpenOrganDialog::listRoles(const QJsonObject& info) {
  const std::vector<FilePart> parts = fileParts(info);
  partVolumes_.clear();
  if (isImage_) {  // whose surfaces are closed
    form_->setRowVisible(axes_, false);
    repair_->setEnabled(false);
    form_->setRowVisible(part_, false);
  } else {
    for (const QJsonValue part : info["part_health"].toArray())
      partVolumes_.push_back(part["volume_ml"].toDouble());
  }
  if (parts.size() < 2) return;
  roles_->fill(parts, isImage_);
  part_->setItemText(0, Words::tr("by their roles"));
  form_->setRowVisible(roles_, hasRoles());
}

bool OpenOrganDialog::hasRoles() const {
  return roles_->filled() && part_->currentData().toString().isEmpty();
}

std::string OpenOrganDialog::chosenPart() const {
  if (!hasRoles()) return part_->currentData().toString().toStdString();
  if (isFolder_) return roles_->hasOrgan() ? roles_->organ().part : "";
  OrganSource source;
  source.file = file_;
  roles_->applyTo(source);
  return source.part;
}

// The one that the commands would name (io/organ_size.h).
int OpenOrganDialog::likelyUnit() const {
  const std::string unit = plausibleUnit({Vec3::Zero(), Vec3::Constant(longest_)});
  const int at = unit.empty() ? -1 : unit_->findData(parseUnit(unit, "unit"));
  return std::max(at, 0);
}

// Chooses the organ of a saved scene, which is known by its name.
void OpenOrganDialog::listParts(const QJsonArray& parts) {
  if (parts.size() < 2) return;
  for (const QJsonValue part : parts) {
    const QString name = part.isString() ? part.toString() : part["name"].toString();
    part_->addItem(shown(name.toStdString()), name);
    if (name == kOrganNode) part_->setCurrentIndex(part_->count() - 1);
  }
}

QPoint OpenOrganDialog::openButton() const { return open_->mapToGlobal(open_->rect().center()); }
const PartsTable* OpenOrganDialog::roles() const { return hasRoles() ? roles_ : nullptr; }

OrganSource OpenOrganDialog::source() const {
  OrganSource source;
  source.file = file_;
  source.unit = unit_->currentData().toDouble();
  if (hasRoles())
    roles_->applyTo(source);
  else
    source.part = part_->currentData().toString().toStdString();
  source.repair = repair_->isChecked();
  source.spacing = spacing_->value() * 1e-3;
  source.settings = before_.settings;
  if (isImage_) takeLabels(source);
  source.pose.rotation = lying();
  return source;
}

}  // namespace resect
