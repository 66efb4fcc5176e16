// The main window: picture, panels, menus, and the operating session that they show.
#pragma once

#include <QMainWindow>
#include <memory>

#include "app/advice/haemostasis_watch.h"
#include "app/exercise/attempt_scorer.h"
#include "app/exercise/exercise_list.h"
#include "app/loading/operation_loader.h"
#include "app/loading/organ_loader.h"
#include "app/sound/speaker.h"
#include "app/space_mouse.h"
#include "app/widgets/instruments_panel.h"
#include "app/window.h"
#include "formats/video.h"
#include "inventor/hand/operating_session.h"
#include "record/recorder.h"
#include "skills/attempt/goal_places.h"
#include "skills/live/live_attempt.h"

class QAction;
class QDockWidget;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;

namespace resect {

class Banner;
class ControlsOverlay;
class ExercisePanel;
class ExercisesPage;
class ForcePanel;
class HintBar;
class OperationPanel;
class OrganPanel;
class TaskMakerPanel;
class RemovedPanel;
class TimelinePanel;
class TimingPanel;
class Viewer;

// A place that a teacher has marked on the organ.
struct MadeMark {
  Vec3 rest, seen;                    // the place in rest space; the same place in the world; m
  Vec3 normal;                        // normal of the surface at this place, unit
  std::optional<VesselPlace> vessel;  // the vessel to be divided at this place
  Vec3 view = Vec3::UnitZ();          // camera's direction when the mark was made, unit
};

// A teacher's own attempt at the exercise that is being made.
struct MadeTry {
  std::filesystem::path recording;
  std::vector<Measured> measures;
};

class MainWindow : public QMainWindow {
 public:
  explicit MainWindow(const WindowOptions& options);
  ~MainWindow() override;

  bool load(const Scenario& scenario);  // false: the user keeps the present operation
  // Shows a sentence over the picture until the user clicks it, another sentence replaces it, or
  // holds() is false. Without holds(), the sentence disappears 8 s after the user's next input
  // elsewhere.
  void complain(const std::string& sentence, std::function<bool()> holds = {});
  // Plays the scenario's motions up to the scenario time `until`, s. Begins where the last call
  // ended. If the motions are over or were stopped, begins at their start.
  void play(double until);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static constexpr double kVideoRate = 25;  // pictures per second

  QAction* add(QMenu* menu, const QString& text, const QKeySequence& key, const QString& tip,
               const std::function<void()>& act);
  void makeMenus();
  void makeScenarioMenu(QMenu* file);
  void makeViewMenu();
  void addLampMenu(QMenu* view);
  bool keyOnExercises(QKeyEvent* event, bool onPage);
  void listInstruments();
  void makeDocks();
  void beginAgain(std::optional<double> spacing, int refine, bool elastic);
  void showLaboratory(bool shown);
  void arrangePanels();
  bool hasMotions() const;  // whether the scenario moves any tool
  QString nextStep() const;
  void keepTime();
  void sayWhatIsClosed(const LiveState& state);
  void sayHowThePatientIs(const LiveState& state);
  void sayWhatHolds();
  void tell(const QString& sentence);
  void followPanels(const LiveState& state, qint64 now);
  bool begin(OrganLoader::Result result);  // false: cannot be shown; the user was told
  std::shared_ptr<Recorder> record(const OrganLoader::Result& result);
  // anew: the operation starts again from its beginning, and the recorded work is not repeated.
  void openOperation(const QString& file, bool anew = false);
  // Whether the operation may be discarded: nothing would be lost, or the user agrees.
  bool mayEnd();
  void saveOperation(bool elsewhere);
  void writeOperation(const std::string& file);
  void noteRecording();
  void listRecordings();
  void makeTimelineMenu();
  void compareBranches();
  void showProgress(double share, const QString& what);
  void loadDefault();
  void loadInstead(Scenario scenario);
  void cancelLoading();
  void tick();
  void film(qint64 now);  // now: ms since 1970
  void listenToScript();
  void writeScene(const std::string& file);
  // Throws Error if the operation has read this file, or will read it again.
  void checkWritten(const std::string& file) const;
  void openFile(const QString& file);
  void askOrgan(const QString& file);
  void remember(const QString& file);
  void fillRecent();
  void saveSurface();
  void saveScene();
  void savePicture();
  void toggleVideo();
  bool viewerEvent(const SoEvent& event, const SbViewportRegion& viewport);
  void undo(bool again);
  QString heldName() const;
  void look(RoomView view);
  void viewAll();
  void zoom(double factor);
  void switchThesis(bool on);
  void bringEverythingBack();
  void makeExercises();
  void showExercises();
  void hideExercises();
  void showAbout(const Exercise& exercise);
  void startExercise(const Exercise& exercise, TaskLevel level);
  void beginExercise();
  void followExercise(const LiveState& state);
  void guideHand(const AttemptProgress& progress);
  void endExercise(const std::string& why, std::optional<double> end = {});
  void showResult(const AttemptResult& result);
  std::optional<AttemptResult> resultNow(const AttemptScorer::Attempt& attempt);
  void replayFrom(double seconds);
  void nextExercise();
  void chooseAttemptsFolder();
  void tabulateClass(bool names);
  void openPage(const std::filesystem::path& page);
  std::filesystem::path attemptsFolder() const;
  std::string learner() const;
  // exercising(): whether an exercise is in progress. refusesGoingBack(): whether the exercise
  // forbids going back to an earlier moment; if it does, the user is told.
  bool exercising() const { return attempt_ && !attemptEnded_; }
  bool refusesGoingBack();
  void endExerciseUnscored();
  void makeMaker();
  void openMaker();
  void showMaker();
  void closeMaker();
  void setMadeMarks(std::vector<MadeMark> marks);
  void markPlace(const SbVec2s& pixel, const SbViewportRegion& viewport);
  TaskGoal goalMade() const;
  Scenario exerciseMade();
  void tryMade();
  void saveMade();
  void keepTry(const AttemptResult& result);
  void forgetTries();
  bool isDraft() const;  // whether the exercise on the screen is still being made
  void reportPlaces();
  void reportButtons(const QWidget* in);
  void reportCutText();
  void reportPace();
  void reportMoment();
  void resizePicture(const std::string& text);
  void placeOverlays();
  // Asks the user for a file name and calls `write` with it. If `write` throws, the user sees the
  // exception's text.
  void save(const QString& title, const QString& filter, const QString& name,
            const std::function<void(const std::string&)>& write);

