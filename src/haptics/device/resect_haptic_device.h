// The interface of a plug-in for a haptic device: all that its author needs, in C, with no other
// header of Resect.
//
// A plug-in is a shared library with one function, resect_haptic_device(), which returns a table of
// functions. Resect opens it at run time; neither is linked against the other. After open()
// the same thread calls intend() and read() once. Then one thread of Resect's calls intend(),
// read() and write(), 1000 times a second: none of them may wait, allocate, or take longer than 0.1
// ms. docs/how-to/haptic_device.md has a complete example.
//
// Coordinates: metres, newtons, seconds; right-handed, X to the right, Y up, Z towards the person.
// The plug-in turns and shifts the device's coordinates so that its workspace lies about the
// origin; Resect places that origin in the room.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Changes whenever something below changes.
#define RESECT_HAPTIC_DEVICE_VERSION 1

// A device that is open; only the plug-in knows what it is.
typedef struct ResectHapticDevice ResectHapticDevice;

typedef struct {
  double most_force;   // that it renders for long, N, > 0
  double most_torque;  // N m; 0: it renders no torque
} ResectHapticLimits;

typedef struct {
  double position[3];  // of the tip, m
  double rotation[4];  // unit quaternion x, y, z, w; identity if the device measures none
  uint32_t buttons;    // bit i: button i is held down
} ResectHapticPose;

typedef struct {
  double force[3];   // on the hand, N
  double torque[3];  // on the hand, about the position, N m
} ResectHapticForce;

// Functions that return an int return 0 when all is well. Otherwise last_error() says what is
// wrong.
typedef struct {
  uint32_t version;  // RESECT_HAPTIC_DEVICE_VERSION
  const char* name;  // shown to people
  // Opens a device and fills in its limits. options: text for the plug-in from the command line,
  // never null. Returns null on failure.
  ResectHapticDevice* (*open)(const char* options, ResectHapticLimits* limits);
  // Sets the force to zero and closes the device.
  void (*close)(ResectHapticDevice* device);
  int (*read)(ResectHapticDevice* device, ResectHapticPose* pose);
  // The force acts until the next write().
  int (*write)(ResectHapticDevice* device, const ResectHapticForce* force);
  // One sentence about the last failure. device: null after a failed open(). The text is valid
  // until the next call.
  const char* (*last_error)(ResectHapticDevice* device);
  // For devices that play a person: where that person wants the tip to be, told before each read().
  // Null for real devices.
  void (*intend)(ResectHapticDevice* device, const ResectHapticPose* pose);
} ResectHapticDeviceFunctions;

// The table lives as long as the library is loaded. The plug-in defines this function, and exports
// it under this name.
const ResectHapticDeviceFunctions* resect_haptic_device(void);

#ifdef __cplusplus
}
#endif
