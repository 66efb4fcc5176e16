// The window's texts in the language of the person who works. Source texts are English; Qt's
// translations (resect_de.ts here) hold the others. How a language is added: docs/window.md.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

#include "base/text/shown_text.h"

namespace resect {

// Words::tr("Close") is the text in the window's language. Texts in constant tables stand in
// QT_TRANSLATE_NOOP("window", "..."), and are passed to Words::tr() where they are shown.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(window)
};

// Texts that src/app does not write itself: those of data files (titles, instruments), names of
// vessels, and sentences with figures that the layers below have made in English. Each becomes one
// line as shown() makes it, in the window's language if a translation is known, else in English.
QString translated(const std::string& english, std::size_t most = kLongestShown);
QString translated(const QString& english, std::size_t most = kLongestShown);
// The same for tool tips, which interpret HTML.
QString translatedInHtml(const std::string& english);

}  // namespace resect
