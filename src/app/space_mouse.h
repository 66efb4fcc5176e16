// Reads a 3D mouse through the free daemon spacenavd. Does nothing without the daemon or the
// device.
#pragma once

#include <QSocketNotifier>
#include <functional>
#include <memory>

#include "inventor/hand/six_axes.h"

namespace resect {

class SpaceMouse {
 public:
  SpaceMouse();
  ~SpaceMouse();
  SpaceMouse(const SpaceMouse&) = delete;
  SpaceMouse& operator=(const SpaceMouse&) = delete;

  bool connected() const { return notifier_ != nullptr; }
  const char* status() const;  // a sentence for the user

  // Called for each motion of the 3D mouse. seconds: time since the previous motion.
  std::function<void(const SixAxes&, double seconds)> pushed;

 private:
  void read();

  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace resect
