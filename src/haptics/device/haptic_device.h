// Haptic devices whose plug-ins are opened at run time (resect_haptic_device.h). Nothing is linked.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "geometry/pose.h"
#include "haptics/device/resect_haptic_device.h"
#include "haptics/force_renderer.h"

namespace resect {

// Finds a plug-in. name: a path if it holds a slash or ends with ".so"; otherwise the name of one
// that comes with Resect, such as "simulated_hand". It is looked for in the folder of the program,
// in ../lib/resect/ seen from there, and where plug-ins are installed. Throws Error with the places
// if it is nowhere.
std::filesystem::path findHapticPlugin(const std::string& name);

// A loaded plug-in. It stays loaded while a device of it is open.
class HapticPlugin {
 public:
  // Throws Error with one sentence if there is no such file, if it is no shared library, if it has
  // no function resect_haptic_device(), if that is for another version of the interface, or if a
  // function of the table is missing. The library's own initialisers have run by then.
  explicit HapticPlugin(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  std::string name() const;
  const ResectHapticDeviceFunctions& functions() const { return *functions_; }
  const std::shared_ptr<void>& library() const { return library_; }

 private:
  std::filesystem::path file_;
  std::shared_ptr<void> library_;
  const ResectHapticDeviceFunctions* functions_ = nullptr;
};

// An open device. read(), write() and intend() allocate nothing unless they fail.
class HapticDevice {
 public:
  // options: text for the plug-in. Throws Error with the plug-in's sentence if it cannot be opened,
  // or if the force that it renders is not a number above 0.
  explicit HapticDevice(const HapticPlugin& plugin, const std::string& options = "");
  // A device of a table of functions in this program, which must outlive it. name: for errors.
  HapticDevice(const ResectHapticDeviceFunctions& functions, const std::string& name,
               const std::string& options);
  ~HapticDevice();
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;

  double mostForce() const { return limits_.most_force; }  // N
  bool plays() const { return functions_->intend != nullptr; }
  // For a device that plays a person; does nothing otherwise.
  void intend(const Pose& pose);
  // Where the instrument is held, in the device's coordinates. Throws Error with the plug-in's
  // sentence, or if the pose is not finite.
  Pose read();
  // Throws Error with the plug-in's sentence.
  void write(const Wrench& wrench);

 private:
  [[noreturn]] void fail(const char* what) const;

  std::shared_ptr<void> library_;
  const ResectHapticDeviceFunctions* functions_;
  std::string file_;
  ResectHapticLimits limits_{};
  ResectHapticDevice* device_;
};

}  // namespace resect
