// The teacher's side of the main window: an exercise is made from what is on the screen, tried, and
// saved.
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <QDockWidget>
#include <QImage>
#include <QPixmap>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>
#include <cctype>

#include "app/exercise/exercises_page.h"
#include "app/exercise/task_maker_panel.h"
#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/panels.h"
#include "base/error.h"
#include "inventor/gl/vectors.h"
#include "io/output/atomic_file.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/task_writer.h"
#include "io/whole_file.h"
#include "organ/region_placer.h"
#include "record/recorded_motions.h"
#include "record/session_recordings.h"
#include "skills/attempt/goal_places.h"
#include "skills/score/bands.h"
#include "skills/score/goal_result.h"
#include "tools/rest_place.h"

namespace resect {
namespace {

using Kind = TaskGoal::Kind;

// Exercises that are being tried.
std::filesystem::path draftsFolder() { return recordingsFolder().parent_path() / "drafts"; }

// "My exercise!" as part of a file's name: "my-exercise".
std::string fileName(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto code = static_cast<unsigned char>(c);
    if (std::isalnum(code))
      name += char(std::tolower(code));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "exercise" : name.substr(0, 60);
}

Vec3 inBox(const Aabb& box, const Vec3& p) { return (p - box.min).cwiseQuotient(box.size()); }

// Gives the scenario's instruments the motions that those of the same models have in a recording.
void takeMotions(Scenario& scenario, const std::filesystem::path& recording) {
  RecordingFile file = RecordingFile::open(recording);
  const Scenario recorded = file.setup().scenario;
  std::vector<std::vector<ToolKey>> motions = recordedMotions(file, file.moment());
  auto tool = scenario.tools.begin();  // the recording lacks some of them, in the same order
  for (std::size_t t = 0; t < motions.size(); ++t) {
    tool = std::find_if(tool, scenario.tools.end(), [&](const ScenarioTool& one) {
      return modelOf(one) == modelOf(recorded.tools[t]);
    });
    if (tool == scenario.tools.end()) return;
    (tool++)->keys = std::move(motions[t]);
  }
}

}  // namespace

bool MainWindow::isDraft() const {
  return session_ &&
         std::filesystem::path(session_->scenario().file).parent_path() == draftsFolder();
}

void MainWindow::makeMaker() {
  maker_->markingWanted = [this](bool on) {
    marking_ = on;
    on ? viewer_->setCursor(Qt::CrossCursor) : viewer_->unsetCursor();
    viewer_->setFocus();
  };
  maker_->goalChanged = [this] {
    marking_ = false;
    forgetTries();
    setMadeMarks({});
  };
  maker_->lastMarkRemoved = [this] {
    forgetTries();
    std::vector<MadeMark> marks = madeMarks_;
    if (!marks.empty()) marks.pop_back();
    setMadeMarks(std::move(marks));
  };
  maker_->tried = [this] { tryMade(); };
  maker_->saved = [this] { saveMade(); };
  maker_->closed = [this] { closeMaker(); };
}

// Begins to make an exercise of the operation that is on the screen.
void MainWindow::openMaker() {
  if (!session_) return;
  if (session_->scenario().file.empty() || !madeFrom_.empty())
    return complain(
        "An exercise is made from a scenario; open one first, for this operation comes from a "
        "recording.");
  if (attempt_) endExerciseUnscored();
  hideExercises();
  made_ = session_->scenario();
  try {  // all its instruments, also those that its own task does not allow
    made_.tools = readScenario(made_.file).tools;
  } catch (const std::exception& e) {
    return complain(e.what());
  }
  made_ = withInstruments(std::move(made_));
  for (ScenarioTool& tool : made_.tools) tool.keys.clear(), tool.way.reset();
  forgetTries();
  std::vector<std::string> instruments, structures;
  for (const ScenarioTool& tool : made_.tools) instruments.push_back(modelOf(tool));
  const OrganSource& organ = made_.organs[0].source;
  for (const OrganLabel& label : organ.labels)
    if (!label.name.empty()) structures.push_back(label.name);
  maker_->begin(instruments, structures, !organ.vessels.empty());
  setMadeMarks({});
  makerDock_->show();
  showMaker();
}

// Brings the maker's panel before that of the exercise.
void MainWindow::showMaker() {
  setMadeMarks(madeMarks_);
  for (QDockWidget* panel : traineePanels_) panel->hide();
  QTimer::singleShot(0, this, [this] {
    arrangePanels();
    makerDock_->raise();
  });
  if (options_.reports)
    QTimer::singleShot(300, this, [this] {
      reportButtons(maker_);
      say("maker shown");
    });
}

void MainWindow::closeMaker() {
  setMadeMarks({});
  makerDock_->hide();
  for (QDockWidget* panel : traineePanels_) panel->show();
  QTimer::singleShot(0, this, [this] { arrangePanels(); });
}

void MainWindow::setMadeMarks(std::vector<MadeMark> marks) {
  madeMarks_ = std::move(marks);
  marking_ = marking_ && madeMarks_.size() < maker_->placesWanted().second;
  if (!marking_) viewer_->unsetCursor();
  maker_->setMarks(madeMarks_.size(), marking_);
  if (!session_ || exercising()) return;
  const TaskGoal goal = goalMade();
  Guide guide;
  guide.radius = goal.radius;
  for (const MadeMark& mark : madeMarks_) guide.places.push_back(mark.seen);
  if (goal.kind == Kind::Follow) guide.kind = Guide::Kind::Line;
  if (goal.kind == Kind::Transect && madeMarks_.size() == 2) {
    guide.kind = Guide::Kind::Plane;
    guide.normal = goal.normal;
    guide.box = session_->cells().lattice.box().padded(0.005);
  }
  if (goal.kind == Kind::Resect && !madeMarks_.empty()) {
    guide.kind = Guide::Kind::Ball;
    guide.places[0] -= maker_->structureDepth() * madeMarks_[0].normal;
    guide.radius = maker_->structureRadius();
    guide.margin = goal.margin;
  }
  session_->setGuide(guide.places.empty() ? std::nullopt : std::optional(guide));
}

// A click on the organ, while places are marked.
void MainWindow::markPlace(const SbVec2s& pixel, const SbViewportRegion& viewport) {
  const auto under = session_->pointUnder(pixel, viewport);
  std::optional<MadeMark> mark;
  if (under)
    session_->operation().look([&](const Simulation& simulation) {
      const OperatedOrgan& organ = simulation.organs()[0];
      const auto rest = restPlace(organ.organ, *organ.tissue, under->point);
      if (!rest) return;
      mark = MadeMark{*rest, under->point, under->normal, {}};
      if (maker_->kind() == Kind::Divide) mark->vessel = vesselNear(organ.organ, *rest);
    });
  if (!mark) {
    statusBar()->showMessage(Words::tr("Click on the organ"), 4000);
    return;
  }
  if (maker_->kind() == Kind::Divide && !mark->vessel)
    return complain("No vessel of 2 mm or more lies within 3 cm of this place; click elsewhere.");
  SbVec3f away;
  session_->room().camera()->orientation.getValue().multVec(SbVec3f(0, 0, -1), away);
  mark->view = toVec(away);
  forgetTries();
  std::vector<MadeMark> marks = madeMarks_;
  marks.push_back(*mark);
  setMadeMarks(std::move(marks));
  if (options_.reports) say("marked {}", madeMarks_.size());
}

// The goal of the fields and marks.
TaskGoal MainWindow::goalMade() const {
  TaskGoal goal = maker_->task().goal;
  goal.organ = made_.organs[0].source.name;
  const Aabb box = particleBox(session_->cells());
  for (const MadeMark& mark : madeMarks_) {
    TaskPlace place;
    place.place = inBox(box, mark.vessel ? mark.vessel->place : mark.rest);
    if (goal.kind == Kind::Touch || goal.kind == Kind::Follow) place.depth = 0;
    goal.places.push_back(place);
    if (mark.vessel) goal.vessel = mark.vessel->kind, goal.thinnest = 0.9 * mark.vessel->diameter;
  }
  if (goal.kind == Kind::Transect && madeMarks_.size() == 2) {
    const Vec3 normal = (madeMarks_[1].rest - madeMarks_[0].rest).cross(madeMarks_[1].view);
    goal.normal = normal.norm() > 1e-9 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitX());
    goal.places.resize(1);
  }
  if (goal.kind == Kind::Resect) goal.places.clear();
  return goal;
}