  WindowOptions options_;
  std::shared_ptr<Recorder> recorder_;  // recorder of the present operation; null: none
  std::unique_ptr<OperatingSession> session_;
  OrganLoader loader_;
  OperationLoader operations_;
  SpaceMouse spaceMouse_;
  Viewer* viewer_;
  ControlsOverlay* overlay_;
  Banner* complaint_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel *recording_, *notRecorded_;
  QMenu *recent_, *recordings_;
  QAction *undo_, *redo_, *recordingOn_;
  LampPlace lampPlace_ = LampPlace::PatientsRight;
  QAction *breathing_, *dark_, *field_, *hands_, *laboratory_, *marks_, *scale_, *thesis_;
  HintBar* hint_;
  OperationPanel* operation_;
  QList<QDockWidget*> traineePanels_, laboratoryPanels_;
  // Whether to show the laboratory (panels for developers); empty: the user has not chosen yet.
  std::optional<bool> laboratoryChosen_;
  QMenu* instrumentMenu_;
  std::vector<QAction*> instrumentActions_;
  InstrumentsPanel* instruments_;
  OrganPanel* organ_;
  RemovedPanel* removed_;
  ForcePanel* force_;
  TimingPanel* timing_;
  TimelinePanel* timeline_;
  ExercisesPage* exercises_;
  ExercisePanel* exercise_;
  QDockWidget* exerciseDock_;
  AttemptScorer scorer_;
  TaskMakerPanel* maker_;
  QDockWidget* makerDock_;
  Scenario made_;  // scenario from which an exercise is made
  std::vector<MadeMark> madeMarks_;
  std::vector<MadeTry> madeTries_;
  bool marking_ = false;                  // the next click marks a place
  std::shared_ptr<LiveAttempt> attempt_;  // attempt at the last exercise; null: none
  bool attemptEnded_ = false;
  qint64 attemptEndedAt_ = 0;   // ms since 1970
  bool afterExercise_ = false;  // somebody goes on operating after an exercise
  bool waitsForHand_ = false;   // no instrument was taken yet, so the time has not started
  std::vector<HaemostasisWatch> haemostasis_;  // one per instrument that closes vessels
  bool clampSaid_ = false;                     // the inflow was clamped at the last tick
  int haemorrhage_ = 1;                        // class of blood loss, 1 to 4, at the last tick
  bool menuOpen_ = false;                      // a menu was open at the last tick
  // asTest_: the present exercise is a test. startedAsTest_: the exercise that is being loaded is a
  // test.
  bool asTest_ = false, startedAsTest_ = false;
  std::filesystem::path page_;      // report of the last attempt
  std::int64_t attemptBranch_ = 0;  // branch on which the last attempt ended
  std::int64_t replayUntil_ = -1;   // frame where the replay stops; -1: no replay
  std::unique_ptr<VideoWriter> video_;
  QSize videoSize_;
  Speaker speaker_;
  qint64 panelsShown_ = 0, pictureTaken_ = 0;  // times, ms since 1970
  // The members whose names end in Said hold what was last reported to a script, or last shown.
  std::int64_t removedSaid_ = 0;    // number of removed particles
  std::uint64_t uploadedSaid_ = 0;  // number of uploaded vertices
  double forceSaid_ = 0;            // largest force on a tool since the last report, N
  int heldSaid_ = -2;               // number of the tool in hand; -1: none; -2: nothing said yet
  ToolHandling::Hold howSaid_ = ToolHandling::Hold::None;
  std::vector<std::uint8_t> leftSaid_;  // per tool, as ToolHandling::left()
  std::vector<LeftTool> leftTools_;     // per tool, at the last tick
  std::string script_, faultSaid_, recorderSaid_;
  qint64 faultSeen_ = 0;       // last time the operation had a fault, ms since 1970
  std::string operationFile_;  // file where the user saved the operation; empty: none yet
  std::string madeFrom_;       // recording that the operation was opened from; empty: none
  static constexpr std::size_t kNoTarget = ~std::size_t(0);
  std::size_t targetSaid_ = kNoTarget;       // number of the exercise's next target, from 0
  std::size_t strokesBefore_ = 0;            // strokes that the operation had when it was opened
  std::optional<std::size_t> strokesNoted_;  // number of strokes at the last noteRecording()
  bool lookingAt_ = false;  // the next click chooses the point that the camera looks at
  bool readySaid_ = false, pictureSaid_ = false;
  bool playingSaid_ = false, showingSaid_ = false;
  bool waitingSaid_ = false;
  qint64 slowSince_ = 0;  // when the simulation became too slow, ms since 1970; 0: not slow
  Moment momentSaid_;
  std::shared_ptr<const Ledger> ledgerSaid_;
  bool keepsView_ = false;  // the same organ is being loaded again: the camera stays
  // The picture's size at the last update of the panels, and at the last report of positions.
  QSize lastSize_, placesSize_;
};

}  // namespace resect
