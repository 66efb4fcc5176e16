#include "app/widgets/timeline_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>

#include "app/language/words.h"
#include "app/say.h"

namespace resect {
namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4};
constexpr int kMargin = 10;  // pixels beside the bar

QColor colourOf(std::int64_t tool) {
  if (tool < 0) return {150, 150, 150};
  constexpr int kHues[] = {190, 30, 280, 110, 55, 330, 225};
  const auto number = std::size_t(tool);
  const bool dark = number / std::size(kHues) % 2 == 1;
  return QColor::fromHsv(kHues[number % std::size(kHues)], dark ? 220 : 110, dark ? 110 : 190);
}

// One line that ends in "..." where there is no room for all of it.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent) : QLabel(parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width()));
  }
};

}  // namespace

QString clockText(double seconds) {
  const auto tenths = std::int64_t(std::floor(seconds * 10 + 1e-6));
  return QString("%1:%2.%3")
      .arg(tenths / 600)
      .arg(tenths / 10 % 60, 2, 10, QChar('0'))
      .arg(tenths % 10);
}

// The bar itself. A press or a drag asks for the moment under the pointer.
class TimelineBar : public QWidget {
 public:
  explicit TimelineBar(TimelinePanel* panel) : QWidget(panel), panel_(*panel) {
    setMinimumHeight(36);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::PointingHandCursor);
  }
  double xOf(std::int64_t frame) const {
    return kMargin +
           double(frame) / double(std::max<std::int64_t>(1, panel_.end_)) * (width() - 2 * kMargin);
  }

 protected:
  void mousePressEvent(QMouseEvent* event) override { mouseMoveEvent(event); }
  void mouseMoveEvent(QMouseEvent* event) override {
    if (event->buttons() & Qt::LeftButton) panel_.ask(frameAt(event->position().x()));
  }
  bool event(QEvent* event) override {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), textAt(frameAt(help->pos().x())), this);
    return true;
  }
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(kMargin, 4, width() - 2 * kMargin, height() - 16);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(track, 3, 3);
    const Timeline& timeline = *panel_.timeline_;
    if (timeline.courses.empty()) return;
    // The longest first, so that the strokes of one hand are seen while the other holds.
    std::vector<Stroke> strokes = timeline.strokesOn(panel_.branch_);
    std::ranges::stable_sort(strokes, std::greater(),
                             [](const Stroke& s) { return s.to - s.from; });
    for (const Stroke& stroke : strokes) {
      painter.setBrush(colourOf(stroke.tool));
      const double from = xOf(stroke.from);
      painter.drawRect(
          QRectF(from, track.top() + 2, std::max(2.0, xOf(stroke.to) - from), track.height() - 4));
    }
    painter.setPen(QPen(QColor(224, 72, 60), 2));
    for (const std::int64_t fault : timeline.faultsOn(panel_.branch_))
      painter.drawLine(QPointF(xOf(fault), track.top()), QPointF(xOf(fault), track.bottom()));
    // Where other branches leave this way: a mark below.
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::WindowText));
    for (const Timeline::Course* course : panel_.branchesBeside()) {
      const double x = xOf(course->branch.from), y = track.bottom() + 2;
      painter.drawPolygon(QPolygonF({{x, y}, {x - 4, y + 7}, {x + 4, y + 7}}));
    }
    for (const TimelinePanel::Mark& mark : panel_.marks_) {
      const QRectF disc(xOf(mark.frame) - 8, track.center().y() - 8, 16, 16);
      painter.setPen(QPen(Qt::white, 1));
      painter.setBrush(QColor(179, 54, 43));
      painter.drawEllipse(disc);
      painter.drawText(disc, Qt::AlignCenter, mark.number);
    }
    const double x = xOf(panel_.asked_ >= 0 ? panel_.asked_ : panel_.frame_);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
    painter.drawLine(QPointF(x, 0), QPointF(x, track.bottom() + 4));
  }

 private:
  std::int64_t frameAt(double x) const {
    const double share = std::clamp((x - kMargin) / std::max(1, width() - 2 * kMargin), 0.0, 1.0);
    return std::llround(share * double(panel_.end_));
  }
  QString textAt(std::int64_t frame) const {
    QString text = clockText(double(frame) / panel_.frameRate_);
    const double near = 3.0 / std::max(1e-9, xOf(1) - xOf(0));  // frames in three pixels
    for (const Timeline::Course* course : panel_.branchesBeside())
      if (std::abs(double(course->branch.from - frame)) < 2 * near)
        text += "\n" + Words::tr("Branch %1 begins here").arg(translated(course->branch.name));
    for (const TimelinePanel::Mark& mark : panel_.marks_)
      if (std::abs(double(mark.frame - frame)) < 3 * near)
        text += "\n" + mark.number + ": " + mark.text;
    int number = 0;
    const auto strokes = panel_.timeline_->courses.empty()
                             ? std::vector<Stroke>()
                             : panel_.timeline_->strokesOn(panel_.branch_);
    for (const Stroke& s : strokes) {
      ++number;
      if (double(frame) < double(s.from) - near || double(frame) > double(s.to) + near) continue;
      text += "\n" + Words::tr("Stroke %1").arg(number);
      if (s.tool >= 0 && std::size_t(s.tool) < panel_.tools_.size())
        text += ", " + panel_.tools_[std::size_t(s.tool)];
      text += QString(": %1 s").arg(double(s.to - s.from) / panel_.frameRate_, 0, 'f', 1);
      if (!panel_.laboratory_) continue;
      if (s.removed > 0)
        text += (s.removed == 1 ? Words::tr(", %L1 particle removed")
                                : Words::tr(", %L1 particles removed"))
                    .arg(s.removed);
      if (s.severed > 0) text += Words::tr(", %L1 bonds cut").arg(s.severed);
      if (s.torn > 0) text += Words::tr(", %L1 bonds torn").arg(s.torn);
    }
    return text;
  }

  TimelinePanel& panel_;
};

