#include "app/widgets/panels.h"

#include <fmt/format.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/language/words.h"
#include "app/say.h"
#include "sph/colour_field.h"

namespace resect {
namespace {

constexpr double kForceSeconds = 10;  // that the force's plot shows
constexpr int kLineGap = 5;           // pixels
constexpr double kSlowPicture = 0.04,
                 kFewPictures = 5;  // s; pictures in a second: too few to judge

// "findContacts" as "find contacts".
QString inWords(const std::string& name) {
  QString words;
  for (const QChar c : QString::fromStdString(name))
    words += c.isUpper() ? QString(' ') + c.toLower() : QString(c);
  return words;
}

// Draws a line; the plot's axes run from `first` to `last` s and from 0 to `most`.
void drawHistory(QPainter& painter, const QRectF& plot, const History& history, double first,
                 double last, double most, const QColor& axis, const QColor& line) {
  painter.setPen(axis);
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  if (history.size() < 2 || plot.height() < 8) return;
  QPainterPath path;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const QPointF p(plot.left() + plot.width() * (history[i].first - first) / (last - first),
                    plot.bottom() - plot.height() * history[i].second / most);
    i == 0 ? path.moveTo(p) : path.lineTo(p);
  }
  painter.setPen(QPen(line, 2));
  painter.drawPath(path);
}

// "1 piece of 108.2 ml, cut 41.3 cm2, bared 5.2 cm2": what an operation has done besides removing.
QString partsOf(const Ledger& ledger) {
  const std::int64_t pieces = ledger.pieces();
  const double cut = ledger.cut();
  const TissueSplit all = ledger.tissue();
  QStringList parts;
  if (pieces > 0)
    parts << (pieces == 1 ? Words::tr("%1 piece of %2 ml") : Words::tr("%1 pieces of %2 ml"))
                 .arg(pieces)
                 .arg(all.pieces.volume * 1e6, 0, 'f', 1);
  if (all.debris.particles > 0)
    parts << Words::tr("debris %1 ml").arg(all.debris.volume * 1e6, 0, 'f', 1);
  if (cut > 0) parts << Words::tr("cut %1 cm\u00b2").arg(cut * 1e4, 0, 'f', 1);
  if (const double bared = ledger.bared(); bared > 0)
    parts << Words::tr("bared %1 cm\u00b2").arg(bared * 1e4, 0, 'f', 1);
  for (const OrganLedger& organ : ledger.organs)
    for (const LabelLedger& label : organ.labels)
      if (label.margin && std::isfinite(*label.margin))
        parts << Words::tr("margin of %1 %2 mm")
                     .arg(translated(label.name))
                     .arg(*label.margin * 1e3, 0, 'f', 1);
  return parts.join(", ");
}

QString nameOf(const OrganSource& organ) {
  if (isBuiltIn(organ)) return Words::tr("Built-in %1").arg(translated(organ.file));
  return shown(std::filesystem::path(organ.file).filename().string());
}

}  // namespace

QString namesOf(const std::vector<ScenarioOrgan>& organs) {
  if (organs.size() == 1) return nameOf(organs[0].source);
  QStringList names;
  for (const ScenarioOrgan& organ : organs) names << translated(organ.source.name);
  return names.join(", ");
}

