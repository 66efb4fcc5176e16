// A picture of a scene. It is kept, and drawn again after changes of the scene.
//
// With a graphics card the whole picture is drawn again after each change, with antialiased edges.
// Software rendering is slower, so these measures save time:
// - Only the changed parts are drawn.
// - While the scene changes, changed soft shadows are drawn only in every third to eighth picture.
// - If drawing takes longer than setLongestPicture() allows, large changed parts are drawn at a
//   lower resolution.
// - Edges are not antialiased while the scene changes. When nothing moves any more, the caller
//   requests an antialiased picture from drawSmooth(), strip by strip. Parts that were drawn at a
//   lower resolution are first drawn at full resolution by drawSharp().
// The caller needs to read only the pixels that may have changed (read()).
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
  // Makes an offscreen context for the picture. Throws an Error of one sentence if this is not
  // possible.
  LivePicture();
  ~LivePicture();
  LivePicture(const LivePicture&) = delete;
  LivePicture& operator=(const LivePicture&) = delete;

  bool processorDraws() const;             // whether OpenGL renders in software
  void setProcessorDraws(bool draws);      // for tests: sets what processorDraws() returns
  void setLongestPicture(double seconds);  // sets the longest drawing time without low resolution
  // If `sharp` is true, the resolution is never reduced, and changed soft shadows are drawn at
  // once.
  void setSharp(bool sharp);

  // Whether a call of draw() with this damage will draw changed soft shadows. If not, the shadow
  // maps need no update before that call.
  bool shadowsAreDue(const Damage& damage) const;
  // Draws the damaged parts of the scene. The scene must contain `camera`. size: size of the
  // picture, pixels. Returns rectangles that contain all pixels that may have changed. The result
  // is valid until the next call of draw().
  std::span<const PixelRect> draw(SoNode* scene, const SoPerspectiveCamera& camera,
                                  const Damage& damage, const SbVec2s& size);
  // Divides the picture into horizontal strips, and draws one strip again with antialiased edges.
  // strip: number of this strip; the lowest strip has the number 0. strips: number of strips.
  // `scene` must be the scene of the last draw(). Returns the rectangle of the strip.
  PixelRect drawSmooth(SoNode* scene, int strip, int strips);
  // Draws the strips from `first` up to, not including, `end` at full resolution, not antialiased.
  // This takes about a third of the time that drawSmooth() takes.
  PixelRect drawSharp(SoNode* scene, int first, int end, int strips);
  // Copies the pixels of `part` in the form 0xffRRGGBB. The top row is written from `topLeft` on.
  // Each further row begins `stride` pixels after the start of the row above it.
  void read(const PixelRect& part, std::uint32_t* topLeft, std::ptrdiff_t stride);
  // Discards the picture. So the next draw() draws the whole picture.
  void forget();

  // Resolution at which large changes are drawn, along each axis, as a fraction of the full
  // resolution.
  double scale() const { return scale_; }
  // Whether the last draw() reduced the resolution.
  bool reduced() const { return reduced_; }
  // Number of pixels that the last draw() or drawSmooth() has drawn.
  std::int64_t drawnPixels() const { return drawnPixels_; }

 private:
  struct Buffer;
  struct Context;

  PixelRect stripRect(int first, int end, int strips) const;
  static void copy(const Buffer& from, const PixelRect& a, const Buffer& to, const PixelRect& b);
  void drawParts(SoNode* scene, const Buffer& buffer, std::span<const PixelRect> parts);
  void drawCoarse(SoNode* scene);
  void adapt(double seconds);

  std::unique_ptr<Context> context_;
  // scale_: see scale(). longest_: longest drawing time without low resolution, s.
  double scale_ = 1, longest_ = 0.028;
  std::int64_t drawnPixels_ = 0;
  Damage late_;  // changes of soft shadows that have not been drawn yet
  std::vector<PixelRect> parts_;
  std::vector<std::uint32_t> rows_;  // work space of read()
  bool sharp_ = false, reduced_ = false;
  int sinceShadows_ = 0;  // number of pictures since changed shadows were drawn last
  // Moving averages of drawing times, s: of pictures without changed shadows (plain_), and of
  // pictures with them (shadowed_).
  double plain_ = 0, shadowed_ = 0;
};

}  // namespace resect