TimelinePanel::TimelinePanel(QWidget* parent) : QWidget(parent) {
  const auto button = [&](const QString& text, const QString& tip, auto act) {
    auto* made = new QToolButton(this);
    made->setText(text);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);
    connect(made, &QToolButton::clicked, this, act);
    return made;
  };
  bar_ = new TimelineBar(this);
  auto* back = button("|<", Words::tr("To the start of the operation"), [this] { toStart(); });
  auto* less = button("<", Words::tr("One frame back (comma)"), [this] { step(-1); });
  play_ = button(Words::tr("Play"),
                 Words::tr("Plays again what happened after this moment (Ctrl+Space)"),
                 [this] { togglePlayback(); });
  auto* more = button(">", Words::tr("One frame on (point)"), [this] { step(1); });
  auto* end = button(">|", Words::tr("To the end of this branch (End)"), [this] { toEnd(); });
  rate_ = new QComboBox(this);
  for (const double speed : kSpeeds) rate_->addItem(QString("%1 x").arg(speed), speed);
  rate_->setCurrentIndex(2);
  rate_->setToolTip(Words::tr("Speed of playing"));
  rate_->setFocusPolicy(Qt::TabFocus);
  connect(rate_, &QComboBox::currentIndexChanged, this, [this] {
    if (speed_ > 0 && playback) playback(rate_->currentData().toDouble());
  });
  time_ = new QLabel(this);
  // So wide that the row does not move as the operation goes on.
  time_->setMinimumWidth(
      fontMetrics().horizontalAdvance(Words::tr("%1 of %2").arg("00:00.0", "00:00.0")));
  time_->setToolTip(Words::tr("The moment that is shown, and the end of this branch"));
  branches_ = new QComboBox(this);
  branches_->setToolTip(
      Words::tr("Branches: one begins wherever somebody went back and worked on from there"));
  branches_->setFocusPolicy(Qt::TabFocus);
  branches_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  branches_->setMaximumWidth(26 * fontMetrics().averageCharWidth());
  connect(branches_, &QComboBox::activated, this,
          [this](int index) { lookAt(branches_->itemData(index).toLongLong()); });
  compare_ =
      button(Words::tr("Compare ..."), Words::tr("All branches side by side (Ctrl+B)"), [this] {
        if (compare) compare();
      });
  goOn_ = button(Words::tr("Go on"),
                 Words::tr("Operates from this moment; the rest stays as a branch (Ctrl+Return)"),
                 [this] {
                   if (goOn) goOn();
                 });
  hint_ = new ElidedLabel(this);
  memory_ = new QLabel(this);
  memory_->setToolTip(Words::tr(
      "Memory for the states from which any moment is shown. When it is full, old moments take "
      "longer to reach (option --history)"));

  auto* row = new QHBoxLayout;
  row->setContentsMargins(kMargin, 0, kMargin, 4);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{back, less, play_, more, end, rate_, time_, goOn_, hint_})
    row->addWidget(widget);
  row->setStretchFactor(hint_, 1);
  row->addWidget(memory_);
  row->addWidget(branches_);
  row->addWidget(compare_);
  // The row is as narrow as it is in an operation, lest it widen the window that opens.
  for (QWidget* widget : std::initializer_list<QWidget*>{memory_, branches_, compare_})
    widget->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 2, 0, 0);
  column->setSpacing(2);
  column->addWidget(bar_);
  column->addLayout(row);
}

void TimelinePanel::setLaboratory(bool shown) {
  laboratory_ = shown;
  memory_->setVisible(shown);
}

void TimelinePanel::setMarks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  bar_->update();
}

void TimelinePanel::begin(const std::vector<QString>& tools, double frameRate) {
  marks_.clear();
  timeline_ = std::make_shared<Timeline>();
  tools_ = tools;
  frameRate_ = frameRate;
  branch_ = frame_ = end_ = 0;
  asked_ = -1;
  showing_ = false;
  speed_ = 0;
  listBranches();
  describe();
}

