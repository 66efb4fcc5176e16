#include "haptics/device/haptic_device.h"

#include <dlfcn.h>

#include <cmath>

#include "base/error.h"
#include "base/text/shown_text.h"

namespace resect {
namespace fs = std::filesystem;

fs::path findHapticPlugin(const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(".so")) return name;
  const std::string file = "resect_" + name + ".so";
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec).parent_path();
  for (const fs::path& place :
       {program, program / ".." / RESECT_DEVICES, fs::path(RESECT_INSTALLED_DEVICES)})
    if (fs::is_regular_file(place / file, ec)) return fs::weakly_canonical(place / file, ec);
  throw error(
      "there is no haptic device \"{}\": {} is neither beside {} nor in {}; give the path of a "
      "plug-in, such as ./my_device.so",
      shownText(name), shownText(file), program.string(), RESECT_INSTALLED_DEVICES);
}

HapticPlugin::HapticPlugin(const fs::path& file) : file_(file) {
  const std::string shown = shownText(file.string(), kLongestShownPath);
  std::error_code ec;
  if (!fs::is_regular_file(file, ec))
    throw error("there is no haptic plug-in {}; give the path of a shared library", shown);
  // With a slash in it, so that no other folder is searched.
  void* handle = dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    const char* why = dlerror();
    throw error("the haptic plug-in {} is not a shared library that can be loaded here: {}", shown,
                shownSentence(why ? why : "no reason given"));
  }
  library_.reset(handle, [](void* library) { dlclose(library); });
  const auto entry = reinterpret_cast<const ResectHapticDeviceFunctions* (*)()>(
      dlsym(handle, "resect_haptic_device"));
  if (!entry)
    throw error(
        "the haptic plug-in {} has no function resect_haptic_device(); export it as "
        "docs/how-to/haptic_device.md shows",
        shown);
  functions_ = entry();
  if (!functions_) throw error("the haptic plug-in {} gives no table of functions", shown);
  if (functions_->version != RESECT_HAPTIC_DEVICE_VERSION)
    throw error(
        "the haptic plug-in {} is for version {} of the interface, and this is {}; build "
        "it again with this Resect's resect_haptic_device.h",
        shown, functions_->version, RESECT_HAPTIC_DEVICE_VERSION);
  const auto& f = *functions_;
  const char* missing = !f.open         ? "open"
                        : !f.close      ? "close"
                        : !f.read       ? "read"
                        : !f.write      ? "write"
                        : !f.last_error ? "last_error"
                                        : nullptr;
  if (missing)
    throw error("the haptic plug-in {} has no function {}() in its table", shown, missing);
}

std::string HapticPlugin::name() const {
  return functions_->name ? shownText(functions_->name) : file_.stem().string();
}

HapticDevice::HapticDevice(const HapticPlugin& plugin, const std::string& options)
    : HapticDevice(plugin.functions(), plugin.file().string(), options) {
  library_ = plugin.library();
}

HapticDevice::HapticDevice(const ResectHapticDeviceFunctions& functions, const std::string& name,
                           const std::string& options)
    : functions_(&functions),
      file_(shownText(name, kLongestShownPath)),
      device_(functions_->open(options.c_str(), &limits_)) {
  if (!device_) fail("open");
  if (!(limits_.most_force > 0 && std::isfinite(limits_.most_force))) {
    functions_->close(device_);
    throw error("the haptic device of {} says that it renders {} N; it must say more than 0", file_,
                limits_.most_force);
  }
}

HapticDevice::~HapticDevice() { functions_->close(device_); }

void HapticDevice::fail(const char* what) const {
  const char* why = functions_->last_error(device_);
  throw error("the haptic device of {} failed in {}(): {}", file_, what,
              shownSentence(why && *why ? why : "it gives no reason"));
}

void HapticDevice::intend(const Pose& pose) {
  if (!functions_->intend) return;
  ResectHapticPose wanted{};
  for (int a = 0; a < 3; ++a) wanted.position[a] = pose.position[a];
  for (int a = 0; a < 4; ++a) wanted.rotation[a] = pose.rotation.coeffs()[a];
  functions_->intend(device_, &wanted);
}

Pose HapticDevice::read() {
  ResectHapticPose at{};
  at.rotation[3] = 1;
  if (functions_->read(device_, &at) != 0) fail("read");
  Pose pose;
  for (int a = 0; a < 3; ++a) pose.position[a] = at.position[a];
  for (int a = 0; a < 4; ++a) pose.rotation.coeffs()[a] = at.rotation[a];
  const double length = pose.rotation.norm();
  if (!isFinite(pose) || !(length > 0.5 && length < 2))
    throw error("the haptic device of {} gives a pose that is not one; check its read()", file_);
  pose.rotation.coeffs() /= length;
  return pose;
}

void HapticDevice::write(const Wrench& wrench) {
  ResectHapticForce force{};
  for (int a = 0; a < 3; ++a) force.force[a] = wrench.force[a];
  if (limits_.most_torque > 0) {
    const double torque = wrench.torque.norm();
    const double share = torque > limits_.most_torque ? limits_.most_torque / torque : 1;
    for (int a = 0; a < 3; ++a) force.torque[a] = share * wrench.torque[a];
  }
  if (functions_->write(device_, &force) != 0) fail("write");
}

}  // namespace resect
