#include "app/loading/organ_loader.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>
#include <QJsonValue>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/progress.h"
#include "base/stop.h"
#include "inventor/reading/model_file.h"
#include "io/cells/particle_file.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "operation/room.h"
#include "operation/way/place_ways.h"
#include "tools/registry.h"

namespace resect {
namespace {

constexpr const char* kPrefix = "resect: error: ";

std::string sentenceOf(QProcess& process) {
  std::string text = process.readAllStandardError().trimmed().toStdString();
  if (text.starts_with(kPrefix)) text.erase(0, std::string_view(kPrefix).size());
  return text.empty() ? "the file's reader ended without a word; try another file" : text;
}

// As the reader's JSON says.
int holesClosed(QProcess& process) {
  return QJsonDocument::fromJson(process.readAllStandardOutput())["holes_closed"].toInt();
}

void addParts(const std::string& part, QStringList& arguments) {
  for (const std::string& name : partNames(part))
    arguments << "--part=" + QString::fromStdString(name);
}

// Writes a .ply in the file's own numbers, so that a doubt about its size names its unit.
QStringList convertArguments(const std::string& file, const std::string& part,
                             const std::string& ply) {
  QStringList arguments{"convert", QString::fromStdString(file), QString::fromStdString(ply)};
  addParts(part, arguments);
  return arguments;
}

bool isModelFile(const OrganSource& source) {
  return !isBuiltIn(source) && !isParticleFile(source.file);
}

}  // namespace

TissueSetup besideDrawing(TissueSetup setup) {
  if (setup.settings.threads == 0)
    setup.settings.threads = std::max(1, int(std::thread::hardware_concurrency()) / 2);
  return setup;
}

Scenario withInstruments(Scenario scenario) {
  const bool any = !scenario.tools.empty();
  // A file of cells may hold vessels.
  const bool bleeds = std::ranges::any_of(scenario.organs, [](const ScenarioOrgan& organ) {
    const OrganSource& source = organ.source;
    return !source.vessels.empty() || isCellsFile(source.file) ||
           std::ranges::any_of(source.structures, [](const BroughtStructure& one) {
             return vesselKind(one.kind).has_value();
           });
  });
  for (const ToolKind& kind : toolKinds()) {
    if (any || (kind.stopsBleeding && !bleeds)) continue;
    scenario.tools.push_back({std::string(kind.name), {}, {}, {}});
  }
  for (std::size_t i = 0; i < scenario.tools.size(); ++i)
    scenario.tools[i].rest = toolBoxPlace(int(i));
  return scenario;
}

// Cells, surface and tissue of an organ, made in a thread of its own.
struct OrganLoader::Job {
  Scenario scenario;
  Scenario wanted;  // the same with files replaced by those that readers wrote
  std::vector<std::string> notes;
  std::string problem;
  std::vector<OperatedOrgan> organs;
  std::vector<TissueJoint> joints;
  std::unique_ptr<Simulation> simulation;  // made of these
  std::atomic<double> share{-1};
  std::atomic<bool> cancelled{false}, built{false};
  std::thread thread;

  ~Job() {
    cancelled = true;
    if (thread.joinable()) thread.join();
  }
  void start() {
    thread = std::thread([this] { build(); });
  }
  // Places the ways of instruments on the tissue as it lies when they come, in the thread again.
  void startSettling() {
    thread.join();
    built = false;
    thread = std::thread([this] {
      const StopBy stop(cancelled);
      try {
        settleWays(scenario, *simulation);
      } catch (const Cancelled&) {
        problem = "cancelled";
      } catch (const std::exception& e) {
        problem = e.what();
      }
      built = true;
    });
  }
  void build() {
    const StopBy stop(cancelled);
    try {
      organs = loadOrgans(
          wanted, readPlainMesh,
          [this](double now) {
            share = now;
            return !cancelled;
          },
          &notes);
      scenario.tools = wanted.tools;  // whose ways now lie on the organs
      scenario.duration = wanted.duration;
      share = -1;  // joints take time too
      joints = makeJoints(wanted, organs);
    } catch (const Cancelled&) {
      problem = "cancelled";
    } catch (const std::exception& e) {
      problem = withOwnNames(e.what());
    }
    for (std::string& note : notes) note = withOwnNames(std::move(note));
    built = true;
  }
  // A sentence about a file that a reader wrote, as one about the person's own file.
  std::string withOwnNames(std::string sentence) const {
    const auto rename = [&](const std::string& written, const std::string& own) {
      if (const std::size_t at = sentence.find(written); at != sentence.npos && written != own)
        sentence.replace(at, written.size(), own);
    };
    for (std::size_t i = 0; i < wanted.organs.size(); ++i) {
      const OrganSource& written = wanted.organs[i].source;
      const OrganSource& own = scenario.organs[i].source;
      rename(written.file, own.file);
      for (std::size_t k = 0; k < own.structures.size(); ++k)
        rename(written.structures[k].file, own.structures[k].file);
    }
    return sentence;
  }
};

OrganLoader::OrganLoader() {
  QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { poll(); });
  timer_.setInterval(40);
}

OrganLoader::~OrganLoader() { cancel(); }

