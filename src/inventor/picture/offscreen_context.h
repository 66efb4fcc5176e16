// An offscreen OpenGL context, for the window and for machines without a display.
//
// An EGL context without a surface, on the first graphics card or else in software. Needs no X
// server and no environment variable.
#pragma once

#include <cstdint>
#include <string>

namespace resect {

class OffscreenContext {
 public:
  // Current when made. Throws Error in one sentence when EGL or OpenGL is missing.
  OffscreenContext();
  // Coin frees its objects of this context; framebuffers must be freed before.
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent() const;     // throws Error on failure
  bool becomesCurrent() const;  // the same for destructors: false on failure
  const char* renderer() const { return renderer_.c_str(); }  // "llvmpipe (LLVM 15.0.6, 256 bits)"
  bool processorDraws() const;                        // software rendering: no graphics card
  std::uint32_t cacheContext() const { return id_; }  // Coin's number for it

 private:
  void *display_ = nullptr, *egl_ = nullptr;
  std::uint32_t id_ = 0;
  std::string renderer_;
};

// Binds a framebuffer of the current context and sets the state in which a scene is drawn from
// anew: the whole viewport, background black, depths tested and written. The caller clears.
void beginPicture(std::uint32_t framebuffer, int width, int height);

}  // namespace resect
