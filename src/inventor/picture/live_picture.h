// A picture of a scene that is kept and drawn again only where the scene has changed.
//
// With a graphics card every picture is drawn whole, with antialiased edges. With software
// rendering there are these economies:
// - Only the changed parts are drawn.
// - While the scene changes, soft shadows are renewed only in every third to eighth picture.
// - If drawing takes too long for the frame rate, large changed parts are drawn at reduced
//   resolution.
// - Edges are not antialiased. Once nothing moves, the caller requests an antialiased picture,
//   strip by strip, from drawSmooth().
// The caller need read back only the pixels that may have changed.
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
  // The picture is drawn in an offscreen context of its own. Throws Error, with one sentence, if
  // this context cannot be made.
  LivePicture();
  ~LivePicture();
  LivePicture(const LivePicture&) = delete;
  LivePicture& operator=(const LivePicture&) = delete;

  bool processorDraws() const;             // whether OpenGL renders in software
  void setProcessorDraws(bool draws);      // for tests: sets processorDraws()
  void setLongestPicture(double seconds);  // the resolution is reduced if drawing takes longer
  void setSharp(bool sharp);  // sharp: the resolution is never reduced, and no shadow is late

  // Whether draw(), if it is called with this damage, will draw the changed soft shadows too. If
  // not, the shadow maps need no update before that call.
  bool shadowsAreDue(const Damage& damage) const;
  // Draws the damaged parts of the scene. The scene must contain `camera`. size: of the picture,
  // pixels. Returns rectangles that contain all pixels that may have changed; they are valid until
  // the next call of draw().
  std::span<const PixelRect> draw(SoNode* scene, const SoPerspectiveCamera& camera,
                                  const Damage& damage, const SbVec2s& size);
  // Divides the picture into `strips` horizontal strips and draws one of them again, with
  // antialiased edges. strip: its number, from 0 at the bottom. The scene must be that of the last
  // draw(). Returns the rectangle of the strip.
  PixelRect drawSmooth(SoNode* scene, int strip, int strips);
  // Copies the pixels of `part` as 0xffRRGGBB. The top row goes to `topLeft`; each row below it
  // begins `stride` pixels after the start of the row above.
  void read(const PixelRect& part, std::uint32_t* topLeft, std::ptrdiff_t stride);
  // Discards the picture: the next draw() draws all of it.
  void forget();

  // Resolution along each axis at which large changes are drawn, as a fraction of the full one.
  double scale() const { return scale_; }
  std::int64_t drawnPixels() const { return drawnPixels_; }  // by the last draw() or drawSmooth()

 private:
  struct Buffer;
  struct Context;

  static void copy(const Buffer& from, const PixelRect& a, const Buffer& to, const PixelRect& b);
  void drawParts(SoNode* scene, const Buffer& buffer, std::span<const PixelRect> parts);
  void drawCoarse(SoNode* scene);
  void adapt(double seconds);

  std::unique_ptr<Context> context_;
  double scale_ = 1, longest_ = 0.028;  // resolution, see scale(); longest drawing time, s
  std::int64_t drawnPixels_ = 0;
  Damage late_;  // changes of soft shadows that have not been drawn yet
  std::vector<PixelRect> parts_;
  std::vector<std::uint32_t> rows_;  // work space of read()
  bool sharp_ = false;
  int sinceShadows_ = 0;  // pictures since the last one with new shadows
  // Moving averages of the drawing times without and with new shadows, s.
  double plain_ = 0, shadowed_ = 0;
};

}  // namespace resect
