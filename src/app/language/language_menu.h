// The menu in which the user chooses the window's language.
#pragma once

#include <QString>
#include <functional>

class QMenu;

namespace resect {

// Adds the menu to `menu`. A choice is kept in the settings, and takes effect at the next start,
// which `tell` is called with a sentence about.
void addLanguageMenu(QMenu* menu, std::function<void(const QString&)> tell);

}  // namespace resect
