// Scores recorded attempts, and writes the reports about an attempt and about a class. The work is
// done in a separate process, which runs this program's own commands `report` and `class`.
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
#include "skills/score/verdict.h"

namespace resect {

// A fault in an attempt; the fields mean the same as in Deduction (skills/score/verdict.h).
struct Evidence {
  std::optional<double> time;  // s from the start of the recording
  QString fact, question, next;
};

struct AttemptResult {
  bool passed = false, graded = true;
  QString reason;
  double score = 0;  // 0 to 1
  // Measures of the whole recording, which may end a few frames after the last frame that the
  // window showed.
  std::vector<Measured> measures;
  QStringList good;
  std::vector<Evidence> evidence;
};

class AttemptScorer {
 public:
  ~AttemptScorer();

  struct Attempt {
    std::filesystem::path recording, page, history;
    std::string learner;
    // True: the attempt is graded in any case. False: the learner's first attempt counts as
    // practice if the task says so (Task::familiarisation).
    bool graded = true;
  };
  // Scores the attempt and writes the report about it to `page`. `done` gets the result as soon as
  // it is known. `written` is called when the page has been written. `failed` gets an error
  // message.
  void score(const Attempt& attempt, std::function<void(AttemptResult)> done,
             std::function<void()> written, std::function<void(QString)> failed);
  // Writes the table of a class to `page`, in HTML. names: true: the table shows the learners'
  // names; false: it shows pseudonyms.
  void tabulate(const std::filesystem::path& folder, const std::filesystem::path& page,
                const std::filesystem::path& history, bool names, std::function<void()> written,
                std::function<void(QString)> failed);
  // Stops waiting for the work in progress. The work goes on to its end, but the functions that
  // were given for this work are no longer called. score() and tabulate() call leave() first. If
  // this object is destroyed, the work is started anew in a process that does not depend on this
  // program.
  void leave();

 private:
  void start(const QStringList& arguments, std::function<void()> written,
             std::function<void(QString)> failed);

  std::unique_ptr<QProcess> process_;            // null: none
  std::vector<std::unique_ptr<QProcess>> left_;  // processes that this object no longer waits for
};

AttemptResult resultOf(const Scored& scored);

// Whether both results have the same verdict, for the same reasons.
bool agree(const AttemptResult& a, const AttemptResult& b);

// Reads the result from the output of `resect report --json -`; no value if the output is not
// complete yet.
std::optional<AttemptResult> readResult(const QByteArray& json);

}  // namespace resect
