#define GL_GLEXT_PROTOTYPES
#include "inventor/picture/live_picture.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stage_clock.h"
#include "inventor/picture/offscreen_context.h"

namespace resect {
namespace {

// Resolutions at which tiles of 16 pixels have whole sizes.
constexpr double kScales[] = {1.0, 0.875, 0.75, 0.5, 0.375, 0.3125, 0.25};
constexpr double kMostSharp =
    0.16;  // damaged fraction of the picture up to which resolution is never reduced
constexpr int kSmoothSamples = 4;
// Interval between pictures with new soft shadows, as short as the frame rate allows.
constexpr int kShortestInterval = 3, kLongestInterval = 8;

double square(double x) { return x * x; }

}  // namespace

// Framebuffer with colour and depth.
struct LivePicture::Buffer {
  GLuint framebuffer = 0, storage[2] = {};
  int width = 0, height = 0;

  void make(int w, int h, int samples) {
    if (width == w && height == h) return;
    free();
    width = w, height = h;
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    samples = std::min(samples, int(most));
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, storage);
    const std::pair<GLenum, GLenum> kinds[] = {{GL_RGBA8, GL_COLOR_ATTACHMENT0},
                                               {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT}};
    for (int k = 0; k < 2; ++k) {
      glBindRenderbuffer(GL_RENDERBUFFER, storage[k]);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, kinds[k].first,
                                       w, h);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, kinds[k].second, GL_RENDERBUFFER, storage[k]);
    }
  }
  void free() {
    if (!framebuffer) return;
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, storage);
    *this = {};
  }
};

// Resolves multisampling, or stretches.
void LivePicture::copy(const Buffer& from, const PixelRect& a, const Buffer& to,
                       const PixelRect& b) {
  const bool sameSize =
      a.right - a.left == b.right - b.left && a.top - a.bottom == b.top - b.bottom;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
  glBlitFramebuffer(a.left, a.bottom, a.right, a.top, b.left, b.bottom, b.right, b.top,
                    GL_COLOR_BUFFER_BIT, sameSize ? GL_NEAREST : GL_LINEAR);
}

struct LivePicture::Context {
  OffscreenContext gl;
  Buffer shown, smooth, coarse;
  bool processorDraws = gl.processorDraws();
  SoGLRenderAction action{SbViewportRegion(64, 64)};

  ~Context() {
    if (!gl.becomesCurrent()) return;
    for (Buffer* buffer : {&shown, &smooth, &coarse}) buffer->free();
  }
};

LivePicture::LivePicture() : context_(std::make_unique<Context>()) {
  context_->action.setCacheContext(context_->gl.cacheContext());
}

LivePicture::~LivePicture() = default;

bool LivePicture::processorDraws() const { return context_->processorDraws; }
void LivePicture::setProcessorDraws(bool draws) { context_->processorDraws = draws; }
void LivePicture::setLongestPicture(double seconds) { longest_ = seconds; }
void LivePicture::setSharp(bool sharp) { sharp_ = sharp; }
void LivePicture::forget() {
  context_->gl.makeCurrent();
  context_->shown.free();
}

