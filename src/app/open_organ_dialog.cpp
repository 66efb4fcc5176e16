#include "app/open_organ_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "inventor/scene_file.h"

namespace resect {

OpenOrganDialog::OpenOrganDialog(const std::string& file, const OrganSource& before,
                                 QWidget* parent)
    : QDialog(parent), file_(file), before_(before) {
  setWindowTitle("Open organ");
  setMinimumWidth(460);
  auto* form = new QFormLayout(this);
  form->addRow(new QLabel(
      "<b>" + QFileInfo(QString::fromStdString(file)).fileName().toHtmlEscaped() + "</b>"));
  report_ = new QLabel("Reading ...");
  report_->setWordWrap(true);
  form->addRow(report_);
  unit_ = new QComboBox;
  const std::pair<const char*, double> units[] = {{"metre", 1},
                                                  {"centimetre", 0.01},
                                                  {"millimetre", 0.001},
                                                  {"micrometre", 1e-6},
                                                  {"inch", 0.0254}};
  for (const auto& [name, metres] : units) unit_->addItem(name, metres);
  size_ = new QLabel;
  form->addRow("One unit of the file is a", unit_);
  form->addRow("Longest side", size_);
  part_ = new QComboBox;
  part_->addItem("all parts together", QString());
  form->addRow("Part", part_);
  repair_ = new QCheckBox("Close holes");
  repair_->setToolTip("An open surface has no inside; its holes can be closed");
  form->addRow(repair_);
  spacing_ = new QDoubleSpinBox;
  spacing_->setRange(1, 30);
  spacing_->setDecimals(1);
  spacing_->setSuffix(" mm");
  spacing_->setValue(before.spacing.value_or(0.005) * 1e3);
  form->addRow("Spacing", spacing_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  open_ = buttons->button(QDialogButtonBox::Open);
  open_->setEnabled(false);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, [this] {
    examiner_.cancel();
    reject();
  });
  connect(unit_, &QComboBox::currentIndexChanged, this, [this] { unitChanged(); });
  examiner_.examine(file, [this](const std::string& json, const std::string& problem) {
    show(json, problem);
    if (examined) examined(report_->text().toStdString());
  });
}

// The dialog grows with what there is to read.
void OpenOrganDialog::tell(const QString& text) {
  report_->setText(text);
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

void OpenOrganDialog::unitChanged() {
  size_->setText(QString("%1 mm").arg(longest_ * unit_->currentData().toDouble() * 1e3, 0, 'g', 4));
}

void OpenOrganDialog::show(const std::string& json, const std::string& problem) {
  if (!problem.empty()) {
    return tell(QString::fromStdString(problem));
  }
  const QJsonObject info = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
  if (info.isEmpty()) return tell("the report cannot be read");
  const bool closed = info["closed"].toBool();
  QString text =
      QString("%L1 triangles, %2 components, %3")
          .arg(info["triangles"].toInt())
          .arg(info["components"].toInt())
          .arg(closed ? "closed"
                      : QString("open: %1 boundary edges").arg(info["boundary_edges"].toInt()));
  if (info["inside_out"].toBool()) text += ", inside out (will be turned)";
  tell(text);
  repair_->setChecked(!closed);
  const QJsonArray bounds = info["bounds_m"].toArray();
  for (int a = 0; a < 3; ++a)
    longest_ =
        std::max(longest_, bounds[1].toArray()[a].toDouble() - bounds[0].toArray()[a].toDouble());
  // A liver is 0.15 to 0.30 m long: the unit that comes nearest.
  int best = 0;
  for (int i = 0; i < unit_->count(); ++i) {
    const auto off = [&](int k) {
      return std::abs(std::log(std::max(1e-12, longest_ * unit_->itemData(k).toDouble()) / 0.22));
    };
    if (off(i) < off(best)) best = i;
  }
  unit_->setCurrentIndex(best);
  unitChanged();
  const QJsonArray parts = info["parts"].toArray();
  if (parts.size() > 1)
    for (const QJsonValue part : parts) {
      const QString name = part.isString() ? part.toString() : part["name"].toString();
      part_->addItem(name, name);
      // In a scene that was saved from here the organ is known by its name.
      if (name == kOrganNode) {
        part_->setCurrentIndex(part_->count() - 1);
        unit_->setCurrentIndex(0);
      }
    }
  open_->setEnabled(true);
  open_->setFocus();
  open_->setDefault(true);
}

QPoint OpenOrganDialog::openButton() const { return open_->mapToGlobal(open_->rect().center()); }

OrganSource OpenOrganDialog::source() const {
  OrganSource source;
  source.file = file_;
  source.part = part_->currentData().toString().toStdString();
  source.unit = unit_->currentData().toDouble();
  source.repair = repair_->isChecked();
  source.spacing = spacing_->value() * 1e-3;
  source.settings = before_.settings;
  return source;
}

}  // namespace resect
