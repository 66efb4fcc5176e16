// The interface, in C, of plug-ins for haptic devices. The author of a plug-in needs no other
// header of Resect.
//
// A plug-in is a shared library. It exports one function, resect_haptic_device(), which returns a
// table of functions. Resect opens the library at run time. The plug-in is not linked against
// Resect, and Resect is not linked against the plug-in. One thread calls open(), and then intend()
// and read() once each. After that, another thread calls intend(), read() and write() 1000 times a
// second. These three functions must not wait or allocate memory, and must take at most 0.1 ms.
// docs/how-to/haptic_device.md has a complete example.
//
// Units: metres, newtons, seconds. Coordinates are right-handed: X to the right, Y up, Z towards
// the person. The plug-in must convert the device's own coordinates to these, with the origin in
// the centre of the workspace. Resect decides where in the world this origin is.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// This number changes whenever anything below it changes.
#define RESECT_HAPTIC_DEVICE_VERSION 1

// An open device. Only the plug-in knows the content of this struct.
typedef struct ResectHapticDevice ResectHapticDevice;

typedef struct {
  double most_force;   // largest force that the device can hold for long, N, > 0
  double most_torque;  // largest torque that it can hold for long, N m; 0: it renders no torque
} ResectHapticLimits;

typedef struct {
  double position[3];  // position of the tip, m
  double rotation[4];  // unit quaternion x, y, z, w; 0, 0, 0, 1 if no rotation is measured
  uint32_t buttons;    // bit i is 1 while button i is held down
} ResectHapticPose;

typedef struct {
  double force[3];   // force on the hand, N
  double torque[3];  // torque on the hand about the tip, N m
} ResectHapticForce;

// A function that returns an int returns 0 on success. If it returns another number, last_error()
// describes the failure.
typedef struct {
  uint32_t version;  // RESECT_HAPTIC_DEVICE_VERSION
  const char* name;  // shown to people
  // Opens a device and writes the device's limits to *limits. options: text for the plug-in, from
  // the command line; never null. Returns null on failure.
  ResectHapticDevice* (*open)(const char* options, ResectHapticLimits* limits);
  // Sets the force to zero and closes the device.
  void (*close)(ResectHapticDevice* device);
  int (*read)(ResectHapticDevice* device, ResectHapticPose* pose);
  // Sets the force and the torque on the hand. They act until the next write().
  int (*write)(ResectHapticDevice* device, const ResectHapticForce* force);
  // Returns one sentence about the last failure. device: null if open() failed. The text is valid
  // until the next call of a function of this table.
  const char* (*last_error)(ResectHapticDevice* device);
  // This function is for devices that play a person, which means that they simulate the hand that
  // holds the instrument. It is called before each read(), with the pose that this person wants the
  // tip to have. For real devices this pointer is null.
  void (*intend)(ResectHapticDevice* device, const ResectHapticPose* pose);
} ResectHapticDeviceFunctions;

// The plug-in defines this function and exports it under this name. The returned table must stay
// valid as long as the library is loaded.
const ResectHapticDeviceFunctions* resect_haptic_device(void);

#ifdef __cplusplus
}
#endif
