// The exception for unusable input (file, mesh, setting, argument). Its text is one sentence, which
// says three things: what is wrong, where it is wrong (file:line or field), and what to do about
// it.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace resect {

// If an Error reaches main(), the program prints "resect: error: <sentence>" and exits with
// status().
class Error : public std::runtime_error {
 public:
  enum class Status { Failed = 1, Usage = 2 };
  explicit Error(const std::string& sentence, Status status = Status::Failed)
      : std::runtime_error(withoutNul(sentence)), status_(status) {}
  Status status() const { return status_; }

 private:
  // what() ends at the first NUL, and foreign text in the sentence may hold a NUL.
  static std::string withoutNul(std::string sentence) {
    for (char& c : sentence)
      if (c == '\0') c = ' ';
    return sentence;
  }
  Status status_;
};

// Makes an Error. Example: throw error("{}: line {} has no z; give three numbers", file, line);
template <typename... Args>
[[nodiscard]] Error error(fmt::format_string<Args...> format, Args&&... args) {
  return Error(fmt::format(format, std::forward<Args>(args)...));
}

// Makes an Error about a wrong argument or setting; its exit status is 2.
template <typename... Args>
[[nodiscard]] Error usageError(fmt::format_string<Args...> format, Args&&... args) {
  return Error(fmt::format(format, std::forward<Args>(args)...), Error::Status::Usage);
}

// Throws usageError(format, args) unless the condition holds. A function calls require() to check
// its arguments, before it changes anything.
template <typename... Args>
void require(bool condition, fmt::format_string<Args...> format, Args&&... args) {
  if (!condition) [[unlikely]]
    throw usageError(format, std::forward<Args>(args)...);
}

}  // namespace resect
