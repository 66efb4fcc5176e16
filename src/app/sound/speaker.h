// Plays the sounds of the operation on the computer's loudspeaker.
#pragma once

#include <QAudioSink>
#include <QElapsedTimer>
#include <QIODevice>
#include <memory>
#include <mutex>

#include "operation/sound/operating_sound.h"

class QMenu;

namespace resect {

class Speaker : private QIODevice {
 public:
  Speaker() = default;
  ~Speaker() override { setOn(false); }

  // Turns the sound on or off. Returns whether the sound is on now. It stays off if the computer
  // has no device for sound.
  bool setOn(bool on);
  // Plays what is heard in this state; arguments as for audibleState(). Call it often. While the
  // state's frame does not change, because the operation is paused, nothing is heard.
  void follow(const LiveState& state, std::span<const ToolModel> tools, int pedalled);

 private:
  qint64 readData(char* bytes, qint64 most) override;
  qint64 writeData(const char*, qint64) override { return -1; }
  qint64 bytesAvailable() const override { return 1 << 16; }  // the sound never ends
  bool isSequential() const override { return true; }

  std::unique_ptr<QAudioSink> sink_;
  std::unique_ptr<OperatingSound> sound_;
  std::mutex mutex_;  // protects heard_, since Qt may call readData() in another thread
  AudibleState heard_;
  std::int64_t frame_ = -1;  // frame of the last state
  QElapsedTimer since_;      // time since frame_ changed
};

// Adds an item to a menu. The item, and the key M, turn the sound on and off. The choice is kept
// for the next start of the program; at first the sound is on.
void addSoundItem(QMenu* menu, Speaker& speaker);

}  // namespace resect
