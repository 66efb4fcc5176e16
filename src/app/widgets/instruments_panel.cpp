#include "app/widgets/instruments_panel.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "app/language/words.h"
#include "app/say.h"
#include "inventor/hand/tool_keys.h"

namespace resect {
namespace {

// The name of an instrument that works, or should, while another is in hand; with a mark where the
// button is too narrow for words.
QString atWork(const QToolButton& button, const QString& name, LeftTool left) {
  constexpr int kFrame = 16;  // pixels of the button beside its text
  const QString words =
      (left == LeftTool::Works ? Words::tr("%1   (at work)") : Words::tr("%1   (touches nothing)"))
          .arg(name);
  const bool fits = button.fontMetrics().horizontalAdvance(words) + kFrame <= button.width();
  return fits ? words : QString(left == LeftTool::Works ? "%1 \u25cf" : "%1 \u25cb").arg(name);
}

}  // namespace

InstrumentsPanel::InstrumentsPanel(QWidget* parent) : QWidget(parent) {
  layout_ = new QVBoxLayout(this);
  layout_->addStretch();
}

void InstrumentsPanel::setTools(const std::vector<ToolModel>& tools) {
  for (QToolButton* button : buttons_) delete button;
  buttons_.clear();
  names_.clear();
  for (std::size_t i = 0; i < tools.size(); ++i) {
    auto* button = new QToolButton(this);
    const QString key = QString::fromStdString(keyOfTool(i));
    names_.push_back(QString("%1   %2").arg(key, translated(tools[i].name)));
    button->setText(names_.back());
    button->setToolTip("<p>" + translatedInHtml(tools[i].description) + "<br>" +
                       Words::tr("Key %1 takes it in hand; Escape puts it back.").arg(key) +
                       "</p>");
    button->setAccessibleName(translated(tools[i].name));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QObject::connect(button, &QToolButton::clicked, this, [this, i] {
      if (chosen) chosen(int(i));
    });
    layout_->insertWidget(int(i), button);
    buttons_.push_back(button);
  }
}

void InstrumentsPanel::show(int held, const std::vector<LeftTool>& left) {
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->setChecked(int(i) == held);
    const QString text =
        left[i] == LeftTool::No ? names_[i] : atWork(*buttons_[i], names_[i], left[i]);
    if (buttons_[i]->text() != text) buttons_[i]->setText(text);
  }
}

}  // namespace resect