void TimelinePanel::follow(const LiveState& state, bool showing, bool answered) {
  if (!state.timeline || state.timeline->courses.empty()) return;
  const bool fresh = timeline_ != state.timeline;
  const std::size_t before = timeline_->courses.size();
  timeline_ = state.timeline;
  showing_ = showing;
  speed_ = showing ? state.playback : 0;
  frame_ = state.moment.frame;
  // What is operated on is looked at; so is a moment that does not lead to the branch looked at.
  const bool leads =
      std::size_t(branch_) < timeline_->courses.size() && timeline_->leadsTo(branch_, state.moment);
  if ((!showing && asked_ < 0) || !leads) branch_ = state.moment.branch;
  if (answered) asked_ = -1;
  end_ = std::max(timeline_->courses[std::size_t(branch_)].end, frame_);
  if (fresh || before != timeline_->courses.size()) listBranches();
  memory_->setText(QString("%1 MB").arg(double(state.historyBytes) / (1 << 20), 0, 'f', 0));
  describe();
}

// In words, and in the bar, where the operation is.
void TimelinePanel::describe() {
  time_->setText(
      Words::tr("%1 of %2")
          .arg(clockText(double(frame_) / frameRate_), clockText(double(end_) / frameRate_)));
  play_->setText(speed_ > 0 ? Words::tr("Stop") : Words::tr("Play"));
  play_->setEnabled(showing_ && (speed_ > 0 || frame_ < end_));
  goOn_->setEnabled(showing_);
  hint_->setText(!showing_       ? QString()
                 : asked_ >= 0   ? Words::tr("going there ...")
                 : frame_ < end_ ? Words::tr("Looking back (End: to the end)")
                                 : Words::tr("Paused: take an instrument to go on"));
  hint_->setToolTip(hint_->text());
  goOn_->setText(frame_ < end_ ? Words::tr("Go on from here") : Words::tr("Go on"));
  bar_->update();
}

// A branch in which no stroke was made is of no interest.
bool TimelinePanel::isListed(const Timeline::Course& course) {
  return !course.strokes.empty() || course.branch.number == 0;
}

std::vector<const Timeline::Course*> TimelinePanel::branchesBeside() const {
  std::vector<const Timeline::Course*> found;
  for (const Timeline::Course& course : timeline_->courses) {
    const Branch& b = course.branch;
    if (b.parent >= 0 && b.number != branch_ && isListed(course) &&
        timeline_->leadsTo(branch_, {b.parent, b.from}))
      found.push_back(&course);
  }
  return found;
}

void TimelinePanel::listBranches() {
  std::vector<std::pair<QString, std::int64_t>> items;
  for (const Timeline::Course& course : timeline_->courses)
    if (course.branch.number == branch_ || isListed(course))
      items.emplace_back(Words::tr("Branch %1").arg(translated(course.branch.name)),
                         course.branch.number);
  bool same = int(items.size()) == branches_->count();
  for (int i = 0; same && i < branches_->count(); ++i)
    same = branches_->itemText(i) == items[std::size_t(i)].first;
  const QSignalBlocker quiet(branches_);
  if (!same) {
    branches_->clear();
    for (const auto& [name, number] : items) branches_->addItem(name, qlonglong(number));
  }
  branches_->setCurrentIndex(branches_->findData(qlonglong(branch_)));
  branches_->setVisible(items.size() > 1);
  compare_->setVisible(items.size() > 1);
}

void TimelinePanel::ask(std::int64_t frame) {
  if (timeline_->courses.empty() || !wanted) return;
  asked_ = std::clamp<std::int64_t>(frame, timeline_->courses[0].branch.from, end_);
  // The timeline may be some frames old.
  const Timeline::Course& course = timeline_->courses[std::size_t(branch_)];
  asked_ = std::min(asked_, course.end);
  wanted(timeline_->momentOn(branch_, asked_));
  bar_->update();
}

void TimelinePanel::step(std::int64_t frames) {
  if (frames < 0 || showing_) ask((asked_ >= 0 ? asked_ : frame_) + frames);
}

void TimelinePanel::toEnd() {
  if (showing_) ask(end_);
}

void TimelinePanel::lookAt(std::int64_t branch) {
  if (branch < 0 || std::size_t(branch) >= timeline_->courses.size()) return;
  branch_ = branch;
  end_ = timeline_->courses[std::size_t(branch)].end;
  listBranches();
  ask(end_);
}

void TimelinePanel::togglePlayback() {
  if (!showing_ || !playback) return;
  playback(speed_ > 0 ? 0 : rate_->currentData().toDouble());
}

std::pair<QPoint, QPoint> TimelinePanel::barEnds() const {
  const int y = 4 + (bar_->height() - 16) / 2;
  return {bar_->mapToGlobal(QPoint(kMargin, y)),
          bar_->mapToGlobal(QPoint(bar_->width() - kMargin, y))};
}

}  // namespace resect
