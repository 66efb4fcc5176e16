// The main window: picture, panels, menus, and the operating session that they show.
#pragma once

#include <QMainWindow>
#include <memory>

#include "app/loading/operation_loader.h"
#include "app/loading/organ_loader.h"
#include "app/space_mouse.h"
#include "app/window.h"
#include "formats/video.h"
#include "inventor/hand/operating_session.h"
#include "record/recorder.h"

class QAction;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;

namespace resect {

class ControlsOverlay;
class ForcePanel;
class InstrumentsPanel;
class OrganPanel;
class RemovedPanel;
class TimelinePanel;
class TimingPanel;
class Viewer;

class MainWindow : public QMainWindow {
 public:
  explicit MainWindow(const WindowOptions& options);
  ~MainWindow() override;

  bool load(const Scenario& scenario);  // false: the user keeps the present operation
  // Shows a sentence over the picture until the user clicks it or another sentence replaces it.
  void complain(const std::string& sentence);
  // Plays the scenario's motions up to the scenario time `until`, s. Begins where the last call
  // ended, or at the start of the motions if they are over or were stopped.
  void play(double until);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static constexpr double kVideoRate = 25;  // pictures per second

  void makeMenus();
  void makeDocks();
  bool begin(OrganLoader::Result result);  // false: it cannot be shown; the user was told
  std::shared_ptr<Recorder> record(const OrganLoader::Result& result);
  // anew: the operation starts again from its beginning, without what was done.
  void openOperation(const QString& file, bool anew = false);
  // Whether the operation may be discarded: nothing would be lost, or the user agrees.
  bool mayEnd();
  void saveOperation(bool elsewhere);
  void writeOperation(const std::string& file);
  void noteRecording();
  void listRecordings();
  void makeTimelineMenu();
  void compareBranches();
  void showProgress(double share);
  void loadDefault();
  void cancelLoading();
  void tick();
  void film(qint64 now);  // now: ms since 1970
  void listenToScript();
  void writeScene(const std::string& file);
  // Throws Error if the operation has read the file, or will read it again.
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
  QString heldName(const char* none) const;
  void look(RoomView view);
  void viewAll();
  void bringEverythingBack();
  void reportPlaces();
  void reportPace();
  void reportMoment();
  void resizePicture(const std::string& text);
  void placeOverlays();
  // Asks the user for a file name and calls `write` with it. If `write` throws, the user sees the
  // exception's text.
  void save(const char* title, const char* filter, const QString& name,
            const std::function<void(const std::string&)>& write);

  WindowOptions options_;
  std::shared_ptr<Recorder> recorder_;  // of the present operation; null: it is not recorded
  std::unique_ptr<OperatingSession> session_;
  OrganLoader loader_;
  OperationLoader operations_;
  SpaceMouse spaceMouse_;
  Viewer* viewer_;
  ControlsOverlay* overlay_;
  QPushButton* complaint_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel *recording_, *notRecorded_;
  QMenu *recent_, *recordings_;
  QAction *undo_, *redo_, *recordingOn_;
  QAction* dark_;
  InstrumentsPanel* instruments_;
  OrganPanel* organ_;
  RemovedPanel* removed_;
  ForcePanel* force_;
  TimingPanel* timing_;
  TimelinePanel* timeline_;
  std::unique_ptr<VideoWriter> video_;
  QSize videoSize_;
  qint64 panelsShown_ = 0, pictureTaken_ = 0;  // times, ms since 1970
  // The members whose names end in Said hold what was last reported to a script, or last shown.
  std::int64_t removedSaid_ = 0;    // particles
  std::uint64_t uploadedSaid_ = 0;  // vertices
  double forceSaid_ = 0;            // largest force on a tool since the last report, N
  int heldSaid_ = -2;               // number of the tool in hand; -1: none; -2: nothing said yet
  ToolHandling::Hold howSaid_ = ToolHandling::Hold::None;
  std::vector<std::uint8_t> leftSaid_;  // per tool, as ToolHandling::left()
  std::string script_, faultSaid_, recorderSaid_;
  std::string operationFile_;      // file where the user saved the operation; empty: none yet
  std::string madeFrom_;           // recording that the operation was opened from; empty: none
  std::size_t strokesBefore_ = 0;  // strokes that the operation had when it was opened
  std::optional<std::size_t> strokesNoted_;  // number of strokes at the last noteRecording()
  bool lookingAt_ = false;  // the next click chooses the point that the camera looks at
  bool readySaid_ = false;
  bool playingSaid_ = false, showingSaid_ = false, movesSaid_ = false;
  Moment momentSaid_;
  std::shared_ptr<const Ledger> ledgerSaid_;
  bool keepsView_ = false;  // the same organ is being loaded again: the camera stays
  // The picture's size at the last update of the panels, and at the last report of positions.
  QSize lastSize_, placesSize_;
};

}  // namespace resect
