// How is a picture of a scene kept up to date at the cost of what has changed in it?
//
// On a graphics card every picture is drawn whole, with smooth edges. Where the processor draws,
// only the changed parts are drawn again, soft shadows in every third picture; when the parts are
// too large for the frame rate, all is drawn with fewer pixels. Whoever shows it asks for a full
// picture once nothing moves any more.
#pragma once

#include <Inventor/SbVec2s.h>

#include <cstdint>
#include <memory>
#include <span>

#include "inventor/damage.h"

class SoNode;
class SoPerspectiveCamera;

namespace resect {

class LivePicture {
 public:
  // Made, used and ended with one and the same OpenGL context current.
  LivePicture();
  ~LivePicture();
  LivePicture(const LivePicture&) = delete;
  LivePicture& operator=(const LivePicture&) = delete;

  const char* renderer() const;            // e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  bool processorDraws() const;             // there is no graphics card
  void setProcessorDraws(bool draws);      // as if so, for tests
  void setLongestPicture(double seconds);  // beyond this, in motion, fewer pixels are drawn

  // Draws the scene, in which `camera` is, as far as `damage` reaches, or whole and smooth when
  // `full`, and copies the picture to a framebuffer of the same size.
  void draw(SoNode* scene, const SoPerspectiveCamera& camera, const Damage& damage,
            const SbVec2s& size, bool full, unsigned framebuffer);
  // The next picture will be drawn whole.
  void forget();

  double scale() const { return scale_; }  // share of the pixels' rows drawn in motion
  std::int64_t drawnPixels() const { return drawnPixels_; }  // by the last draw()

 private:
  struct Buffer;
  struct Context;

  void drawParts(SoNode* scene, const Buffer& buffer, std::span<const PixelRect> parts);
  void adapt(double seconds);

  std::unique_ptr<Context> context_;
  double scale_ = 1, longest_ = 0.028;
  std::int64_t drawnPixels_ = 0;
  Damage late_;  // shadows not drawn yet
  int pictures_ = 0;
};

}  // namespace resect
