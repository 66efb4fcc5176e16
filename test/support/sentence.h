// Checks of the sentence of an Error.
#pragma once

#include <string>

#include "base/error.h"

namespace resect::test {

// The sentence of the Error that `act` throws; empty without one.
template <typename Act>
std::string sentenceOf(Act act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

inline bool isOneSentence(const std::string& text) {
  return text.size() > 20 && text.find('\n') == std::string::npos && text.back() != '.';
}

inline bool tells(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

// Is what `act` wants refused by an Error, in one sentence that tells `what`?
template <typename Act>
bool refuses(Act act, const std::string& what) {
  const std::string sentence = sentenceOf(act);
  return isOneSentence(sentence) && tells(sentence, what);
}

// One line that begins with the file and says what is wrong with it.
inline bool isRefusalOf(const std::string& file, const std::string& what, const std::string& text) {
  return text.starts_with(file) && tells(text, what) && text.find('\n') == std::string::npos;
}

}  // namespace resect::test
