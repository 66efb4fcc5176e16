// A picture of a scene, drawn again only where the scene has changed.
//
// On a graphics card every picture is drawn whole, with antialiased edges. With software rendering
// only the changed parts are drawn, and new soft shadows only in every third to eighth picture.
// Parts that are too large for the frame rate are drawn at reduced resolution. Once nothing moves,
// the caller requests the antialiased picture strip by strip. Only pixels that may have changed
// need be read back.
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
  void setProcessorDraws(bool draws);      // overrides processorDraws(), for tests
  void setLongestPicture(double seconds);  // drawing time above which the resolution is reduced

  // Whether draw() will draw the changed soft shadows too; if not, the shadow maps need no update.
  bool shadowsAreDue(const Damage& damage) const;
  // Draws the damaged parts of the scene, which contains `camera`. Returns the pixels that may have
  // changed; valid until the next call.
  std::span<const PixelRect> draw(SoNode* scene, const SoPerspectiveCamera& camera,
                                  const Damage& damage, const SbVec2s& size);
  // Divides the picture into `strips` horizontal strips and draws strip number `strip`, counted
  // from 0 at the bottom, with antialiased edges. Scene and size must be those of the last draw().
  PixelRect drawSmooth(SoNode* scene, int strip, int strips);
  // Copies the pixels of `part` as 0xffRRGGBB: the top row to `topLeft`, each next row `stride`
  // pixels further.
  void read(const PixelRect& part, std::uint32_t* topLeft, std::ptrdiff_t stride);
  // Discards the picture: the next one is drawn whole.
  void forget();

  // Resolution along each axis while much of the picture changes, as a fraction of the full one.
  double scale() const { return scale_; }
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
  Damage late_;  // changes of soft shadows that are not drawn yet
  std::vector<PixelRect> parts_;
  std::vector<std::uint32_t> rows_;  // for read()
  int sinceShadows_ = 0;             // pictures since the last one with new shadows
  double plain_ = 0, shadowed_ = 0;  // recent drawing times without and with new shadows, s
};

}  // namespace resect
