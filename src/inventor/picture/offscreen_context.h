// An OpenGL context for drawing into framebuffers. It works on machines without a display. The
// pictures in the program's window are drawn in such a context, too.
//
// The context is made by EGL and has no EGL surface. The context uses the first graphics card that
// works. If no graphics card works, the context uses software rendering. No X server and no
// environment variable is needed.
#pragma once

#include <cstdint>
#include <string>

namespace resect {

class OffscreenContext {
 public:
  // Makes the context current. Throws Error if EGL or OpenGL is missing.
  OffscreenContext();
  // Makes Coin (the Open Inventor library) free its OpenGL objects in this context. The caller must
  // delete its own framebuffers before the context is destroyed.
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent() const;     // throws Error on failure
  bool becomesCurrent() const;  // like makeCurrent(), but returns false on failure
  // OpenGL's name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  const char* renderer() const { return renderer_.c_str(); }
  bool processorDraws() const;  // whether renderer() is a software renderer of Mesa
  std::uint32_t cacheContext() const { return id_; }  // Coin's number of this context

 private:
  void *display_ = nullptr, *egl_ = nullptr;
  std::uint32_t id_ = 0;  // cacheContext()
  std::string renderer_;
};

// Binds a framebuffer of the current context, and sets OpenGL's state for drawing a whole scene.
// The viewport is the whole framebuffer, the clear colour is black, and depths are tested and
// written. The function does not clear the framebuffer.
void beginPicture(std::uint32_t framebuffer, int width, int height);

}  // namespace resect