void OrganLoader::cancel() {
  timer_.stop();
  done_ = {};
  if (reader_) {
    reader_->kill();
    reader_->waitForFinished(1000);
    reader_.reset();
  }
  // Its thread notices at its next check; nobody waits for it.
  if (job_) {
    job_->cancelled = true;
    givenUp_.push_back(std::move(job_));
  }
  std::erase_if(givenUp_, [](const auto& job) { return !job->thread.joinable() || job->built; });
  removeConverted();
}

void OrganLoader::removeConverted() {
  std::error_code ignored;
  for (const std::string& file : converted_) std::filesystem::remove(file, ignored);
  converted_.clear();
}

void OrganLoader::load(const Scenario& scenario, std::function<void(double)> progress,
                       std::function<void(Result)> done) {
  cancel();
  progress_ = std::move(progress);
  done_ = std::move(done);
  job_ = std::make_unique<Job>();
  job_->scenario = withInstruments(scenario);
  if (!scenario.task) offerBreathing(job_->scenario);  // for View > Breathing
  job_->wanted = job_->scenario;
  toRead_.clear();
  for (ScenarioOrgan& organ : job_->wanted.organs) {
    organ.tissue = besideDrawing(organ.tissue);
    OrganSource& source = organ.source;
    if (isModelFile(source)) toRead_.push_back({&source.file, &source.part, source.repair});
    for (BroughtStructure& one : source.structures) toRead_.push_back({&one.file, &one.part});
  }
  next_ = 0;
  readNext();
  timer_.start();
}

void OrganLoader::readNext() {
  if (next_ == toRead_.size()) return job_->start();
  const ModelToRead& model = toRead_[next_];
  converted_.push_back(QDir::temp()
                           .filePath(QString("resect-%1-organ-%2.ply")
                                         .arg(QCoreApplication::applicationPid())
                                         .arg(++files_))
                           .toStdString());
  QStringList arguments = convertArguments(*model.file, *model.part, converted_.back());
  if (model.repair) arguments << "--repair";
  arguments << "--json";
  reader_ = std::make_unique<QProcess>();
  reader_->start(QCoreApplication::applicationFilePath(), arguments);
}

void OrganLoader::poll() {
  if (reader_) {
    if (reader_->state() != QProcess::NotRunning) return progress_(-1);
    const bool fine = reader_->exitStatus() == QProcess::NormalExit && reader_->exitCode() == 0;
    if (!fine) job_->problem = sentenceOf(*reader_);
    const int holes = holesClosed(*reader_);
    reader_.reset();
    if (fine) {
      const ModelToRead& model = toRead_[next_++];
      if (holes > 0)
        job_->notes.push_back(fmt::format("{}: {} hole{} closed", *model.file, holes,
                                          holes == 1 ? " was" : "s were"));
      *model.file = converted_.back();
      model.part->clear();
      return readNext();
    }
    job_->built = true;
  }
  if (!job_->built) return progress_(job_->share);
  if (!job_->organs.empty() && !job_->simulation && job_->problem.empty()) {
    try {
      // Here, not in the thread: tools are read by Inventor, which only the window's thread may
      // use.
      job_->simulation = std::make_unique<Simulation>(
          assemble(job_->scenario, std::move(job_->organs), std::move(job_->joints),
                   loadTools(job_->scenario, &readModel), &job_->notes));
      if (hasWays(job_->scenario) && job_->simulation->moves()) return job_->startSettling();
    } catch (const std::exception& e) {
      job_->problem = e.what();
    }
  }
  timer_.stop();
  const std::unique_ptr<Job> job = std::move(job_);
  if (job->thread.joinable()) job->thread.join();
  removeConverted();
  Result result{job->scenario, nullptr, std::move(job->notes), std::move(job->problem)};
  if (result.problem.empty()) result.simulation = std::move(job->simulation);
  if (result.simulation) noteSlowFrames(*result.simulation, job->scenario, &result.notes);
  std::exchange(done_, {})(std::move(result));
}

void FileExaminer::cancel() {
  if (!process_) return;
  process_->disconnect();
  process_->kill();
  process_->waitForFinished(1000);
  process_.reset();
}

void FileExaminer::start(
    const QStringList& arguments,
    const std::function<void(const std::string& json, const std::string& problem)>& done) {
  cancel();
  process_ = std::make_unique<QProcess>();
  QProcess* process = process_.get();
  QObject::connect(process, &QProcess::finished, process,
                   [process, done](int code, QProcess::ExitStatus status) {
                     if (status == QProcess::NormalExit && code == 0)
                       done(process->readAllStandardOutput().toStdString(), "");
                     else
                       done("", sentenceOf(*process));
                   });
  process->start(QCoreApplication::applicationFilePath(), arguments);
}

void FileExaminer::examine(
    const std::string& file, const std::string& part, const std::string& slices,
    const std::function<void(const std::string& json, const std::string& problem)>& done) {
  QStringList arguments{"info", "--json", QString::fromStdString(file)};
  addParts(part, arguments);
  if (!slices.empty()) arguments << "--slices=" + QString::fromStdString(slices);
  start(arguments, done);
}

void FileExaminer::writeSurface(const std::string& file, const std::string& part,
                                const std::string& ply,
                                const std::function<void(const std::string& problem)>& done) {
  start(convertArguments(file, part, ply),
        [done](const std::string&, const std::string& problem) { done(problem); });
}

}  // namespace resect
