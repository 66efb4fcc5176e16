#include "app/space_mouse.h"

#include <QCoreApplication>

#include <spnav.h>
#include <sys/socket.h>

namespace resect {

SpaceMouse::SpaceMouse() {
  if (spnav_open() == -1) return;
  notifier_ = std::make_unique<QSocketNotifier>(spnav_fd(), QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, [this] { read(); });
}

SpaceMouse::~SpaceMouse() {
  if (connected()) spnav_close();
}

const char* SpaceMouse::status() const {
  return connected() ? QT_TRANSLATE_NOOP("window",
                                         "A 3D mouse moves and turns what is in hand, or the view.")
                     : QT_TRANSLATE_NOOP("window", "No 3D mouse: spacenavd does not run.");
}

void SpaceMouse::read() {
  char byte = 0;
  if (recv(spnav_fd(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0) {
    // The daemon has ended. The notifier is executing, so it is deleted later.
    spnav_close();
    notifier_->setEnabled(false);
    notifier_.release()->deleteLater();
    return;
  }
  spnav_event event;
  while (connected() && spnav_poll_event(&event)) {
    if (event.type != SPNAV_EVENT_MOTION || !pushed) continue;
    // The daemon's axes are left-handed: right, up, away.
    const spnav_event_motion& m = event.motion;
    pushed({Vec3(m.x, m.y, m.z), Vec3(-m.rx, -m.ry, -m.rz)}, 1e-3 * m.period);
  }
}

}  // namespace resect
