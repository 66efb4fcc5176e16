#include "app/widgets/banner.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/language/words.h"

namespace resect {

Banner::Banner(QWidget* parent) : QFrame(parent), sentence_(new QLabel(this)) {
  setStyleSheet(
      "resect--Banner { background: #7a2a22; border-radius: 6px; } "
      "QLabel { color: white; } QToolButton { color: white; border: 0; padding: 2px 6px; }");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 8, 8, 8);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setWordWrap(true);
  row->addWidget(sentence_, 1);
  auto* close = new QToolButton(this);
  close->setText(Words::tr("Close"));
  close->setFocusPolicy(Qt::TabFocus);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  row->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void Banner::say(const QString& sentence, std::function<bool()> holds) {
  sentence_->setText(sentence);
  setAccessibleName(sentence);
  holds_ = std::move(holds);
  wentOn_ = 0;
  show();
}

void Banner::userWentOn() {
  if (wentOn_ == 0) wentOn_ = QDateTime::currentMSecsSinceEpoch();
}

bool Banner::leaves() {
  constexpr qint64 kReading = 8000;  // ms
  if (!isVisible()) return false;
  const bool over =
      holds_ ? !holds_() : wentOn_ > 0 && QDateTime::currentMSecsSinceEpoch() - wentOn_ > kReading;
  if (over) hide();
  return over;
}

void Banner::place(const QRect& area) {
  const int most = std::max(80, area.width() - 40);
  const int beside = width() - sentence_->width();
  const int needed = sentence_->fontMetrics().horizontalAdvance(sentence_->text()) + 4;
  layout()->activate();
  const QSize hint = layout()->minimumSize();
  const int wide = std::min(most, std::max(needed + std::max(beside, 90), hint.width()));
  resize(wide, std::max(hint.height(), layout()->heightForWidth(wide)));
  move(area.topLeft() + QPoint(20, 14));
  raise();
}

void Banner::mousePressEvent(QMouseEvent* event) {
  hide();
  event->accept();
}

}  // namespace resect
