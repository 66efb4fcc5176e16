// An offscreen OpenGL context, for the window and for machines without a display.
//
// The context is made by EGL, without a surface: on the first graphics card that works, otherwise
// with software rendering. It needs no X server and no environment variable.
#pragma once

#include <cstdint>
#include <string>

namespace resect {

class OffscreenContext {
 public:
  // The new context is current. Throws Error in one sentence if EGL or OpenGL is missing.
  OffscreenContext();
  // Lets Coin free its objects of this context. The caller must have freed its framebuffers before.
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent() const;     // throws Error on failure
  bool becomesCurrent() const;  // the same for destructors: returns false on failure
  const char* renderer() const { return renderer_.c_str(); }  // "llvmpipe (LLVM 15.0.6, 256 bits)"
  bool processorDraws() const;                        // software rendering: no graphics card
  std::uint32_t cacheContext() const { return id_; }  // Coin's number of this context

 private:
  void *display_ = nullptr, *egl_ = nullptr;
  std::uint32_t id_ = 0;
  std::string renderer_;
};

// Binds a framebuffer of the current context and sets OpenGL's state for drawing a whole scene: the
// full viewport, a black background, depths tested and written. Clears nothing: the caller does.
void beginPicture(std::uint32_t framebuffer, int width, int height);

}  // namespace resect
