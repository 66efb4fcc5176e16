#include "app/exercise/task_maker_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/language/words.h"
#include "app/say.h"
#include "skills/score/bands.h"

namespace resect {
namespace {

using Kind = TaskGoal::Kind;

struct KindWords {
  Kind kind;
  const char *words, *advice;
};
constexpr KindWords kKinds[] = {
    {Kind::Touch, QT_TRANSLATE_NOOP("window", "Touch targets"),
     QT_TRANSLATE_NOOP("window", "Click each target on the organ, in order.")},
    {Kind::Follow, QT_TRANSLATE_NOOP("window", "Cut along a line"),
     QT_TRANSLATE_NOOP("window", "Click the corners of the line, from one end to the other.")},
    {Kind::Resect, QT_TRANSLATE_NOOP("window", "Take out a structure"),
     QT_TRANSLATE_NOOP("window", "Click on the organ above the middle of the tumour.")},
    {Kind::StopBleeding, QT_TRANSLATE_NOOP("window", "Stop a bleeding"),
     QT_TRANSLATE_NOOP("window", "There is nothing to mark: the learner makes the cut.")},
    {Kind::Divide, QT_TRANSLATE_NOOP("window", "Divide a vessel"),
     QT_TRANSLATE_NOOP("window", "Click on the organ above the vessel.")},
    {Kind::Transect, QT_TRANSLATE_NOOP("window", "Cut along a plane"),
     QT_TRANSLATE_NOOP("window",
                       "Turn the view so that you look along the plane; then click two points that "
                       "it goes through.")},
};

constexpr const char* kNew = QT_TRANSLATE_NOOP("window", "a new tumour");

}  // namespace

QDoubleSpinBox* TaskMakerPanel::number(const QString& name, const QString& tip, double least,
                                       double most, double value, const char* unit, int digits) {
  auto* field = new QDoubleSpinBox(this);
  field->setRange(least, most);
  field->setDecimals(digits);
  field->setValue(value);
  field->setSuffix(QString(" ") + unit);
  field->setToolTip(tip);
  field->setAccessibleName(name);
  form_->addRow(name, field);
  return field;
}

// A row of three fields, for the levels.
TaskMakerPanel::Limit TaskMakerPanel::limit(const QString& name, const char* measure,
                                            const QString& tip, double most, const char* unit,
                                            int digits, std::array<double, 3> values) {
  Limit made{measure, {}, new QWidget(this)};
  made.row->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* row = new QHBoxLayout(made.row);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(3);
  for (const TaskLevel level : kTaskLevels) {
    auto* field = new QDoubleSpinBox(made.row);
    field->setRange(0, most);
    field->setDecimals(digits);
    field->setValue(values[std::size_t(level)]);
    field->setSpecialValueText(Words::tr("any"));
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setMinimumWidth(40);
    const QString word = translated(std::string(wordOf(level)));
    field->setToolTip(Words::tr("%1, at the level %2, in %3; 0: any").arg(tip, word, unit));
    field->setAccessibleName(QString("%1, %2").arg(name, word));
    row->addWidget(field);
    made.fields[std::size_t(level)] = field;
  }
  form_->addRow(QString("%1 (%2)").arg(name, unit), made.row);
  return made;
}

TaskMakerPanel::TaskMakerPanel(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setVerticalSpacing(4);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addButtons();  // first, so that no scrolling hides them
  title_ = new QLineEdit(Words::tr("My exercise"), this);
  title_->setAccessibleName(Words::tr("Title"));
  form_->addRow(Words::tr("Title"), title_);
  teaches_ = new QLineEdit(Words::tr("What the learner is to learn."), this);
  teaches_->setAccessibleName(Words::tr("Teaches"));
  form_->addRow(Words::tr("Teaches"), teaches_);
  steps_ = new QPlainTextEdit(this);
  steps_->setPlaceholderText(Words::tr("How it is done, a step a line"));
  steps_->setAccessibleName(Words::tr("Steps"));
  steps_->setTabChangesFocus(true);
  steps_->setFixedHeight(3 * steps_->fontMetrics().lineSpacing() + 12);
  form_->addRow(Words::tr("Steps"), steps_);
  kind_ = new QComboBox(this);
  kind_->setAccessibleName(Words::tr("Goal"));
  for (const KindWords& one : kKinds) kind_->addItem(Words::tr(one.words), int(one.kind));
  form_->addRow(Words::tr("Goal"), kind_);
  structure_ = new QComboBox(this);
  structure_->setAccessibleName(Words::tr("Structure"));
  form_->addRow(Words::tr("Structure"), structure_);
  advice_ = new QLabel(this);
  advice_->setTextFormat(Qt::PlainText);
  advice_->setWordWrap(true);
  form_->addRow(advice_);
  auto* marks = new QHBoxLayout;
  mark_ = new QPushButton(Words::tr("Mark places"), this);
  mark_->setCheckable(true);
  mark_->setToolTip(Words::tr("While this is pressed, a click on the organ marks a place"));
  remove_ = new QPushButton(Words::tr("Remove last"), this);
  remove_->setToolTip(Words::tr("Takes the mark away that was made last"));
  marks->addWidget(mark_);
  marks->addWidget(remove_);
  form_->addRow(marks);
  within_ = number(Words::tr("Within"), Words::tr("How near is near enough"), 1, 50, 8, "mm", 0);
  hold_ = number(Words::tr("Hold for"), Words::tr("So long each target is held, or nothing bleeds"),
                 0.1, 60, 1, "s", 1);
  size_ = number(Words::tr("Radius"), Words::tr("Of the tumour"), 3, 40, 10, "mm", 0);
  depth_ = number(Words::tr("Depth"), Words::tr("Of the tumour's middle under the surface"), 1, 60,
                  12, "mm", 0);
  margin_ = number(Words::tr("Margin"), Words::tr("Least distance of the cuts from the tumour"),
                   0.1, 50, 10, "mm", 0);
  auto* levels = new QHBoxLayout;
  for (const TaskLevel level : kTaskLevels)
    levels->addWidget(new QLabel(translated(std::string(wordOf(level))), this));
  form_->addRow(Words::tr("At most"), levels);
  limits_ = {
      limit(Words::tr("Time"), "total_time_s", Words::tr("Most time in all"), 3600, "s", 0,
            {120, 60, 40}),
      limit(Words::tr("Blood"), "blood_loss_ml", Words::tr("Most blood lost"), 5000, "ml", 0, {}),
      limit(Words::tr("Force"), "force_peak_n", Words::tr("Largest force on the tissue"), 50, "N",
            1, {})};
  guidance_ = new QCheckBox(Words::tr("Guidance in the picture"), this);
  guidance_->setChecked(true);
  form_->addRow(guidance_);
  undo_ = new QCheckBox(Words::tr("Work may be taken back"), this);
  undo_->setChecked(true);
  form_->addRow(undo_);
  form_->addRow(new QLabel(Words::tr("Instruments"), this));
  instruments_ = new QWidget(this);
  new QGridLayout(instruments_);
  instruments_->layout()->setContentsMargins(0, 0, 0, 0);
  form_->addRow(instruments_);
  addTries();
  connect(mark_, &QPushButton::clicked, this, [this](bool on) { markingWanted(on); });
  connect(remove_, &QPushButton::clicked, this, [this] { lastMarkRemoved(); });
  connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
    goalChanged();
    showFields();
  });
  connect(structure_, &QComboBox::currentIndexChanged, this, [this] {
    goalChanged();
    showFields();
  });
}

