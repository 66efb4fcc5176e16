// Recognises English texts of data files and of the layers below, and translates them. Those layers
// know no language, and recordings and reports keep their sentences in English. So a sentence with
// figures is compared with the patterns from which such sentences are made (sentence_texts.h), and
// the pattern is translated; its values are translated in the same way.
#include <QHash>
#include <QRegularExpression>
#include <algorithm>
#include <optional>
#include <vector>

#include "app/language/language.h"
#include "app/language/sentence_texts.h"
#include "app/language/words.h"
#include "app/say.h"

namespace resect {
namespace {

struct Pattern {
  const char* source;
  QRegularExpression expression;  // with a group for each value
};

QRegularExpression expressionOf(const QString& source) {
  static const QRegularExpression placeholder("%\\d( (mm|ml|N|s|%)(?!\\w)| to (?=%))?");
  QString expression;
  qsizetype at = 0;
  for (auto all = placeholder.globalMatch(source); all.hasNext();) {
    const QRegularExpressionMatch match = all.next();
    expression += QRegularExpression::escape(source.mid(at, match.capturedStart() - at));
    // Before a unit, or before another value's "to", stands a number.
    expression += match.captured(1).isEmpty()
                      ? QString("(.*?)")
                      : "([-+.0-9e]+)" + QRegularExpression::escape(match.captured(1));
    at = match.capturedEnd();
  }
  expression += QRegularExpression::escape(source.mid(at));
  return QRegularExpression(QRegularExpression::anchoredPattern(expression),
                            QRegularExpression::CaseInsensitiveOption);
}

// The longest first: they are the most special.
std::vector<Pattern> sortedPatterns() {
  std::vector<Pattern> patterns;
  for (const char* source : kSentenceTexts)
    patterns.push_back({source, expressionOf(QString::fromUtf8(source))});
  std::ranges::stable_sort(patterns, std::greater<>(), [](const Pattern& one) {
    const QString text = QString::fromUtf8(one.source);
    return text.size() - 2 * text.count('%');
  });
  return patterns;
}

QString inLanguage(const QString& text);

QString capitalisedAs(const QString& english, QString text) {
  if (!english.isEmpty() && !text.isEmpty() && english[0].isUpper()) text[0] = text[0].toUpper();
  return text;
}

// A text of a data file; no value: it is not known.
std::optional<QString> dataText(const QString& english) {
  for (const QString& one : {english, english.left(1).toUpper() + english.mid(1)}) {
    const QByteArray source = one.toUtf8();
    const QString text = QCoreApplication::translate("data", source);
    if (text != one) return text;
  }
  return {};
}

std::optional<QString> sentence(const QString& english) {
  static const std::vector<Pattern> patterns = sortedPatterns();
  for (const auto& [source, expression] : patterns) {
    const QRegularExpressionMatch match = expression.match(english);
    if (!match.hasMatch()) continue;
    const QString pattern = QCoreApplication::translate("sentences", source);
    QString text;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
      const int number =
          pattern[i] == '%' && i + 1 < pattern.size() ? pattern[i + 1].digitValue() : -1;
      if (number < 1 || number > match.lastCapturedIndex()) {
        text += pattern[i];
        continue;
      }
      text += inLanguage(match.captured(number));
      ++i;
    }
    return capitalisedAs(english, text);
  }
  return {};
}

std::optional<QString> known(const QString& text) {
  const std::optional<QString> data = dataText(text);
  return data ? data : sentence(text);
}

// The parts of a text, each translated; no value: one of them is not known, or there is only one.
std::optional<QString> byParts(const QStringList& parts, const QString& between, bool all) {
  if (parts.size() < 2) return {};
  QStringList texts;
  for (const QString& part : parts) {
    const std::optional<QString> text = known(part);
    if (!text && all) return {};
    texts << text.value_or(part);
  }
  return texts.join(between);
}

// One text, several sentences, or names with commas between them.
QString inLanguage(const QString& text) {
  static const QRegularExpression letter("[A-Za-z]{2}"), end("(?<=[.!?]) +(?=[A-Z])");
  if (!text.contains(letter)) return text;
  if (const auto data = dataText(text)) return *data;
  // Sentences before a pattern of one that would take the next one for a value.
  const QStringList sentences = text.split(end);
  if (const auto all = byParts(sentences, " ", true)) return *all;
  if (const auto whole = sentence(text)) return *whole;
  if (const auto some = byParts(sentences, " ", false)) return *some;
  return byParts(text.split(", "), ", ", true).value_or(text);
}

}  // namespace

QString translated(const QString& english, std::size_t most) {
  if (!isTranslated()) return shown(english.toStdString(), most);
  static QHash<QString, QString> before;  // panels ask for the same texts again and again
  constexpr int kMost = 1000;
  if (before.size() > kMost) before.clear();
  auto at = before.constFind(english);
  if (at == before.constEnd()) at = before.insert(english, inLanguage(english));
  return shown(at->toStdString(), most);
}

QString translated(const std::string& english, std::size_t most) {
  return translated(QString::fromStdString(english), most);
}

QString translatedInHtml(const std::string& english) { return translated(english).toHtmlEscaped(); }

}  // namespace resect