// The exercise as it is now, written to a file of drafts and read again, which checks it.
Scenario MainWindow::exerciseMade() {
  Scenario scenario = made_;
  scenario.title = maker_->title().empty() ? "An exercise" : maker_->title();
  scenario.task = maker_->task();
  scenario.task->goal = goalMade();
  scenario.description = goalSentence(*scenario.task);
  if (const std::vector<std::size_t> references = maker_->references(); !references.empty()) {
    takeMotions(scenario, madeTries_[references.back()].recording);
    std::vector<std::vector<Measured>> runs;
    for (const std::size_t number : references) runs.push_back(madeTries_[number].measures);
    if (maker_->bandWanted()) scenario.task->bands = bandsOf(runs);
    scenario.task->bandRuns = int(runs.size());
  }
  OrganSource& organ = scenario.organs[0].source;
  if (scenario.task->goal.kind == Kind::Resect && maker_->marksStructure() && !madeMarks_.empty()) {
    OrganLabel tumour;
    for (const OrganLabel& label : organ.labels)
      tumour.label = std::max(tumour.label, label.label + 1);
    tumour.name = "tumour";
    for (int n = 2; std::ranges::count(organ.labels, tumour.name, &OrganLabel::name) > 0; ++n)
      tumour.name = "tumour " + std::to_string(n);
    scenario.task->goal.structure = tumour.name;
    tumour.region.shape = Region::Shape::Ball;
    tumour.region.frame = Region::Frame::Organ;
    tumour.region.centre =
        inBox(particleBox(session_->cells()),
              madeMarks_[0].rest - maker_->structureDepth() * madeMarks_[0].normal);
    tumour.region.radius = maker_->structureRadius();
    organ.labels.push_back(tumour);
  }
  std::filesystem::create_directories(draftsFolder());
  const std::filesystem::path draft = draftsFolder() / (fileName(scenario.title) + ".toml");
  const std::string text = exerciseText(scenario);
  writeFileAtomically(draft, [&](std::ostream& out) { out << text; });
  return readScenario(draft);
}