void TaskMakerPanel::addTries() {
  triesAdvice_ = new QLabel(this);
  triesAdvice_->setWordWrap(true);
  form_->addRow(Words::tr("Reference"), triesAdvice_);
  tries_ = new QListWidget(this);
  tries_->setAccessibleName(Words::tr("Tries"));
  tries_->setFixedHeight(4 * tries_->fontMetrics().lineSpacing() + 12);
  tries_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  form_->addRow(tries_);
  band_ = new QCheckBox(Words::tr("A pass must come near to them"), this);
  band_->setToolTip(Words::tr(
      "Time, path, movements, force and blood at most two standard deviations above the mean of "
      "the checked tries, three or more"));
  form_->addRow(band_);
  connect(tries_, &QListWidget::itemChanged, this, [this] { showFields(); });
}

void TaskMakerPanel::addTry(const QString& words, bool good) {
  auto* item = new QListWidgetItem(words, tries_);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
  item->setCheckState(good ? Qt::Checked : Qt::Unchecked);
  tries_->scrollToBottom();
  showFields();
}

void TaskMakerPanel::clearTries() {
  tries_->clear();
  showFields();
}

std::vector<std::size_t> TaskMakerPanel::references() const {
  std::vector<std::size_t> checked;
  for (int row = 0; row < tries_->count(); ++row)
    if (tries_->item(row)->checkState() == Qt::Checked) checked.push_back(std::size_t(row));
  return checked;
}

