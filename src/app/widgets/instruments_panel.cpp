#include "app/widgets/instruments_panel.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "app/say.h"
#include "inventor/hand/tool_keys.h"

namespace resect {

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
    names_.push_back(QString("%1   %2").arg(key, shown(tools[i].name)));
    button->setText(names_.back());
    button->setToolTip(QString("<p>%1<br>Key %2 takes it in hand; Escape puts it back.</p>")
                           .arg(shownInHtml(tools[i].description), key));
    button->setAccessibleName(shown(tools[i].name));
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

void InstrumentsPanel::show(int held, const std::vector<std::uint8_t>& left) {
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->setChecked(int(i) == held);
    const QString text = left[i] ? names_[i] + "   (at work)" : names_[i];
    if (buttons_[i]->text() != text) buttons_[i]->setText(text);
  }
}

}  // namespace resect
