// Scores recorded attempts, and makes reports of them and of a class, by this program's own
// commands in a process beside the window.
#pragma once

#include <QProcess>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "skills/score/measures.h"

namespace resect {

// One thing that was not as wanted, as Deduction (skills/score/verdict.h).
struct Evidence {
  std::optional<double> time;  // s
  QString fact, question, next;
};

struct AttemptResult {
  bool passed = false, graded = true;
  QString reason;
  double score = 0;  // 0 to 1
  // Of the whole recording, which may go on a few frames after the window's last picture.
  std::vector<Measured> measures;
  QStringList good;
  std::vector<Evidence> evidence;
};

class AttemptScorer {
 public:
  ~AttemptScorer() { cancel(); }

  struct Attempt {
    std::filesystem::path recording, page, history;
    std::string learner;
    bool graded = true;  // even if it is the learner's first
  };
  // `done` gets the result as soon as there is one; `written` is called when the page is there.
  // `failed` gets the sentence of an error. A new call gives up the one before.
  void score(const Attempt& attempt, std::function<void(AttemptResult)> done,
             std::function<void()> written, std::function<void(QString)> failed);
  // The table of a class, as an HTML page.
  void tabulate(const std::filesystem::path& folder, const std::filesystem::path& page,
                const std::filesystem::path& history, bool names, std::function<void()> written,
                std::function<void(QString)> failed);
  void cancel();

 private:
  void start(const QStringList& arguments, std::function<void()> written,
             std::function<void(QString)> failed);

  std::unique_ptr<QProcess> process_;
};

// The result in what `resect report --json -` prints; none if that is not whole yet.
std::optional<AttemptResult> readResult(const QByteArray& json);

}  // namespace resect
