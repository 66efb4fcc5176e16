#include "app/sound/speaker.h"

#include <QAction>
#include <QAudioDevice>
#include <QAudioFormat>
#include <QMediaDevices>
#include <QMenu>
#include <QSettings>
#include <QTimer>
#include <span>

#include "app/language/words.h"

namespace resect {
namespace {

constexpr int kRate = 44100;               // samples per second
constexpr double kBuffered = 0.08;         // s of sound that wait to be played
constexpr const char* kSetting = "sound";  // whether sound is on

// Null without one. Without a sound server Qt writes of its own calls on the console; the menu
// tells it in our words.
QAudioDevice soundDevice() {
  const QtMessageHandler told =
      qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  const QAudioDevice device = QMediaDevices::defaultAudioOutput();
  qInstallMessageHandler(told);
  return device;
}

}  // namespace

bool Speaker::setOn(bool on) {
  if (on == (sink_ != nullptr)) return on;
  if (!on) {
    sink_.reset();
    close();
    return false;
  }
  const QAudioDevice device = soundDevice();
  QAudioFormat format;
  format.setSampleRate(kRate);
  format.setChannelCount(1);
  format.setSampleFormat(QAudioFormat::Float);
  if (device.isNull() || !device.isFormatSupported(format)) return false;
  sound_ = std::make_unique<OperatingSound>(kRate);
  open(QIODevice::ReadOnly);
  sink_ = std::make_unique<QAudioSink>(device, format);
  sink_->setBufferSize(qsizetype(kBuffered * kRate * sizeof(float)));
  sink_->start(this);
  return true;
}

void Speaker::follow(const LiveState& state, std::span<const ToolModel> tools, int pedalled) {
  if (!sink_) return;
  if (state.frame != frame_) {
    frame_ = state.frame;
    since_.start();
  }
  constexpr qint64 kPaused = 300;  // ms
  const std::lock_guard lock(mutex_);
  heard_ = since_.elapsed() < kPaused ? audibleState(state, tools, pedalled) : AudibleState();
}

qint64 Speaker::readData(char* bytes, qint64 most) {
  AudibleState state;
  {
    const std::lock_guard lock(mutex_);
    state = heard_;
  }
  const std::size_t count = std::size_t(most) / sizeof(float);
  sound_->fill(state, std::span(reinterpret_cast<float*>(bytes), count));
  return qint64(count * sizeof(float));
}

void addSoundItem(QMenu* menu, Speaker& speaker) {
  QAction* item = menu->addAction(Words::tr("Sou&nd"));
  item->setShortcut(QKeySequence("M"));
  item->setCheckable(true);
  item->setToolTip(
      Words::tr("Suction, energy devices, and the monitor's beep at each beat of the heart"));
  const auto turn = [item, &speaker](bool on) {
    const bool plays = speaker.setOn(on);
    if (on && !plays) item->setToolTip(Words::tr("This computer has no device for sound"));
    item->setChecked(plays);
  };
  QObject::connect(item, &QAction::triggered, item, [turn](bool on) {
    QSettings().setValue(kSetting, on);
    turn(on);
  });
  // Looking for the device takes a moment, which the first picture shall not wait for.
  constexpr int kLater = 1500;  // ms
  QTimer::singleShot(kLater, item, [turn] { turn(QSettings().value(kSetting, true).toBool()); });
}

}  // namespace resect
