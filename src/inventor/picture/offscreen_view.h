// Draws a scene to a picture without a display.
//
// Keeps an offscreen context and a multisampled framebuffer, so that buffers, textures and shaders
// are made only once for many pictures. The scene must contain a camera and lights.
#pragma once

#include <memory>

#include "formats/png_file.h"

class SoNode;

namespace resect {

class OffscreenView {
 public:
  // `width`, `height`: 16 to 8192 pixels. `samples`: number of samples per pixel; 1: no
  // antialiasing. If the driver supports only fewer samples, its largest number is used. Throws
  // Error if EGL or OpenGL is missing, or if the size is refused.
  OffscreenView(int width, int height, int samples = 4);
  ~OffscreenView();
  OffscreenView(const OffscreenView&) = delete;
  OffscreenView& operator=(const OffscreenView&) = delete;

  int width() const;
  int height() const;

  // Draws a picture of the scene. The same scene gives the same bytes with the same renderer.
  // Throws Error if a shader of the scene does not compile; Inventor by itself would go on with
  // flat colours.
  RgbImage render(SoNode* scene);

  // Name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  const char* renderer() const;

 private:
  RgbImage read();

  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace resect
