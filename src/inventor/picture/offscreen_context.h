// Where does OpenGL draw, in the window and where there is no display?
//
// An EGL context without a surface, on the first graphics card or, where there is none, on the
// processor. No X, no environment variable.
#pragma once

#include <cstdint>
#include <string>

namespace resect {

class OffscreenContext {
 public:
  // Current when made. Throws Error in one sentence when EGL or OpenGL is missing.
  OffscreenContext();
  // Coin frees what it keeps for this context; framebuffers must be freed before.
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent() const;     // throws Error where that fails
  bool becomesCurrent() const;  // the same for destructors: false where that fails
  const char* renderer() const { return renderer_.c_str(); }  // "llvmpipe (LLVM 15.0.6, 256 bits)"
  bool processorDraws() const;                                // there is no graphics card
  std::uint32_t cacheContext() const { return id_; }          // Coin's number for it

 private:
  void *display_ = nullptr, *egl_ = nullptr;
  std::uint32_t id_ = 0;
  std::string renderer_;
};

}  // namespace resect
