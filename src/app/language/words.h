// The window's texts in the user's language. Texts in the source code are English. The files
// resect_<code>.ts in this folder hold their translations. docs/window.md says how to add a
// language.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

#include "base/text/shown_text.h"

namespace resect {

// Words::tr("Close") is the text "Close" in the window's language. Texts in constant tables are
// marked by QT_TRANSLATE_NOOP("window", "..."), and passed to Words::tr() when they are shown.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(window)
};

// Translates an English text that was not made in src/app. Examples are titles and names of
// instruments from data files, names of vessels, and sentences with figures from the lower layers.
// The result is one line without control characters, as shown() makes it (app/say.h). If there is
// no translation, the line is in English. most: the largest number of characters.
QString translated(const std::string& english, std::size_t most = kLongestShown);
QString translated(const QString& english, std::size_t most = kLongestShown);
// Does the same for tool tips, which interpret HTML. HTML tags in the text are escaped.
QString translatedInHtml(const std::string& english);

}  // namespace resect
