// How is a picture of a scene kept up to date at the cost of what has changed in it?
//
// On a graphics card every picture is drawn whole, with smooth edges. Where the processor draws,
// only the changed parts are drawn again, soft shadows in every third to eighth picture; when the
// parts are too large for the frame rate, they are drawn with fewer pixels. Whoever shows it asks
// for the smooth picture, strip by strip, once nothing moves any more, and reads only what is new.
#pragma once

#include <Inventor/SbVec2s.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "inventor/gl/damage.h"

class SoNode;
class SoPerspectiveCamera;

namespace resect {

class LivePicture {
 public:
  // Draws in an offscreen context of its own. Throws Error in one sentence when there is none.
  LivePicture();
  ~LivePicture();
  LivePicture(const LivePicture&) = delete;
  LivePicture& operator=(const LivePicture&) = delete;

  bool processorDraws() const;             // there is no graphics card
  void setProcessorDraws(bool draws);      // as if so, for tests
  void setLongestPicture(double seconds);  // beyond this, in motion, fewer pixels are drawn

  // Will soft shadows be drawn in the next picture? Where not, their maps need not be made anew.
  bool shadowsAreDue(const Damage& damage) const;
  // Draws the scene, in which `camera` is, as far as `damage` reaches. Returns where the picture
  // may have changed; valid until the next call.
  std::span<const PixelRect> draw(SoNode* scene, const SoPerspectiveCamera& camera,
                                  const Damage& damage, const SbVec2s& size);
  // Strip `strip` of `strips`, from below, of the smooth picture of a scene that has not changed
  // since it was drawn at this size.
  PixelRect drawSmooth(SoNode* scene, int strip, int strips);
  // Copies pixels as 0xffRRGGBB to `topLeft`, rows from above, `stride` pixels apart.
  void read(const PixelRect& part, std::uint32_t* topLeft, std::ptrdiff_t stride);
  // The next picture will be drawn whole.
  void forget();

  double scale() const { return scale_; }  // share of the pixels' rows drawn in motion
  std::int64_t drawnPixels() const { return drawnPixels_; }  // by the last draw

 private:
  struct Buffer;
  struct Context;

  static void copy(const Buffer& from, const PixelRect& a, const Buffer& to, const PixelRect& b);
  void drawParts(SoNode* scene, const Buffer& buffer, std::span<const PixelRect> parts);
  void drawCoarse(SoNode* scene);
  void adapt(double seconds);

  std::unique_ptr<Context> context_;
  double scale_ = 1, longest_ = 0.028;
  std::int64_t drawnPixels_ = 0;
  Damage late_;  // shadows not drawn yet
  std::vector<PixelRect> parts_;
  std::vector<std::uint32_t> rows_;  // for read()
  int sinceShadows_ = 0;             // pictures
  double plain_ = 0, shadowed_ = 0;  // s that pictures without and with new shadows took lately
};

}  // namespace resect
