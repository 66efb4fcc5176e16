#include "app/widgets/hint_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/language/words.h"

namespace resect {

HintBar::HintBar(QWidget* parent)
    : QWidget(parent),
      exercises_(new QPushButton(Words::tr("Exercises"), this)),
      sentence_(new QLabel(this)),
      mend_(new QPushButton(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 10, 4);
  exercises_->setFocusPolicy(Qt::TabFocus);
  exercises_->setToolTip(Words::tr("Exercises with a goal and a result (Ctrl+T)"));
  connect(exercises_, &QPushButton::clicked, this, [this] {
    if (exercisesWanted) exercisesWanted();
  });
  row->addWidget(exercises_);
  row->addWidget(sentence_, 1);
  row->addWidget(mend_);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setWordWrap(true);
  QFont large = sentence_->font();
  large.setPointSizeF(1.15 * large.pointSizeF());
  sentence_->setFont(large);
  sentence_->setAccessibleName(Words::tr("What to do next"));
  mend_->setFocusPolicy(Qt::TabFocus);
  mend_->setToolTip(Words::tr(
      "The simulation is slower than real time. Larger cells are faster; the operation begins "
      "again, and what was done stays in File > Recorded operations"));
  // Its room is kept while it is hidden, so that the sentence does not break anew beside it.
  mend_->setText(Words::tr("Make it smooth: cells of %1 mm").arg(88));
  mend_->setFixedWidth(mend_->sizeHint().width());
  QSizePolicy kept = mend_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  mend_->setSizePolicy(kept);
  mend_->hide();
  connect(mend_, &QPushButton::clicked, this, [this] {
    if (accepted && offered_ > 0) accepted(offered_);
  });
}

void HintBar::say(const QString& sentence) {
  if (sentence_->text() == sentence) return;
  sentence_->setText(sentence);
  keepHeight();
}

void HintBar::reserve(int lines) {
  if (lines == fewest_) return;
  fewest_ = lines;
  keepHeight();
}

void HintBar::offerCells(int millimetres) {
  if (millimetres == offered_) return;
  offered_ = millimetres;
  mend_->setText(Words::tr("Make it smooth: cells of %1 mm").arg(millimetres));
  mend_->setVisible(millimetres > 0);
  keepHeight();
}

QPoint HintBar::buttonPlace() const {
  return mend_->mapToGlobal(QPoint(mend_->width() / 2, mend_->height() / 2));
}

void HintBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  height_ = 0;
  keepHeight();
}

int HintBar::heightOf(int lines) const {
  const QString text = QStringList(QList<QString>(lines, "X")).join('\n');
  return sentence_->fontMetrics().boundingRect(QRect(0, 0, 100, 1000), 0, text).height();
}

// As high as the longest sentence so far needed at this width: the picture below does not jump.
void HintBar::keepHeight() {
  const QMargins margins = layout()->contentsMargins();
  int beside = 0;
  for (const QPushButton* button : {exercises_, mend_})
    beside += button->sizeHint().width() + layout()->spacing();
  const int width = this->width() - margins.left() - margins.right() - beside;
  if (width <= 0) return;
  height_ = std::max({height_, sentence_->heightForWidth(width), heightOf(fewest_)});
  sentence_->setMinimumHeight(std::max(height_, exercises_->sizeHint().height()));
}

}  // namespace resect