OrganPanel::OrganPanel(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  name_ = new QLabel(this);
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  form->addRow(name_);
  counts_ = new QLabel(this);
  counts_->setToolTip(
      Words::tr("Particles, triangles of the surface, and the volume that is left"));
  form->addRow(counts_);

  iso_ = new QSlider(Qt::Horizontal, this);
  iso_->setRange(int(kMinIso), int(kMaxIso));
  iso_->setToolTip(
      Words::tr("Colour value at which the surface is drawn: lower swells it, higher shrinks it"));
  iso_->setFocusPolicy(Qt::TabFocus);
  isoText_ = new QLabel(this);
  form->addRow(isoText_, iso_);
  QObject::connect(iso_, &QSlider::valueChanged, this, [this](int value) {
    isoText_->setText(Words::tr("Iso %1").arg(value));
    if (isoChanged) isoChanged(float(value));
  });

  spacing_ = new QDoubleSpinBox(this);
  spacing_->setRange(1, 30);
  spacing_->setDecimals(1);
  spacing_->setSuffix(" mm");
  spacing_->setToolTip(
      Words::tr("Side of the cells: smaller shows and cuts finer, and costs more"));
  spacing_->setAccessibleName(Words::tr("Spacing"));
  form->addRow(Words::tr("Spacing"), spacing_);
  refine_ = new QSpinBox(this);
  refine_->setRange(1, 4);
  refine_->setToolTip(Words::tr("Nodes of the surface's grid per cell: 2 shows the skin well"));
  refine_->setAccessibleName(Words::tr("Refinement"));
  form->addRow(Words::tr("Refinement"), refine_);
  elastic_ = new QCheckBox(Words::tr("Elastic tissue"), this);
  elastic_->setToolTip(Words::tr(
      "Tissue gives way, is pulled and opens; without it, it stands still and what is touched "
      "goes"));
  elastic_->setFocusPolicy(Qt::TabFocus);
  form->addRow(elastic_);
  again_ = new QPushButton(this);
  again_->setToolTip(
      Words::tr("The organ whole again, with this spacing, refinement and kind of tissue"));
  again_->setFocusPolicy(Qt::TabFocus);
  form->addRow(again_);
  QObject::connect(again_, &QPushButton::clicked, this, [this] { beginAgain(); });
  QObject::connect(spacing_, &QDoubleSpinBox::valueChanged, this, [this] { sayWhatWaits(); });
  QObject::connect(refine_, &QSpinBox::valueChanged, this, [this] { sayWhatWaits(); });
  QObject::connect(elastic_, &QCheckBox::toggled, this, [this] { sayWhatWaits(); });
  notes_ = new QLabel(this);
  notes_->setTextFormat(Qt::PlainText);
  notes_->setWordWrap(true);
  form->addRow(notes_);
}

OrganPanel::Settings OrganPanel::settings() const {
  return {spacing_->value(), refine_->value(), elastic_->isChecked()};
}

// Settings apply only when the organ is rebuilt: the button shows that changes are pending.
void OrganPanel::sayWhatWaits() {
  again_->setText(waiting() ? Words::tr("Begin again to apply") : Words::tr("Begin again"));
  again_->setStyleSheet(waiting() ? "font-weight: bold" : "");
}

void OrganPanel::beginAgain() {
  const Settings wanted = settings();
  std::optional<double> spacing;  // the display is rounded: set only if the user changed it
  if (wanted.spacing != running_.spacing) spacing = wanted.spacing * 1e-3;
  if (rebuild) rebuild(spacing, wanted.refine, wanted.elastic);
}

void OrganPanel::setOrgans(const std::vector<ScenarioOrgan>& organs, double spacing,
                           const QString& notes) {
  const QString name = namesOf(organs);
  name_->setText("<b>" + name.toHtmlEscaped() + "</b>");
  name_->setToolTip("<p>" + Words::tr("What is operated on: %1").arg(name.toHtmlEscaped()) +
                    "</p>");
  const QSignalBlocker quiet(spacing_);
  spacing_->setValue(spacing * 1e3);
  refine_->setValue(organs[0].source.settings.refine);
  elastic_->setChecked(organs[0].tissue.elastic);
  running_ = settings();
  sayWhatWaits();
  notes_->setText(notes);
  notes_->setVisible(!notes.isEmpty());
}

void OrganPanel::follow(const LiveState& state) {
  counts_->setText(Words::tr("%L1 particles\n%L2 triangles\n%3 ml")
                       .arg(state.particles)
                       .arg(state.triangles)
                       .arg(state.volume * 1e6, 0, 'f', 1));
}

void OrganPanel::setIso(float iso) {
  const QSignalBlocker quiet(iso_);
  iso_->setValue(int(std::lround(iso)));
  isoText_->setText(Words::tr("Iso %1").arg(int(std::lround(iso))));
}

