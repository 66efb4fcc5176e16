#include "app/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>

namespace resect {
namespace {

constexpr const char* kSetting = "language";

bool other = false;  // than English

bool isOffered(std::string_view code) {
  return std::ranges::count(kLanguages, code, &Language::code) > 0;
}

// By LANGUAGE, LC_ALL, LC_MESSAGES and LANG.
std::string systemLanguage() {
  for (const QString& one : QLocale::system().uiLanguages())
    if (const std::string code = one.left(2).toStdString(); isOffered(code)) return code;
  return std::string(kLanguages[0].code);
}

}  // namespace

std::vector<std::string> languageCodes() {
  std::vector<std::string> codes;
  for (const Language& one : kLanguages) codes.emplace_back(one.code);
  return codes;
}

void useLanguage(const std::string& given) {
  std::string code = given.empty() ? chosenLanguage() : given;
  if (!isOffered(code)) code = systemLanguage();
  other = code != kLanguages[0].code;
  if (!other) return;
  const auto install = [](const QString& file, const QString& folder) {
    auto* translator = new QTranslator(QCoreApplication::instance());
    if (translator->load(file, folder)) QCoreApplication::installTranslator(translator);
  };
  const QString of = QString::fromStdString(code);
  // Qt's own texts, such as the buttons of dialogs. Without the package that has them
  // (qt6-translations-l10n) they stay English.
  install("qtbase_" + of, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install("resect_" + of, ":/language");
  // All figures have a point. So thousands have no comma, which elsewhere reads as a point.
  QLocale plain = QLocale::c();
  plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale::setDefault(plain);
}

bool isTranslated() { return other; }

std::string chosenLanguage() { return QSettings().value(kSetting).toString().toStdString(); }

void chooseLanguage(const std::string& code) {
  QSettings().setValue(kSetting, QString::fromStdString(code));
}

}  // namespace resect
