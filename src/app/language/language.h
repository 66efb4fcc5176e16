// The languages of the window, and how one is chosen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace resect {

struct Language {
  std::string_view code;  // ISO 639-1
  std::string_view name;  // in the language itself
};
// English, which the source texts are in, comes first. Each other one has
// src/app/language/resect_<code>.ts.
inline constexpr Language kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}};

std::vector<std::string> languageCodes();

// Translates all texts of the window that are made from now on. given: a code of kLanguages. Empty:
// the language that the user chose in the menu, or else the first of the system's languages that
// the window has, or else English. To be called once, when QApplication and the names for its
// settings exist.
void useLanguage(const std::string& given);

bool isTranslated();  // whether the language in use is another one than English

// The user's choice, kept in the settings for the next start; empty: the system's language.
std::string chosenLanguage();
void chooseLanguage(const std::string& code);

}  // namespace resect