bool TaskMakerPanel::bandWanted() const { return band_->isEnabled() && band_->isChecked(); }

void TaskMakerPanel::addButtons() {
  auto* buttons = new QHBoxLayout;
  const auto button = [&](const QString& text, const QString& tip, auto act) {
    auto* made = new QPushButton(text, this);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, act);
    buttons->addWidget(made);
    return made;
  };
  try_ = button(Words::tr("Try it"), Words::tr("Begins the exercise as a learner would"),
                [this] { tried(); });
  save_ =
      button(Words::tr("Save ..."), Words::tr("As a file to be sent (.toml)"), [this] { saved(); });
  auto* close = button(Words::tr("Close"), Words::tr("Gives up what has not been saved"),
                       [this] { closed(); });
  close->setAccessibleName(Words::tr("Close the maker"));
  form_->addRow(buttons);
}

void TaskMakerPanel::begin(const std::vector<std::string>& instruments,
                           const std::vector<std::string>& structures, bool vessels) {
  vessels_ = vessels;
  for (QCheckBox* box : boxes_) delete box;
  boxes_.clear();
  auto* grid = static_cast<QGridLayout*>(instruments_->layout());
  for (const std::string& model : instruments) {
    QString name = shown(model).replace('_', ' ');
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    auto* box = new QCheckBox(translated(name), instruments_);
    box->setProperty("model", QString::fromStdString(model));
    box->setChecked(true);
    grid->addWidget(box, int(boxes_.size()) / 2, int(boxes_.size()) % 2);
    boxes_.push_back(box);
  }
  structure_->clear();
  structure_->addItem(Words::tr(kNew));
  for (const std::string& name : structures)
    structure_->addItem(translated(name), QString::fromStdString(name));
  showFields();
}

Kind TaskMakerPanel::kind() const { return Kind(kind_->currentData().toInt()); }
bool TaskMakerPanel::marksStructure() const { return structure_->currentIndex() <= 0; }
double TaskMakerPanel::structureRadius() const { return 1e-3 * size_->value(); }
double TaskMakerPanel::structureDepth() const { return 1e-3 * depth_->value(); }
std::string TaskMakerPanel::title() const { return title_->text().trimmed().toStdString(); }

std::pair<std::size_t, std::size_t> TaskMakerPanel::placesWanted() const {
  switch (kind()) {
    case Kind::Touch:
      return {1, 50};
    case Kind::Follow:
      return {2, 50};
    case Kind::Resect:
      return marksStructure() ? std::pair<std::size_t, std::size_t>{1, 1}
                              : std::pair<std::size_t, std::size_t>{0, 0};
    case Kind::StopBleeding:
      return {0, 0};
    case Kind::Divide:
      return {1, 1};
    case Kind::Transect:
      return {2, 2};
  }
  return {0, 0};
}

