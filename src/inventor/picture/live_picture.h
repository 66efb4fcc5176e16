// A picture of a scene that is updated where the scene has changed.
//
// On a graphics card every picture is drawn whole, with antialiased edges. With software rendering
// only the changed parts are drawn, soft shadows in every third to eighth picture; parts that are
// too large for the frame rate are drawn at reduced resolution. Once nothing moves, the caller
// requests the antialiased picture strip by strip. Only changed pixels are read back.
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

  bool processorDraws() const;             // software rendering: no graphics card
  void setProcessorDraws(bool draws);      // overrides it, for tests
  void setLongestPicture(double seconds);  // longer pictures, in motion, reduce the resolution

  // Whether the next picture will include soft shadows; if not, their maps need no update.
  bool shadowsAreDue(const Damage& damage) const;
  // Draws the damaged parts of the scene, which contains `camera`. Returns the pixels that may have
  // changed; valid until the next call.
  std::span<const PixelRect> draw(SoNode* scene, const SoPerspectiveCamera& camera,
                                  const Damage& damage, const SbVec2s& size);
  // Draws strip `strip` of `strips`, from below, of the antialiased picture; the scene and the size
  // must be those of the last draw().
  PixelRect drawSmooth(SoNode* scene, int strip, int strips);
  // Copies pixels as 0xffRRGGBB to `topLeft`, top row first, rows `stride` pixels apart.
  void read(const PixelRect& part, std::uint32_t* topLeft, std::ptrdiff_t stride);
  // Discards the picture: the next one is drawn whole.
  void forget();

  double scale() const { return scale_; }  // resolution in motion, as a fraction of full
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
  Damage late_;  // damage of shadows not drawn yet
  std::vector<PixelRect> parts_;
  std::vector<std::uint32_t> rows_;  // for read()
  int sinceShadows_ = 0;             // pictures
  double plain_ = 0, shadowed_ = 0;  // recent time of pictures without and with new shadows, s
};

}  // namespace resect
