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
// English, the language of the source texts, comes first. For each other language there is a file
// src/app/language/resect_<code>.ts with the translations.
inline constexpr Language kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}};

std::vector<std::string> languageCodes();

// Sets the language for all texts of the window that are made from now on. given: a code of
// kLanguages. If `given` is empty, the language is the one that the user chose in the menu. If the
// user never chose one, it is the first of the system's languages for which there is a translation,
// or English if there is none. To be called once, after QApplication was made and its names
// (organisation and program) were set.
void useLanguage(const std::string& given);

bool isTranslated();  // whether the language in use is not English

// The user's choice, kept in the settings for the next start; empty: the system's language.
std::string chosenLanguage();
void chooseLanguage(const std::string& code);

}  // namespace resect