void TaskMakerPanel::setMarks(std::size_t marks, bool marking) {
  marks_ = marks;
  mark_->setChecked(marking);
  showFields();
}

// Only what the goal takes.
void TaskMakerPanel::showFields() {
  const Kind now = kind();
  const auto [least, most] = placesWanted();
  const bool bleeds = now == Kind::StopBleeding || now == Kind::Divide;
  const bool lacks = bleeds && !vessels_;
  const auto words = std::ranges::find(kKinds, now, &KindWords::kind);
  advice_->setText(lacks ? Words::tr("This organ has no vessels: open one that has them first.")
                   : most > 0
                       ? Words::tr("%1 Marked: %2.").arg(Words::tr(words->advice)).arg(marks_)
                       : Words::tr(words->advice));
  form_->setRowVisible(structure_, now == Kind::Resect && structure_->count() > 1);
  form_->setRowVisible(within_, now == Kind::Touch || now == Kind::Follow || now == Kind::Transect);
  form_->setRowVisible(hold_, now == Kind::Touch || now == Kind::StopBleeding);
  const bool fresh = now == Kind::Resect && marksStructure();
  form_->setRowVisible(size_, fresh);
  form_->setRowVisible(depth_, fresh);
  form_->setRowVisible(margin_, now == Kind::Resect);
  form_->setRowVisible(limits_[1].row, vessels_);
  triesAdvice_->setText(tries_->count() == 0
                            ? Words::tr("Try it yourself: learners then see your try as a ghost.")
                            : Words::tr("Learners see the last checked try as a ghost."));
  tries_->setVisible(tries_->count() > 0);
  band_->setVisible(tries_->count() > 0);
  band_->setEnabled(references().size() >= kLeastBandRuns);
  mark_->setEnabled(most > 0 && !lacks);
  remove_->setEnabled(marks_ > 0);
  for (QPushButton* one : {try_, save_}) one->setEnabled(!lacks && marks_ >= least);
}

Task TaskMakerPanel::task() const {
  Task task;
  task.teaches = teaches_->text().trimmed().toStdString();
  if (task.teaches.empty()) task.teaches = "An exercise.";
  task.guidance = guidance_->isChecked();
  task.undo = undo_->isChecked();
  task.goal.kind = kind();
  task.goal.radius = 1e-3 * within_->value();
  task.goal.hold = hold_->value();
  task.goal.margin = 1e-3 * margin_->value();
  task.goal.structure =
      marksStructure() ? "tumour" : structure_->currentData().toString().toStdString();
  for (const QCheckBox* box : boxes_)
    if (box->isChecked())
      task.instruments.push_back(box->property("model").toString().toStdString());
  const QStringList lines = steps_->toPlainText().split('\n', Qt::SkipEmptyParts);
  for (const QString& line : lines)
    if (!line.trimmed().isEmpty()) task.steps.push_back(line.trimmed().toStdString());
  for (const Limit& limit : limits_)
    if (!limit.row->isHidden()) takeLimits(limit, task);
  return task;
}

// A limit that is the same at all levels is one of the task; 0 is none.
void TaskMakerPanel::takeLimits(const Limit& limit, Task& task) const {
  const auto value = [&](TaskLevel level) { return limit.fields[std::size_t(level)]->value(); };
  const bool same = std::ranges::all_of(
      kTaskLevels, [&](TaskLevel level) { return value(level) == value(TaskLevel::Easy); });
  if (same && value(TaskLevel::Easy) > 0)
    task.limits.push_back({limit.measure, {}, value(TaskLevel::Easy)});
  for (const TaskLevel level : kTaskLevels)
    if (!same && value(level) > 0)
      task.levels[std::size_t(level)].push_back({limit.measure, {}, value(level)});
}

}  // namespace resect
