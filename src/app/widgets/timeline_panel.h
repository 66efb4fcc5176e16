// The timeline of the operation: strokes, faults and branches over time; any moment can be shown,
// played again, and worked on from.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "operation/live/live_state.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace resect {

class TimelineBar;

class TimelinePanel : public QWidget {
 public:
  explicit TimelinePanel(QWidget* parent = nullptr);
  // For a new operation. tools: names of its instruments.
  void begin(const std::vector<QString>& tools, double frameRate);
  // showing: a moment is shown, or on its way; answered: it is not on its way.
  void follow(const LiveState& state, bool showing, bool answered);

  // Shows the moment so many frames before (negative) or after the one that is shown, or on its
  // way; the start; the end of the branch. While somebody operates there is nothing after.
  void step(std::int64_t frames);
  void toStart() { ask(0); }
  void toEnd();
  bool atEnd() const { return frame_ >= end_ && asked_ < 0; }
  void togglePlayback();
  // The branch that is looked at.
  std::int64_t branch() const { return branch_; }
  double frameRate() const { return frameRate_; }
  // Looks at a branch: shows its end.
  void lookAt(std::int64_t branch);
  // The bar's ends, in pixels of the screen: the start and the end of the operation.
  std::pair<QPoint, QPoint> barEnds() const;

  // What the person asks for.
  std::function<void(Moment)> wanted;
  std::function<void(double speed)> playback;
  std::function<void()> goOn, compare;

 private:
  friend class TimelineBar;
  void listBranches();
  static bool isListed(const Timeline::Course& course);
  // Listed branches that begin on the way to the one that is looked at.
  std::vector<const Timeline::Course*> branchesBeside() const;
  void ask(std::int64_t frame);

  std::shared_ptr<const Timeline> timeline_ = std::make_shared<Timeline>();
  std::vector<QString> tools_;
  double frameRate_ = 60;
  std::int64_t branch_ = 0, frame_ = 0, end_ = 0;
  std::int64_t asked_ = -1;  // frame that was asked for and is not reached; -1: none
  bool showing_ = false;
  double speed_ = 0;
  TimelineBar* bar_;
  QLabel *time_, *hint_, *memory_;
  QToolButton *play_, *goOn_, *compare_;
  QComboBox *rate_, *branches_;
};

// "1:02.4": minutes, seconds.
QString clockText(double seconds);

}  // namespace resect
