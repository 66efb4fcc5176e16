// The interface of a plug-in for a haptic device, in C. The author of a plug-in needs no other
// header of Resect.
//
// A plug-in is a shared library with one function, resect_haptic_device(), which returns a table of
// functions. Resect opens the library at run time; neither is linked against the other. The thread
// that calls open() then calls intend() and read() once. After that, another thread calls intend(),
// read() and write() 1000 times a second. None of these three may wait, allocate, or take longer
// than 0.1 ms. docs/how-to/haptic_device.md has a complete example.
//
// Coordinates: metres, newtons, seconds; right-handed, X to the right, Y up, Z towards the person.
// The plug-in rotates and moves the device's coordinates so that the centre of the workspace is at
// the origin. Resect places that origin in the world.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Changes whenever something below changes.
#define RESECT_HAPTIC_DEVICE_VERSION 1

// An open device. Only the plug-in knows the content of this struct.
typedef struct ResectHapticDevice ResectHapticDevice;

typedef struct {
  double most_force;   // largest force that the device can hold for long, N, > 0
  double most_torque;  // the same for the torque, N m; 0: the device renders no torque
} ResectHapticLimits;

typedef struct {
  double position[3];  // of the tip, m
  double rotation[4];  // unit quaternion x, y, z, w; identity if the device measures none
  uint32_t buttons;    // bit i: button i is held down
} ResectHapticPose;

typedef struct {
  double force[3];   // on the hand, N
  double torque[3];  // on the hand, about the tip, N m
} ResectHapticForce;

// Functions that return an int return 0 on success. Otherwise last_error() describes the failure.
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
  // until the next call of a function of this table.
  const char* (*last_error)(ResectHapticDevice* device);
  // For devices that play a person (simulate the hand that holds the instrument): called before
  // each read() with the pose that this person wants the tip to have. Null for real devices.
  void (*intend)(ResectHapticDevice* device, const ResectHapticPose* pose);
} ResectHapticDeviceFunctions;

// The plug-in defines this function and exports it under this name. The table must stay valid as
// long as the library is loaded.
const ResectHapticDeviceFunctions* resect_haptic_device(void);

#ifdef __cplusplus
}
#endif
