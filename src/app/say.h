// Makes foreign text (from files and names) safe to show in the window. Prints the window's reports
// for scripts to standard output: one line per event, flushed immediately.
#pragma once

#include <fmt/format.h>

#include <QString>
#include <cstdio>
#include <string>

#include "base/text/shown_text.h"

namespace resect {

// Converts foreign text to one line for labels, buttons and dialogs. Control characters become
// visible.
inline QString shown(const std::string& text, std::size_t most = kLongestShown) {
  return QString::fromStdString(shownText(text, most));
}

// The same for tool tips and labels that interpret HTML. HTML tags in the text are escaped.
inline QString shownInHtml(const std::string& text) { return shown(text).toHtmlEscaped(); }

template <typename... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  const std::string line = fmt::format(format, std::forward<Args>(args)...);
  std::fputs(shownText(line, kLongestShownPath).c_str(), stdout);
  std::fputc('\n', stdout);
  std::fflush(stdout);
}

}  // namespace resect
