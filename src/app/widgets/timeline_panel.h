// The timeline of the operation: strokes, faults and branches over time. The user can show any
// moment, and play the operation or go on operating from this moment. If the user operates from an
// earlier moment, a new branch begins; the old branch is kept.
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
  // A numbered mark, and what it stands for.
  struct Mark {
    std::int64_t frame = 0;
    QString number, text;
  };
  void setMarks(std::vector<Mark> marks);
  // Starts the timeline of a new operation, without marks. tools: names of its instruments.
  void begin(const std::vector<QString>& tools, double frameRate);
  // showing: whether a moment of the history is shown or was requested. answered: whether all
  // requests are done.
  void follow(const LiveState& state, bool showing, bool answered);

  // step() shows the moment that is `frames` frames later than the moment shown or requested. If
  // `frames` is negative, this is an earlier moment. toStart() shows the start of the operation.
  // toEnd() shows the end of the branch. While the user operates, there is no later moment: then
  // toEnd(), and step() with frames >= 0, do nothing.
  void step(std::int64_t frames);
  void toStart() { ask(0); }
  void toEnd();
  bool atEnd() const { return frame_ >= end_ && asked_ < 0; }
  void togglePlayback();
  // Sets whether the panel also shows figures for developers: memory, particles and bonds.
  void setLaboratory(bool shown);
  // The branch that is shown.
  std::int64_t branch() const { return branch_; }
  double frameRate() const { return frameRate_; }
  // Shows the end of a branch.
  void lookAt(std::int64_t branch);
  // The two ends of the bar, in pixels of the screen. They stand for the start and the end of the
  // operation.
  std::pair<QPoint, QPoint> barEnds() const;

  // Called when the user asks to show a moment (wanted), to play (playback), to operate from the
  // moment shown (goOn), or to compare branches (compare).
  std::function<void(Moment)> wanted;
  std::function<void(double speed)> playback;
  std::function<void()> goOn, compare;

 private:
  friend class TimelineBar;
  void listBranches();
  void describe();
  static bool isListed(const Timeline::Course& course);
  // Of the branches for which isListed() is true: those that fork off the branch that is shown, or
  // off an earlier part of its history.
  std::vector<const Timeline::Course*> branchesBeside() const;
  void ask(std::int64_t frame);

  std::shared_ptr<const Timeline> timeline_ = std::make_shared<Timeline>();
  std::vector<QString> tools_;
  std::vector<Mark> marks_;
  double frameRate_ = 60;
  std::int64_t branch_ = 0, frame_ = 0, end_ = 0;
  std::int64_t asked_ = -1;  // frame that was requested and is not reached yet; -1: none
  bool showing_ = false, laboratory_ = false;
  double speed_ = 0;
  TimelineBar* bar_;
  QLabel *time_, *hint_, *memory_;
  QToolButton *play_, *goOn_, *compare_;
  QComboBox *rate_, *branches_;
};

// A time in minutes and seconds: "1:02.4".
QString clockText(double seconds);

}  // namespace resect
