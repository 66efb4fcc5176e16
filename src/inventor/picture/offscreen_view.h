// Draws pictures of a scene without a display.
//
// An OffscreenView keeps an offscreen context and a multisampled framebuffer. So buffers, textures
// and shaders are made only once for many pictures. The scene must contain a camera and lights.
#pragma once

#include <memory>

#include "formats/png_file.h"
#include "inventor/picture/picture_quality.h"

class SoNode;

namespace resect {

class OffscreenView {
 public:
  // width, height: size of the pictures, 16 to 8192 pixels each. samples: number of samples per
  // pixel; 1 means no antialiasing. If the driver does not support so many samples, the largest
  // number that it supports is used. Throws Error if the size is out of range, if the driver
  // refuses the size, or if EGL or OpenGL is missing. The size times quality.enlarged must be 16 to
  // 8192 pixels, too. quality.shadowTexels is not used here.
  OffscreenView(int width, int height, int samples = 4)
      : OffscreenView(width, height, PictureQuality{.samples = samples}) {}
  OffscreenView(int width, int height, const PictureQuality& quality);
  ~OffscreenView();
  OffscreenView(const OffscreenView&) = delete;
  OffscreenView& operator=(const OffscreenView&) = delete;

  int width() const;
  int height() const;

  // Draws a picture of the scene. The same scene and the same renderer always give the same bytes.
  // Throws Error if a shader of the scene does not compile. (Without this check, Inventor would
  // draw flat colours instead.)
  RgbImage render(SoNode* scene);

  // Name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  const char* renderer() const;

 private:
  RgbImage read();

  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace resect
