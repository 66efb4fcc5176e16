#include "inventor/reading/iv_reader.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "inventor/init.h"
#include "inventor/reading/iv_guard.h"

namespace resect {
namespace {

// Catches Coin's messages during its lifetime; keeps the first read error.
class ErrorCatcher {
 public:
  ErrorCatcher()
      : readHandler_(SoReadError::getHandlerCallback()),
        readData_(SoReadError::getHandlerData()),
        debugHandler_(SoDebugError::getHandlerCallback()),
        debugData_(SoDebugError::getHandlerData()) {
    SoReadError::setHandlerCallback(keep, this);
    SoDebugError::setHandlerCallback(ignore, nullptr);
  }
  ~ErrorCatcher() {
    SoReadError::setHandlerCallback(readHandler_, readData_);
    SoDebugError::setHandlerCallback(debugHandler_, debugData_);
  }
  ErrorCatcher(const ErrorCatcher&) = delete;
  ErrorCatcher& operator=(const ErrorCatcher&) = delete;

  const std::string& first() const { return first_; }

 private:
  static void keep(const SoError* e, void* data) {
    const std::string text = e->getDebugString().getString();
    // A missing texture changes no surface.
    if (text.find("texture file") != std::string::npos) return;
    auto& first = static_cast<ErrorCatcher*>(data)->first_;
    if (first.empty()) first = text;
  }
  static void ignore(const SoError*, void*) {}

  SoErrorCB* readHandler_;
  void* readData_;
  SoErrorCB* debugHandler_;
  void* debugData_;
  std::string first_;
};

// Reports how far Coin has read.
class WatchedInput : public SoInput {
 public:
  WatchedInput(std::string_view bytes, const std::function<void(double)>& tell)
      : size_(bytes.size()), tell_(tell) {
    setBuffer(bytes.data(), bytes.size());
  }
  using SoInput::read;
  SbBool read(float& number) override {
    count();
    return SoInput::read(number);
  }
  SbBool read(int& number) override {
    count();
    return SoInput::read(number);
  }

 private:
  void count() {
    constexpr int kSeldom = 10'000;
    if (++numbers_ % kSeldom == 0 && tell_)
      tell_(std::min(1.0, double(getNumBytesRead()) / double(size_)));
  }
  std::size_t size_;
  int numbers_ = 0;
  const std::function<void(double)>& tell_;
};

// "Coin read error: <what>\n\tOccurred at line   14 in <file>" as ":14: <what>; <what to do>".
std::string withLine(const std::string& message) {
  std::string what = message.substr(0, message.find('\n'));
  const std::string prefix = "Coin read error: ";
  if (what.starts_with(prefix)) what.erase(0, prefix.size());
  // "Could not find 'x.iv' in any of the following directories ...": there are none for a reader.
  const std::string notFound = "Could not find '";
  const char* advice = "correct it or export the model again";
  if (what.starts_with(notFound)) {
    what = fmt::format("it refers to the file '{}', and no other file is opened",
                       what.substr(notFound.size(), what.find("' in any") - notFound.size()));
    advice = "put all in one file";
  }
  for (char& c : what)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (!what.empty() && (what.back() == '.' || what.back() == ' ')) what.pop_back();
  if (what.size() > 160) what = what.substr(0, 160) + "...";
  std::string line;
  const std::string mark = "ccurred at line";
  if (std::size_t at = message.find(mark); at != std::string::npos) {
    for (at += mark.size(); at < message.size() && message[at] == ' '; ++at) {
    }
    for (; at < message.size() && std::isdigit(static_cast<unsigned char>(message[at])); ++at)
      line += message[at];
  }
  return fmt::format("{}: {}; {}", line.empty() ? "" : ":" + line, what, advice);
}

}  // namespace

Model readInventorFile(const std::string& path, std::string_view bytes, ShapeReading reading,
                       const std::function<void(double share)>& tell) {
  if (!isInventorFile(bytes))
    throw error(
        "{}: does not begin with '#Inventor V2.1 ascii' or another Inventor or VRML header; "
        "choose an Inventor file",
        path);
  guardInventorFile(path, bytes);
  initInventor();
  ErrorCatcher catcher;
  WatchedInput input(bytes, tell);
  if (!input.isValidBuffer())
    throw error("{}: '{}' is no version that Coin reads; save it as Inventor V2.1", path,
                inventorFormat(bytes));
  SoSeparator* root = SoDB::readAll(&input);
  if (root) root->ref();
  Model model;
  model.path = path;
  model.format = inventorFormat(bytes);
  try {
    if (!catcher.first().empty()) throw error("{}{}", path, withLine(catcher.first()));
    if (!root) throw error("{}: not readable as {}; export it again", path, model.format);
    addScene(root, reading, model);
  } catch (...) {
    if (root) root->unref();
    throw;
  }
  root->unref();
  return model;
}

}  // namespace resect
