#include "app/organ_loader.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QDir>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "base/progress.h"
#include "inventor/model_file.h"
#include "io/assimp_file.h"
#include "io/operation_setup.h"
#include "operation/room.h"
#include "tools/registry.h"

namespace resect {
namespace {

constexpr const char* kPrefix = "resect: error: ";

std::string sentenceOf(QProcess& process) {
  std::string text = process.readAllStandardError().trimmed().toStdString();
  if (text.starts_with(kPrefix)) text.erase(0, std::string_view(kPrefix).size());
  return text.empty() ? "the file's reader ended without a word; try another file" : text;
}

// Models that this program wrote itself need no guard.
Model readOwnFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return readAssimpFile(path, path, bytes);
}

bool isModelFile(const std::string& file) {
  return !file.empty() && std::filesystem::path(file).extension() != ".dis";
}

}  // namespace

Scenario withAllInstruments(Scenario scenario) {
  for (const ToolKind& kind : toolKinds()) {
    const std::string name(kind.name);
    const bool there = std::any_of(
        scenario.tools.begin(), scenario.tools.end(),
        [&](const ScenarioTool& tool) { return std::filesystem::path(tool.model).stem() == name; });
    if (!there) scenario.tools.push_back({name, {}, {}, {}});
  }
  for (std::size_t i = 0; i < scenario.tools.size(); ++i)
    scenario.tools[i].rest = toolBoxPlace(int(i));
  return scenario;
}

OrganLoader::OrganLoader() {
  QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { poll(); });
  timer_.setInterval(40);
}

OrganLoader::~OrganLoader() { cancel(); }

void OrganLoader::cancel() {
  timer_.stop();
  if (reader_) {
    reader_->kill();
    reader_->waitForFinished(1000);
    reader_.reset();
  }
  cancelled_ = true;
  if (thread_.joinable()) thread_.join();
  if (!converted_.empty()) {
    std::error_code ignored;
    std::filesystem::remove(converted_, ignored);
    converted_.clear();
  }
}

void OrganLoader::load(const Scenario& scenario, std::function<void(double)> progress,
                       std::function<void(Result)> done) {
  cancel();
  scenario_ = withAllInstruments(scenario);
  progress_ = std::move(progress);
  done_ = std::move(done);
  cancelled_ = false;
  built_ = false;
  share_ = -1;
  organ_.reset();
  result_ = {};
  result_.scenario = scenario_;
  if (isModelFile(scenario_.organ.file)) {
    converted_ =
        QDir::temp()
            .filePath(QString("resect-%1-organ.ply").arg(QCoreApplication::applicationPid()))
            .toStdString();
    QStringList arguments{"convert", QString::fromStdString(scenario_.organ.file),
                          QString::fromStdString(converted_), "--unit",
                          QString::number(scenario_.organ.unit, 'g', 17)};
    if (!scenario_.organ.part.empty())
      arguments << "--part" << QString::fromStdString(scenario_.organ.part);
    if (scenario_.organ.repair) arguments << "--repair";
    reader_ = std::make_unique<QProcess>();
    reader_->start(QCoreApplication::applicationFilePath(), arguments);
  } else {
    buildCells("");
  }
  timer_.start();
}

void OrganLoader::buildCells(const std::string& convertedFile) {
  thread_ = std::thread([this, convertedFile] {
    try {
      OrganSource source = scenario_.organ;
      if (!convertedFile.empty()) {
        source.file = convertedFile;
        source.part.clear();
        source.unit = 1;
      }
      Discretization cells = loadCells(
          source, readOwnFile,
          [this](double share) {
            share_ = share;
            return !cancelled_;
          },
          &result_.notes);
      organ_.emplace(makeOrgan(std::move(cells), source.settings));
      tissue_ = makeTissue(scenario_.tissue, *organ_);
    } catch (const Cancelled&) {
      result_.problem = "cancelled";
    } catch (const std::exception& e) {
      result_.problem = e.what();
    }
    built_ = true;
  });
}

void OrganLoader::poll() {
  if (reader_) {
    if (reader_->state() != QProcess::NotRunning) return progress_(-1);
    const bool fine = reader_->exitStatus() == QProcess::NormalExit && reader_->exitCode() == 0;
    if (!fine) result_.problem = sentenceOf(*reader_);
    reader_.reset();
    if (fine) return buildCells(converted_);
    built_ = true;
  }
  if (!built_) return progress_(share_);
  timer_.stop();
  if (thread_.joinable()) thread_.join();
  if (!converted_.empty()) {
    std::error_code ignored;
    std::filesystem::remove(converted_, ignored);
    converted_.clear();
  }
  if (organ_) try {
      // Here and not in the thread: Inventor, which reads the tools, belongs to the window's
      // thread.
      result_.simulation =
          std::make_unique<Simulation>(std::move(*organ_), loadTools(scenario_, &readModel),
                                       std::move(tissue_), scenario_.table);
    } catch (const std::exception& e) {
      result_.problem = e.what();
    }
  organ_.reset();
  done_(std::move(result_));
}

void FileExaminer::cancel() {
  if (!process_) return;
  process_->disconnect();
  process_->kill();
  process_->waitForFinished(1000);
  process_.reset();
}

void FileExaminer::examine(
    const std::string& file,
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
  process->start(QCoreApplication::applicationFilePath(),
                 {"info", "--json", QString::fromStdString(file)});
}

}  // namespace resect
