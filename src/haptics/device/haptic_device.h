// Opens haptic devices. The plug-in of a device is a shared library that is opened at run time
// (haptics/device/resect_haptic_device.h).
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "geometry/pose.h"
#include "haptics/device/resect_haptic_device.h"
#include "haptics/force_renderer.h"

namespace resect {

// The file of a plug-in. If the name contains a slash or ends with ".so", it is a path and is
// returned unchanged. Any other name is the name of a plug-in that comes with Resect, such as
// "simulated_hand". The file of such a plug-in is searched for in three places: the program's
// folder, the folder ../lib/resect/ relative to it, and the folder in which plug-ins are installed.
// If the file is in none of these places, throws an Error that says where it should be.
std::filesystem::path findHapticPlugin(const std::string& name);

// A loaded plug-in. The library stays loaded while a HapticPlugin or a HapticDevice uses it.
class HapticPlugin {
 public:
  // Throws an Error of one sentence in these cases: the file does not exist, it is not a shared
  // library, it has no function resect_haptic_device(), it was built for another version of the
  // interface, or a function is missing in its table. Loading the library runs its initialisers
  // before most of these checks are made.
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

// An open device. The functions read(), write() and intend() allocate no memory unless they fail.
class HapticDevice {
 public:
  // options: text for the plug-in. If the device cannot be opened, throws an Error that contains
  // the plug-in's explanation. Also throws Error if the device's largest force is not a finite
  // number above 0.
  explicit HapticDevice(const HapticPlugin& plugin, const std::string& options = "");
  // A device whose functions are in this program. `functions` must outlive the device. name: name
  // of the device, for the messages of Errors.
  HapticDevice(const ResectHapticDeviceFunctions& functions, const std::string& name,
               const std::string& options);
  ~HapticDevice();
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;

  // The largest force that the device can hold for long, N.
  double mostForce() const { return limits_.most_force; }
  // Whether the device plays a person. Such a device simulates the hand that holds the instrument.
  bool plays() const { return functions_->intend != nullptr; }
  // If the device plays a person, tells the device the pose that this person wants the tip to have,
  // in the device's coordinates. Otherwise does nothing.
  void intend(const Pose& pose);
  // The present pose of the instrument, in the device's coordinates, m. Throws Error if the plug-in
  // reports a failure, if the pose is not finite, or if the length of its quaternion is not between
  // 0.5 and 2.
  Pose read();
  // Sets the force and the torque on the hand. A torque above the device's largest torque is scaled
  // down to it. Throws Error if the plug-in reports a failure.
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