// Draws the whole scene, or the pixels of `parts`, in one pass. Outside the parts the depth buffer
// is set to the nearest depth, so no pixel is shaded there.
void LivePicture::drawParts(SoNode* scene, const Buffer& buffer, std::span<const PixelRect> parts) {
  beginPicture(buffer.framebuffer, buffer.width, buffer.height);
  const auto clip = [](const PixelRect& part) {
    glScissor(part.left, part.bottom, part.right - part.left, part.top - part.bottom);
  };
  PixelRect all{buffer.width, buffer.height, 0, 0};
  for (const PixelRect& part : parts) all = joined(all, part);
  glEnable(GL_SCISSOR_TEST);
  clip(all);
  if (parts.size() > 1) {
    glClearDepth(0.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glClearDepth(1.0);
  }
  for (const PixelRect& part : parts) {
    clip(part);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawnPixels_ += part.area();
  }
  // The scissor box is set through Coin, which disables a scissor test that it did not set.
  // Quarters are added since Coin truncates fractions.
  SoGLRenderAction& action = context_->action;
  const SbVec2f size(float(buffer.width), float(buffer.height));
  const bool inPart = all.area() < std::int64_t(buffer.width) * buffer.height;
  const auto share = [&](int x, int y) {
    return SbVec2f((float(x) + 0.25f) / size[0], (float(y) + 0.25f) / size[1]);
  };
  action.setUpdateArea(inPart ? share(all.left, all.bottom) : SbVec2f(0, 0),
                       inPart ? share(all.right - all.left, all.top - all.bottom) : SbVec2f(1, 1));
  action.invalidateState();
  action.setViewportRegion(SbViewportRegion(short(buffer.width), short(buffer.height)));
  action.apply(scene);
  glDisable(GL_SCISSOR_TEST);
}

bool LivePicture::shadowsAreDue(const Damage& damage) const {
  const bool nothingElse = !damage.everything && damage.boxes.empty();
  if (!context_->processorDraws || nothingElse || sharp_) return true;
  const double left = std::max(longest_ - plain_, 1e-4);
  const double interval = std::clamp<double>(std::ceil((shadowed_ - plain_) / left),
                                             kShortestInterval, kLongestInterval);
  return sinceShadows_ + 1 >= interval;
}

std::span<const PixelRect> LivePicture::draw(SoNode* scene, const SoPerspectiveCamera& camera,
                                             const Damage& damage, const SbVec2s& size) {
  Context& c = *context_;
  c.gl.makeCurrent();
  const int width = size[0], height = size[1];
  const PixelRect whole{0, 0, width, height};
  const bool nothing = c.shown.width != width || c.shown.height != height;
  c.shown.make(width, height, 1);
  drawnPixels_ = 0;
  reduced_ = false;
  if (!c.processorDraws) {
    drawSmooth(scene, 0, 1);
    parts_.assign(1, whole);
    return parts_;
  }
  late_.add({false, {}, damage.shadows});
  Damage now{nothing || damage.everything, damage.boxes, {}};
  const bool withShadows = shadowsAreDue(damage);
  if (withShadows) now.shadows = std::exchange(late_, {}).shadows;
  if (!damage.empty()) sinceShadows_ = withShadows ? 0 : sinceShadows_ + 1;
  parts_ = pixelsOf(now, camera, SbViewportRegion(size));
  if (parts_.empty()) return parts_;
  const double begin = steadySeconds();
  const bool sharp = sharp_ || double(area(parts_)) < kMostSharp * width * height;
  reduced_ = !sharp && scale_ != 1;
  if (reduced_) {
    drawCoarse(scene);
  } else {
    drawParts(scene, c.shown, parts_);
  }
  glFinish();
  const double seconds = steadySeconds() - begin;
  double& usual = withShadows ? shadowed_ : plain_;
  usual = usual == 0 ? seconds : 0.7 * usual + 0.3 * seconds;
  if (!sharp && (!withShadows || now.everything)) adapt(seconds);
  return parts_;
}

// Draws at reduced resolution, stretched over the parts.
void LivePicture::drawCoarse(SoNode* scene) {
  Context& c = *context_;
  const auto coarse = [&](int edge) { return int(std::lround(edge * scale_)); };
  c.coarse.make(std::max(16, coarse(c.shown.width)), std::max(16, coarse(c.shown.height)), 1);
  std::vector<PixelRect> small, drawn;
  for (const PixelRect& part : parts_) {
    const PixelRect s{coarse(part.left), coarse(part.bottom), coarse(part.right), coarse(part.top)};
    small.push_back(s);
    // One pixel more on each side, for the interpolation of stretching.
    drawn.push_back({std::max(s.left - 1, 0), std::max(s.bottom - 1, 0),
                     std::min(s.right + 1, c.coarse.width), std::min(s.top + 1, c.coarse.height)});
  }
  drawParts(scene, c.coarse, drawn);
  for (std::size_t i = 0; i < small.size(); ++i) copy(c.coarse, small[i], c.shown, parts_[i]);
}

PixelRect LivePicture::stripRect(int first, int end, int strips) const {
  const Buffer& shown = context_->shown;
  const auto edge = [&](int i) { return int(std::int64_t(shown.height) * i / strips); };
  return {0, edge(first), shown.width, edge(end)};
}

PixelRect LivePicture::drawSharp(SoNode* scene, int first, int end, int strips) {
  Context& c = *context_;
  c.gl.makeCurrent();
  const PixelRect part = stripRect(first, end, strips);
  drawnPixels_ = 0;
  drawParts(scene, c.shown, std::span(&part, 1));
  return part;
}

PixelRect LivePicture::drawSmooth(SoNode* scene, int strip, int strips) {
  Context& c = *context_;
  c.gl.makeCurrent();
  c.smooth.make(c.shown.width, c.shown.height, kSmoothSamples);
  const PixelRect part = stripRect(strip, strip + 1, strips);
  drawnPixels_ = 0;
  drawParts(scene, c.smooth, std::span(&part, 1));
  copy(c.smooth, part, c.shown, part);
  if (strip + 1 == strips) late_ = {};
  return part;
}

void LivePicture::read(const PixelRect& part, std::uint32_t* topLeft, std::ptrdiff_t stride) {
  if (part.empty()) return;
  context_->gl.makeCurrent();
  const int width = part.right - part.left, height = part.top - part.bottom;
  rows_.resize(std::size_t(part.area()));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, context_->shown.framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(part.left, part.bottom, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
               rows_.data());
  for (int y = 0; y < height; ++y)
    std::copy_n(&rows_[std::size_t(height - 1 - y) * width], width, topLeft + y * stride);
}

// Lowers the resolution one step if the picture took too long, raises it if there was time to
// spare.
void LivePicture::adapt(double seconds) {
  const auto* at = std::ranges::find(kScales, scale_);
  if (seconds > longest_ && at + 1 != std::end(kScales))
    ++at;
  else if (at != std::begin(kScales) && seconds * square(at[-1] / *at) < 0.8 * longest_)
    --at;  // assuming that time is proportional to pixels
  scale_ = *at;
}

}  // namespace resect
