// The menu in which the user chooses the window's language.
#pragma once

#include <QString>
#include <functional>

class QMenu;

namespace resect {

// Adds a submenu with the languages to `menu`. The user's choice is kept in the settings, and takes
// effect at the next start of the program. `tell` gets a sentence that says when the choice
// takes effect.
void addLanguageMenu(QMenu* menu, std::function<void(const QString&)> tell);

}  // namespace resect
