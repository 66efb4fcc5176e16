// An OpenGL context for drawing into framebuffers. The window uses it too, and it works on machines
// without a display.
//
// EGL makes the context, without a surface: on the first graphics card that works, otherwise with
// software rendering. It needs no X server and no environment variable.
#pragma once

#include <cstdint>
#include <string>

namespace resect {

class OffscreenContext {
 public:
  // The new context is current afterwards. Throws Error, with one sentence, if EGL or OpenGL is
  // missing.
  OffscreenContext();
  // Lets Coin free the OpenGL objects that it made in this context. The caller must delete its own
  // framebuffers before the context is destroyed.
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent() const;     // throws Error on failure
  bool becomesCurrent() const;  // makeCurrent() for destructors: returns false on failure
  // OpenGL's name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  const char* renderer() const { return renderer_.c_str(); }
  bool processorDraws() const;  // whether renderer() is a software renderer of Mesa
  std::uint32_t cacheContext() const { return id_; }  // Coin's number of this context

 private:
  void *display_ = nullptr, *egl_ = nullptr;
  std::uint32_t id_ = 0;  // cacheContext()
  std::string renderer_;
};

// Binds a framebuffer of the current context and sets OpenGL's state for drawing a whole scene: the
// full viewport, black as the colour to clear with, depths tested and written. The function itself
// clears nothing.
void beginPicture(std::uint32_t framebuffer, int width, int height);

}  // namespace resect
