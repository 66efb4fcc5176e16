#include "app/widgets/operation_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "app/language/words.h"
#include "app/say.h"
#include "app/widgets/timeline_panel.h"
#include "blood/flow/circulation.h"

namespace resect {
namespace {

QString millilitres(double volume) { return QString("%1 ml").arg(volume * 1e6, 0, 'f', 1); }

// The narrowest margin of a labelled structure: "4.2 mm, tumour".
QString narrowestMargin(const Ledger& ledger) {
  const LabelLedger* nearest = nullptr;
  for (const OrganLedger& organ : ledger.organs)
    for (const LabelLedger& label : organ.labels)
      if (label.margin && std::isfinite(*label.margin) &&
          (!nearest || *label.margin < *nearest->margin))
        nearest = &label;
  if (!nearest) return {};
  return QString("%1 mm, %2").arg(*nearest->margin * 1e3, 0, 'f', 1).arg(translated(nearest->name));
}

QString bloodText(double bled) {
  const long share = std::lround(100 * bled / Circulation{}.volume);
  const QString volume =
      bled < 1e-4 ? millilitres(bled) : QString("%1 ml").arg(std::lround(bled * 1e6));
  return share < 1 ? volume : Words::tr("%1 (%2 %)").arg(volume).arg(share);
}

// The pieces, and the debris if there is enough of it to be told in tenths of a millilitre.
QString cutOffText(const Ledger& ledger) {
  constexpr double kLeastDebris = 0.05e-6;  // m^3
  const std::int64_t pieces = ledger.pieces();
  QString text;
  if (pieces > 0)
    text = (pieces == 1 ? Words::tr("%1 piece, %2") : Words::tr("%1 pieces, %2"))
               .arg(pieces)
               .arg(millilitres(ledger.tissue().pieces.volume));
  const double debris = ledger.tissue().debris.volume;
  if (debris < kLeastDebris) return text;
  const QString crumbs = Words::tr("%1 of debris").arg(millilitres(debris));
  return text.isEmpty() ? crumbs : text + "; " + crumbs;
}

}  // namespace

// The VIBe grade in words: its number says nothing to somebody who does not know the scale.
QString gradeText(double bleedingRate) {
  const int grade = bleedingGrade(bleedingRate);
  const QString name = grade == 0   ? Words::tr("none")
                       : grade == 1 ? Words::tr("mild")
                       : grade == 2 ? Words::tr("moderate")
                       : grade == 3 ? Words::tr("severe")
                                    : Words::tr("life-threatening");
  return grade == 0 ? name : Words::tr("%1 (%2 of 4)").arg(name).arg(grade);
}

OperationPanel::OperationPanel(QWidget* parent)
    : QWidget(parent), form_(new QFormLayout(this)), title_(new QLabel), task_(new QLabel) {
  form_->setVerticalSpacing(3);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (QLabel* label : {title_, task_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    form_->addRow(label);
  }
  title_->setAccessibleName(Words::tr("Title of the operation"));
  task_->setAccessibleName(Words::tr("Task"));
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  time_ = addRow(Words::tr("Time"), Words::tr("Since the operation began"));
  blood_ = addRow(
      Words::tr("Blood lost"),
      Words::tr("All blood that has left the vessels, and its share of all blood of the patient"));
  bleeding_ = addRow(Words::tr("Bleeding"), Words::tr("Blood that leaves the vessels at present"));
  grade_ = addRow(Words::tr("Severity"),
                  Words::tr("Grade of the present bleeding on the VIBe scale, by its rate"));
  air_ = addRow(Words::tr("Air drawn in"),
                Words::tr("Air that open hepatic veins have drawn in; 200 to 300 ml kill"));
  inflow_ = addRow(
      Words::tr("Inflow"),
      Words::tr(
          "Whether the clamp closes the inflow of the liver, and for how long it has in all"));
  clips_ = addRow(Words::tr("Clips"), Words::tr("Clips on vessels"));
  removed_ = addRow(Words::tr("Removed"), Words::tr("Tissue taken out"));
  pieces_ =
      addRow(Words::tr("Cut off"), Words::tr("Pieces that hang together with the organ no more"));
  cut_ = addRow(Words::tr("Cut area"), Words::tr("Area of all cuts"));
  margin_ = addRow(Words::tr("Margin"), Words::tr("Least distance of a structure from a cut"));
  force_ = addRow(Words::tr("Force"), Words::tr("What the hand feels on the instrument"));
  most_ = addRow(Words::tr("Largest force"),
                 Words::tr("The largest force so far, and the instrument that met it"));
}

OperationPanel::Row OperationPanel::addRow(const QString& name, const QString& tip) {
  const Row row{new QLabel(name, this), new QLabel(this)};
  row.name->setToolTip(tip);
  row.value->setToolTip(tip);
  row.value->setTextFormat(Qt::PlainText);
  row.value->setWordWrap(true);
  row.value->setAccessibleName(name);
  form_->addRow(row.name, row.value);
  set(row, {});
  return row;
}

void OperationPanel::set(const Row& row, const QString& value) {
  if (row.value->text() != value) row.value->setText(value);
  if (form_->isRowVisible(row.value) == value.isEmpty())
    form_->setRowVisible(row.value, !value.isEmpty());
}

void OperationPanel::begin(const Scenario& scenario, const QString& notes,
                           const std::vector<QString>& tools) {
  tools_ = tools;
  frameRate_ = scenario.frameRate;
  title_->setText(translated(scenario.title, kLongestSentence));
  title_->setVisible(!scenario.title.empty());
  task_->setText(scenario.description.empty() ? notes
                                              : translated(scenario.description, kLongestSentence));
  task_->setVisible(!task_->text().isEmpty());
}

void OperationPanel::follow(const LiveState& state, int held) {
  set(time_, clockText(double(state.moment.frame) / frameRate_));
  set(blood_, state.bleeds ? bloodText(state.bled) : QString());
  // At a moment that is shown, what oozes is not known, and so neither is the grade
  // (docs/window.md).
  // Grades 0 to 2 end at 1, 5 and 10 ml/min: with a decimal, number and grade agree.
  const double rate = state.bleedingRate * 60e6;
  set(bleeding_,
      state.bleeds ? (state.showing ? Words::tr("%1 ml/min from vessels") : Words::tr("%1 ml/min"))
                         .arg(rate, 0, 'f', rate > 0 && rate < 10 ? 1 : 0)
                   : QString());
  set(grade_, state.bleeds && !state.showing ? gradeText(state.bleedingRate) : QString());
  set(air_, state.air > 0 ? millilitres(state.air) : QString());
  set(inflow_, state.clampedTime > 0 ? (state.inflowClamped ? Words::tr("closed, %1 s")
                                                            : Words::tr("open (was closed %1 s)"))
                                           .arg(state.clampedTime, 0, 'f', 0)
                                     : QString());
  set(clips_, state.clips.empty() ? QString() : QString::number(state.clips.size()));
  set(removed_, millilitres(state.removedVolume));
  set(pieces_, state.ledger ? cutOffText(*state.ledger) : QString());
  const double cut = state.ledger ? state.ledger->cut() : 0;
  set(cut_, cut > 0 ? QString("%1 cm\u00b2").arg(cut * 1e4, 0, 'f', 1) : QString());
  set(margin_, state.ledger ? narrowestMargin(*state.ledger) : QString());
  const bool felt = held >= 0 && std::size_t(held) < state.forces.size();
  set(force_, state.moves
                  ? QString("%1 N").arg(felt ? state.forces[std::size_t(held)] : 0, 0, 'f', 2)
                  : QString());
  const auto most = std::ranges::max_element(state.peakForces);
  const bool met = state.moves && most != state.peakForces.end() && *most > 0;
  const auto tool = std::size_t(most - state.peakForces.begin());
  set(most_, met ? QString("%1 N").arg(*most, 0, 'f', 2) +
                       (tool < tools_.size() ? ", " + tools_[tool] : QString())
                 : QString());
}

}  // namespace resect
