// The timeline of the main window: its menu, and what a person asks of it.
#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include "app/language/words.h"
#include "app/main_window.h"
#include "app/say.h"
#include "app/viewer.h"
#include "app/widgets/branches_dialog.h"
#include "app/widgets/timeline_panel.h"

namespace resect {

void MainWindow::makeTimelineMenu() {
  timeline_->wanted = [this](Moment moment) {
    replayUntil_ = -1;
    if (session_ && !refusesGoingBack()) session_->show(moment);
  };
  timeline_->playback = [this](double speed) {
    replayUntil_ = -1;
    if (session_) session_->setPlayback(speed, timeline_->branch());
  };
  timeline_->goOn = [this] {
    if (session_) session_->goOn();
    viewer_->setFocus();
  };
  timeline_->compare = [this] { compareBranches(); };

  QMenu* menu = menuBar()->addMenu(Words::tr("&Timeline"));
  menu->setToolTipsVisible(true);
  const auto add = [this, menu](const QString& text, const QList<QKeySequence>& keys,
                                const QString& tip, auto act) {
    QAction* action = menu->addAction(text);
    action->setShortcuts(keys);
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this, act);
  };
  const auto second = [this] { return std::int64_t(timeline_->frameRate() + 0.5); };
  add(Words::tr("One frame &back"), {QKeySequence(Qt::Key_Comma)},
      Words::tr("Shows the frame before"), [this] { timeline_->step(-1); });
  add(Words::tr("One frame &on"), {QKeySequence(Qt::Key_Period)},
      Words::tr("Shows the frame after"), [this] { timeline_->step(1); });
  add(Words::tr("One second b&ack"), {QKeySequence("Ctrl+Left")},
      Words::tr("Shows what was a second before"), [this, second] { timeline_->step(-second()); });
  add(Words::tr("One second o&n"), {QKeySequence("Ctrl+Right")},
      Words::tr("Shows what was a second after"), [this, second] { timeline_->step(second()); });
  add(Words::tr("To the &start"), {QKeySequence("Ctrl+Home")},
      Words::tr("Shows the start of the operation"), [this] { timeline_->toStart(); });
  add(Words::tr("To the &end"), {QKeySequence(Qt::Key_End), QKeySequence("Ctrl+End")},
      Words::tr("Shows the end of the branch"), [this] { timeline_->toEnd(); });
  menu->addSeparator();
  add(Words::tr("&Play or stop"), {QKeySequence("Ctrl+Space")},
      Words::tr("Plays again what happened after this moment"),
      [this] { timeline_->togglePlayback(); });
  add(Words::tr("&Go on from here"), {QKeySequence("Ctrl+Return")},
      Words::tr("Operates from the moment that is shown; what came after it stays as a branch"),
      [this] { timeline_->goOn(); });
  menu->addSeparator();
  add(Words::tr("&Compare branches ..."), {QKeySequence("Ctrl+B")},
      Words::tr("All branches side by side"), [this] { compareBranches(); });
}

void MainWindow::compareBranches() {
  if (!session_ || !session_->state().timeline) return;
  BranchesDialog dialog(*session_->state().timeline, timeline_->branch(), timeline_->frameRate(),
                        this);
  dialog.wanted = [this](std::int64_t branch) { timeline_->lookAt(branch); };
  dialog.renamed = [this](std::int64_t branch, const std::string& name) {
    session_->operation().nameBranch(branch, name);
  };
  dialog.exec();
}

}  // namespace resect
