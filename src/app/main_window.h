// The main window: picture, panels, menus, and the session behind them.
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
  // One sentence over the picture, until it is clicked away or another comes.
  void complain(const std::string& sentence);
  // The motions of the scenario, on until this time of theirs, s.
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
  // Asks for a file to write; what goes wrong in `write` is said.
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
  double forceSaid_ = 0;  // N, largest since it was said
  int heldSaid_ = -2;
  ToolHandling::Hold howSaid_ = ToolHandling::Hold::None;
  std::string script_, faultSaid_;
  bool lookingAt_ = false;  // the next click chooses the point of interest
  bool readySaid_ = false;
  bool playingSaid_ = false;
  bool keepsView_ = false;       // what is loaded is the organ that is there, begun again
  QSize lastSize_, placesSize_;  // of the picture: at the last look, when places were told
};

}  // namespace resect
