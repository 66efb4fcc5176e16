#include "app/language/language_menu.h"

#include <QActionGroup>
#include <QMenu>

#include "app/language/language.h"
#include "app/language/words.h"

namespace resect {

void addLanguageMenu(QMenu* menu, std::function<void(const QString&)> tell) {
  QMenu* languages = menu->addMenu(Words::tr("Lan&guage"));
  auto* group = new QActionGroup(languages);
  const auto add = [&](const QString& name, const std::string& code) {
    QAction* action = languages->addAction(name);
    action->setCheckable(true);
    action->setChecked(code == chosenLanguage());
    action->setToolTip(Words::tr("The window's language from the next start on"));
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, menu, [code, tell] {
      chooseLanguage(code);
      tell(Words::tr("The window has this language from the next start on"));
    });
  };
  add(Words::tr("As the system"), "");
  languages->addSeparator();
  for (const auto& [code, name] : kLanguages)
    add(QString::fromUtf8(name.data(), qsizetype(name.size())), std::string(code));
}

}  // namespace resect
