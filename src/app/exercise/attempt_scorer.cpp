#include "app/exercise/attempt_scorer.h"

#include <unistd.h>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace resect {
namespace {

QString named(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

std::optional<AttemptResult> readResult(const QByteArray& json) {
  const QJsonArray all = QJsonDocument::fromJson(json).array();
  if (all.isEmpty()) return {};
  const QJsonObject last = all.last().toObject();
  AttemptResult result;
  result.passed = last["passed"].toBool();
  result.graded = last["graded"].toBool();
  result.reason = last["reason"].toString();
  result.score = last["score"].toDouble();
  const QJsonObject whole = last["measures"].toObject()["whole"].toObject();
  for (auto one = whole.begin(); one != whole.end(); ++one)
    if (one->isDouble()) result.measures.push_back({one.key().toStdString(), {}, one->toDouble()});
  for (const QJsonValue& one : last["good"].toArray()) result.good << one.toString();
  for (const QJsonValue& one : last["deductions"].toArray()) {
    const QJsonObject d = one.toObject();
    Evidence evidence{{}, d["fact"].toString(), d["question"].toString(), d["next"].toString()};
    if (d["time_s"].isDouble()) evidence.time = d["time_s"].toDouble();
    result.evidence.push_back(evidence);
  }
  return result;
}

AttemptResult resultOf(const Scored& scored) {
  const Verdict& verdict = scored.verdict;
  AttemptResult result{verdict.passed,
                       verdict.graded,
                       QString::fromStdString(verdict.reason),
                       verdict.score,
                       {},
                       {},
                       {}};
  for (const Measured& one : scored.measures)
    if (one.instrument.empty()) result.measures.push_back(one);
  for (const std::string& one : verdict.good) result.good << QString::fromStdString(one);
  for (const Deduction& one : verdict.deductions)
    result.evidence.push_back({one.time, QString::fromStdString(one.fact),
                               QString::fromStdString(one.question),
                               QString::fromStdString(one.next)});
  return result;
}

bool agree(const AttemptResult& a, const AttemptResult& b) {
  constexpr double kSame = 0.02;  // s, and a score: files have six significant digits
  const auto sameFault = [](const Evidence& x, const Evidence& y) {
    return x.fact == y.fact && x.question == y.question && x.next == y.next &&
           std::abs(x.time.value_or(-1) - y.time.value_or(-1)) < kSame;
  };
  return a.passed == b.passed && a.graded == b.graded && a.reason == b.reason &&
         std::abs(a.score - b.score) < kSame && a.good == b.good &&
         std::ranges::equal(a.evidence, b.evidence, sameFault);
}

AttemptScorer::~AttemptScorer() {
  leave();
  for (const auto& process : left_) {
    if (process->state() == QProcess::NotRunning) continue;
    process->kill();
    process->waitForFinished(2000);
    // What nobody hears of any more is done after the window has closed.
    QStringList arguments = process->arguments();
    if (const auto json = arguments.indexOf("--json"); json >= 0) arguments.remove(json, 2);
    QProcess alone;
    alone.setProgram(process->program());
    alone.setArguments(arguments);
    alone.setStandardOutputFile(QProcess::nullDevice());
    alone.setStandardErrorFile(QProcess::nullDevice());
    alone.startDetached();
  }
}

void AttemptScorer::leave() {
  std::erase_if(left_, [](const auto& one) { return one->state() == QProcess::NotRunning; });
  if (!process_) return;
  process_->disconnect();
  left_.push_back(std::move(process_));
}

void AttemptScorer::start(const QStringList& arguments, std::function<void()> written,
                          std::function<void(QString)> failed) {
  QObject::connect(
      process_.get(), &QProcess::finished, process_.get(),
      [process = process_.get(), written, failed](int status, QProcess::ExitStatus how) {
        if (how == QProcess::NormalExit && status == 0) return written();
        const QString said = process->readAllStandardError().trimmed();
        failed(said.isEmpty() ? "The attempt could not be scored." : said);
      });
  process_->setChildProcessModifier([] { ::nice(10); });  // the next exercise may have begun
  process_->start(QCoreApplication::applicationFilePath(), arguments);
}

void AttemptScorer::score(const Attempt& attempt, std::function<void(AttemptResult)> done,
                          std::function<void()> written, std::function<void(QString)> failed) {
  leave();
  process_ = std::make_unique<QProcess>();
  auto got = std::make_shared<QByteArray>();
  auto told = std::make_shared<bool>(false);
  QObject::connect(process_.get(), &QProcess::readyReadStandardOutput, process_.get(),
                   [process = process_.get(), got, told, done] {
                     got->append(process->readAllStandardOutput());
                     const auto result = *told ? std::nullopt : readResult(*got);
                     if (!result) return;
                     *told = true;
                     done(*result);
                   });
  QStringList arguments{"report",    named(attempt.recording),
                        "--json",    "-",
                        "-o",        named(attempt.page),
                        "--history", named(attempt.history),
                        "--learner", QString::fromStdString(attempt.learner)};
  if (attempt.graded) arguments << "--graded";
  start(arguments, std::move(written), std::move(failed));
}

void AttemptScorer::tabulate(const std::filesystem::path& folder, const std::filesystem::path& page,
                             const std::filesystem::path& history, bool names,
                             std::function<void()> written, std::function<void(QString)> failed) {
  leave();
  process_ = std::make_unique<QProcess>();
  QStringList arguments{"class", named(folder), "-o", named(page), "--history", named(history)};
  if (names) arguments << "--names";
  start(arguments, std::move(written), std::move(failed));
}

}  // namespace resect