RemovedPanel::RemovedPanel(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(80);
  setToolTip(Words::tr("Tissue taken out since the organ was whole, and how it came about"));
}

void RemovedPanel::clear() {
  history_.clear();
  removed_ = 0;
  particles_ = 0;
  update();
}

void RemovedPanel::follow(const LiveState& state) {
  removed_ = state.removedVolume;
  whole_ = state.removedVolume + state.volume;
  particles_ = state.removed;
  parts_ = state.ledger ? partsOf(*state.ledger) : QString();
  if (state.bleeds)
    parts_.prepend(Words::tr("Blood lost %1 ml, now %2 ml/min%3")
                       .arg(state.bled * 1e6, 0, 'f', 1)
                       .arg(state.bleedingRate * 60e6, 0, 'f', 0)
                       .arg(parts_.isEmpty() ? "" : "; "));
  // While an earlier moment is shown nothing is done; a stroke that was taken back has not
  // happened.
  if (state.showing) return update();
  std::erase_if(history_, [&](const auto& p) { return p.first > state.time; });
  if (history_.empty() || history_.back().second != removed_ * 1e6 ||
      state.time - history_.back().first > 1)
    history_.emplace_back(state.time, removed_ * 1e6);
  if (history_.size() > 2000) {
    // Drops every other point.
    History fewer;
    for (std::size_t i = 0; i < history_.size(); i += 2) fewer.push_back(history_[i]);
    history_ = std::move(fewer);
  }
  update();
}

void RemovedPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont large = font();
  large.setPointSizeF(1.9 * font().pointSizeF());
  large.setBold(true);
  painter.setFont(large);
  painter.setPen(palette().color(QPalette::WindowText));
  const int line = QFontMetrics(large).height();
  painter.drawText(QRect(8, 2, width() - 16, line), Qt::AlignLeft,
                   QString("%1 ml").arg(removed_ * 1e6, 0, 'f', 1));
  painter.setFont(font());
  const QString detail =
      (particles_ == 1 ? Words::tr("%L1 particle, %2 %") : Words::tr("%L1 particles, %2 %"))
          .arg(particles_)
          .arg(whole_ > 0 ? 100 * removed_ / whole_ : 0, 0, 'f', 2);
  painter.drawText(QRect(8, 2 + line, width() - 16, QFontMetrics(font()).height()), Qt::AlignLeft,
                   detail);
  int top = line + QFontMetrics(font()).height() + 8;
  if (!parts_.isEmpty()) {
    const QRect room(8, top - 4, width() - 16, 3 * QFontMetrics(font()).height());
    painter.drawText(room, Qt::AlignLeft | Qt::TextWordWrap, parts_);
    top += painter.boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, parts_).height();
  }
  const QRectF plot(8, top, width() - 16, height() - top - 6);
  const double first = history_.empty() ? 0 : history_.front().first;
  const double last = history_.empty() ? 1 : std::max(history_.back().first, first + 1);
  const double most = std::max(1.0, history_.empty() ? 0 : history_.back().second);
  drawHistory(painter, plot, history_, first, last, most, palette().color(QPalette::Mid),
              QColor(200, 70, 60));
}

ForcePanel::ForcePanel(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(70);
  setToolTip(Words::tr(
      "What the hand would feel, over the last ten seconds; the most so far, and the instrument "
      "that met it"));
}

void ForcePanel::begin(const std::vector<QString>& tools) {
  tools_ = tools;
  history_.clear();
}

void ForcePanel::follow(const LiveState& state, int held) {
  const bool felt = held >= 0 && std::size_t(held) < state.forces.size();
  if (!history_.empty() && state.time < history_.back().first) history_.clear();
  const auto most = std::ranges::max_element(state.peakForces);
  peak_ = most == state.peakForces.end() ? 0 : *most;
  const auto tool = std::size_t(most - state.peakForces.begin());
  reached_ = peak_ > 0 && tool < tools_.size() ? tools_[tool] : QString();
  history_.emplace_back(state.time, felt ? state.forces[std::size_t(held)] : 0);
  std::erase_if(history_, [&](const auto& p) { return p.first < state.time - kForceSeconds; });
  update();
}

void ForcePanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = QFontMetrics(font()).height();
  double most = 1;
  for (const auto& [time, force] : history_) most = std::max(most, force);
  const double now = history_.empty() ? 0 : history_.back().second;
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRect(8, 2, width() - 16, line), Qt::AlignLeft,
                   QString("%1 N").arg(now, 0, 'f', 2));
  QString peak = Words::tr("at most %1 N").arg(peak_, 0, 'f', 2);
  if (!reached_.isEmpty()) peak += ": " + reached_;
  painter.drawText(QRect(8, 2 + line, width() - 16, line), Qt::AlignLeft,
                   fontMetrics().elidedText(peak, Qt::ElideRight, width() - 16));
  const QRectF plot(8, 2 * line + 6, width() - 16, height() - 2 * line - 12);
  const double last = history_.empty() ? 0 : history_.back().first;
  drawHistory(painter, plot, history_, last - kForceSeconds, last, most,
              palette().color(QPalette::Mid), QColor(90, 180, 200));
}

TimingPanel::TimingPanel(QWidget* parent) : QWidget(parent) {
  setToolTip(Words::tr("Median time of each stage of a step over the last second"));
}

void TimingPanel::follow(const LiveState& state, const Viewer::Drawing& drawing, double frameRate) {
  state_ = state;
  drawing_ = drawing;
  frameRate_ = frameRate;
  const int lines = 3 + int(state.times.stages.size()) + 3;  // the last three: room for advice
  setMinimumHeight(lines * (fontMetrics().height() + kLineGap));
  update();
}

// Advice if simulation or drawing was slow during the last second.
QString TimingPanel::advice(const StageTime* slowest) const {
  if (state_.times.realTimeFactor < 0.9 && state_.times.median > 0.9 / frameRate_ && slowest)
    return Words::tr("Slower than real time: \"%1\" takes most. A larger spacing helps.")
        .arg(inWords(slowest->name));
  if (drawing_.perSecond >= kFewPictures && drawing_.seconds > kSlowPicture)
    return Words::tr("Drawing is slow here: a smaller window or a graphics card helps.");
  return {};
}

void TimingPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QFontMetrics metrics(font());
  const int row = metrics.height() + kLineGap;
  int y = 2;
  const auto text = [&](const QString& left, const QString& right) {
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect line(8, y, width() - 16, metrics.height());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, left);
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, right);
    y += row;
  };
  text(Words::tr("Pictures"), drawing_.perSecond > 0
                                  ? QString("%1 /s").arg(drawing_.perSecond, 0, 'f', 0)
                                  : Words::tr("at rest"));
  text(Words::tr("Real time"), QString("%1 x").arg(state_.times.realTimeFactor, 0, 'f', 2));
  text(Words::tr("Step"), QString("%1 ms").arg(state_.times.median * 1e3, 0, 'f', 2));
  double most = 1e-4;
  const StageTime* slowest = nullptr;
  for (const StageTime& stage : state_.times.stages)
    if (stage.median >= most) most = stage.median, slowest = &stage;
  const QString said = advice(slowest);
  if (!said.isEmpty()) {  // above the stages, which may not all fit
    const QRect room(8, y, width() - 16, 4 * row);
    painter.setPen(QColor(220, 150, 60));
    painter.drawText(room, Qt::AlignLeft | Qt::TextWordWrap, said);
    y += metrics.boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, said).height() + 4;
  }
  for (const StageTime& stage : state_.times.stages) {
    const int bar = int((width() - 16) * std::min(1.0, stage.median / most));
    painter.fillRect(QRect(8, y + metrics.height(), std::max(1, bar), 3), QColor(70, 140, 160));
    text(inWords(stage.name), QString("%1 ms").arg(stage.median * 1e3, 0, 'f', 3));
  }
}

}  // namespace resect