// An attempt at the exercise that is being made has been scored.
void MainWindow::keepTry(const AttemptResult& result) {
  std::filesystem::path recording = page_;
  recording.replace_extension(".resect");
  madeTries_.push_back({recording, result.measures});
  QString words = (result.passed ? Words::tr("Try %1: passed") : Words::tr("Try %1: not passed"))
                      .arg(madeTries_.size());
  if (const auto time = valueOf(result.measures, "total_time_s"))
    words += QString(", %1 s").arg(*time, 0, 'f', 1);
  if (const auto path = valueOf(result.measures, "path_length_m"))
    words += Words::tr(", way %1 m").arg(*path, 0, 'f', 2);
  maker_->addTry(words, result.passed);
}

// They were at another exercise than it is now.
void MainWindow::forgetTries() {
  madeTries_.clear();
  maker_->clearTries();
}

void MainWindow::tryMade() {
  marking_ = false;
  setMadeMarks(madeMarks_);
  try {
    load(exerciseMade());
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

// Beside the file goes a picture for its card: what is on the screen.
void MainWindow::saveMade() {
  try {
    const Scenario scenario = exerciseMade();
    const std::string text = readWholeFile(scenario.file);
    const QImage picture = viewer_->grab().toImage();
    save(Words::tr("Save exercise"), Words::tr("Exercises (*.toml)"),
         QString::fromStdString(fileName(scenario.title) + ".toml"), [&](const std::string& file) {
           std::filesystem::path image = file;
           image.replace_extension(".png");
           writeFileAtomically(file, [&](std::ostream& out) { out << text; });
           picture.scaledToWidth(640, Qt::SmoothTransformation)
               .save(QString::fromStdString(image.string()));
           addExercise(file);
         });
  } catch (const std::exception& e) {
    complain(e.what());
  }
}

}  // namespace resect
