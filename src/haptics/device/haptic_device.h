// Haptic devices, whose plug-ins are shared libraries opened at run time (resect_haptic_device.h).
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "geometry/pose.h"
#include "haptics/device/resect_haptic_device.h"
#include "haptics/force_renderer.h"

namespace resect {

// Returns the file of a plug-in. A name that contains a slash or ends with ".so" is a path, which
// is returned unchanged. Any other name is that of a plug-in that comes with Resect, such as
// "simulated_hand". Its file is searched for in the program's folder, in ../lib/resect/ relative to
// that folder, and where plug-ins are installed. Throws Error with these places if it is in none.
std::filesystem::path findHapticPlugin(const std::string& name);

// A loaded plug-in. The library stays loaded while a HapticPlugin or a HapticDevice uses it.
class HapticPlugin {
 public:
  // Throws Error with one sentence if the file does not exist, is no shared library, has no
  // function resect_haptic_device(), was built for another version of the interface, or lacks a
  // function in its table. Loading runs the library's initialisers before most of these checks.
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
  // options: text for the plug-in. Throws Error with the plug-in's sentence if the device cannot be
  // opened. Also throws Error if the device's largest force is not a finite number above 0.
  explicit HapticDevice(const HapticPlugin& plugin, const std::string& options = "");
  // A device whose functions are in this program. They must outlive the device. name: for Errors.
  HapticDevice(const ResectHapticDeviceFunctions& functions, const std::string& name,
               const std::string& options);
  ~HapticDevice();
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;

  double mostForce() const { return limits_.most_force; }  // N
  // Whether the device plays a person: it simulates the hand that holds the instrument.
  bool plays() const { return functions_->intend != nullptr; }
  // Tells a device that plays a person at which pose that person wants the tip, in the device's
  // coordinates. Does nothing for other devices.
  void intend(const Pose& pose);
  // The present pose of the instrument, in the device's coordinates, m. Throws Error if the plug-in
  // reports a failure, or if the pose is not finite.
  Pose read();
  // Sets the force on the hand. Throws Error if the plug-in reports a failure.
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
