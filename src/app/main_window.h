// The main window: picture, panels, menus, and the operating session that they show.
#pragma once

#include <QMainWindow>
#include <memory>

#include "app/open_organ_dialog.h"
#include "app/organ_loader.h"
#include "app/space_mouse.h"
#include "app/window.h"
#include "formats/video.h"
#include "inventor/hand/operating_session.h"

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
class TimingPanel;
class Viewer;

class MainWindow : public QMainWindow {
 public:
  explicit MainWindow(const WindowOptions& options);
  ~MainWindow() override;

  void load(const Scenario& scenario);
  // Shows a sentence over the picture until the user clicks it or another sentence replaces it.
  void complain(const std::string& sentence);
  // Plays the scenario's motions up to this scenario time, s.
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
  void begin(OrganLoader::Result result);
  void loadDefault();
  void cancelLoading();
  void tick();
  void film(qint64 now);  // ms
  void listenToScript();
  void writeScene(const std::string& file);
  void openFile(const QString& file);
  void askOrgan(const QString& file);
  void remember(const QString& file);
  void fillRecent();
  void saveSurface();
  void saveScene();
  void savePicture();
  void toggleVideo();
  bool viewerEvent(const SoEvent& event, const SbViewportRegion& viewport);
  void look(RoomView view);
  void viewAll();
  void bringEverythingBack();
  void reportPlaces();
  void reportPace();
  void resizePicture(const std::string& text);
  void placeOverlays();
  // Asks for a file name and calls `write` with it. An exception of `write` is shown to the user.
  void save(const char* title, const char* filter, const QString& name,
            const std::function<void(const std::string&)>& write);

  WindowOptions options_;
  std::unique_ptr<OperatingSession> session_;
  OrganLoader loader_;
  SpaceMouse spaceMouse_;
  Viewer* viewer_;
  ControlsOverlay* overlay_;
  QPushButton* complaint_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* recording_;
  QMenu* recent_;
  QAction* dark_;
  InstrumentsPanel* instruments_;
  OrganPanel* organ_;
  RemovedPanel* removed_;
  ForcePanel* force_;
  TimingPanel* timing_;
  std::unique_ptr<VideoWriter> video_;
  QSize videoSize_;
  qint64 panelsShown_ = 0, pictureTaken_ = 0;  // ms
  std::int64_t removedSaid_ = 0;
  std::uint64_t uploadedSaid_ = 0;
  double forceSaid_ = 0;  // N, largest since the last report
  int heldSaid_ = -2;
  ToolHandling::Hold howSaid_ = ToolHandling::Hold::None;
  std::string script_, faultSaid_;
  bool lookingAt_ = false;  // the next click chooses the point of interest
  bool readySaid_ = false;
  bool playingSaid_ = false;
  bool keepsView_ = false;       // the same organ is being loaded again: the camera stays
  QSize lastSize_, placesSize_;  // picture size: last panel update, last report of positions
};

}  // namespace resect
