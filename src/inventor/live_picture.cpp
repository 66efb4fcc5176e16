#define GL_GLEXT_PROTOTYPES
#include "inventor/live_picture.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace resect {
namespace {

constexpr double kScales[] = {1.0, 0.75, 0.5, 0.4};
// Share of the picture. All of it with fewer pixels costs all of the triangles.
constexpr double kMostInParts = 0.4;
constexpr int kSmoothSamples = 4;
constexpr int kShadowInterval = 3;  // pictures

}  // namespace

// Colours and depths to draw into.
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

struct LivePicture::Context {
  Buffer shown, smooth, coarse;
  std::string renderer;
  bool processorDraws = false;
  std::unique_ptr<SoGLRenderAction> action;
};

LivePicture::LivePicture() : context_(std::make_unique<Context>()) {
  Context& c = *context_;
  if (const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER))) c.renderer = name;
  setProcessorDraws(c.renderer.find("llvmpipe") != std::string::npos ||
                    c.renderer.find("softpipe") != std::string::npos);
  c.action = std::make_unique<SoGLRenderAction>(SbViewportRegion(64, 64));
  c.action->setCacheContext(SoGLCacheContextElement::getUniqueCacheContext());
}

LivePicture::~LivePicture() {
  Context& c = *context_;
  SoContextHandler::destructingContext(c.action->getCacheContext());
  for (Buffer* buffer : {&c.shown, &c.smooth, &c.coarse}) buffer->free();
}

const char* LivePicture::renderer() const { return context_->renderer.c_str(); }
bool LivePicture::processorDraws() const { return context_->processorDraws; }
void LivePicture::setProcessorDraws(bool draws) { context_->processorDraws = draws; }
void LivePicture::setLongestPicture(double seconds) { longest_ = seconds; }
void LivePicture::forget() { context_->shown.free(); }

// All of the scene, or the pixels of `parts`, in one pass. Round the parts the depth buffer says
// that something is nearer than all else: no pixel is worked out there.
void LivePicture::drawParts(SoNode* scene, const Buffer& buffer, std::span<const PixelRect> parts) {
  glBindFramebuffer(GL_FRAMEBUFFER, buffer.framebuffer);
  glViewport(0, 0, buffer.width, buffer.height);
  glClearColor(0, 0, 0, 1);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
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
  // Coin switches a scissor test off that it does not know of. The quarters: it cuts off fractions.
  SoGLRenderAction& action = *context_->action;
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

void LivePicture::draw(SoNode* scene, const SoPerspectiveCamera& camera, const Damage& damage,
                       const SbVec2s& size, bool full, unsigned framebuffer) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Context& c = *context_;
  const int width = size[0], height = size[1];
  const bool nothing = c.shown.width != width || c.shown.height != height;
  c.shown.make(width, height, 1);
  const auto copy = [](const Buffer& from, const PixelRect& a, GLuint to, const PixelRect& b,
                       GLenum filter) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(a.left, a.bottom, a.right, a.top, b.left, b.bottom, b.right, b.top,
                      GL_COLOR_BUFFER_BIT, filter);
  };
  const PixelRect whole{0, 0, width, height};
  late_.add({false, {}, damage.shadows});
  Damage now{nothing || damage.everything, damage.boxes, {}};
  if (full || damage.boxes.empty() || ++pictures_ % kShadowInterval == 0)
    now.shadows = std::exchange(late_, {}).shadows;
  const std::vector<PixelRect> parts = pixelsOf(now, camera, SbViewportRegion(size));
  drawnPixels_ = 0;
  if (full || !c.processorDraws) {
    c.smooth.make(width, height, kSmoothSamples);
    drawParts(scene, c.smooth, std::span(&whole, 1));
    copy(c.smooth, whole, c.shown.framebuffer, whole, GL_NEAREST);
  } else {
    const bool coarse = double(area(parts)) > kMostInParts * width * height;
    if (coarse) {
      c.coarse.make(std::max(16, int(width * scale_)), std::max(16, int(height * scale_)), 1);
      const PixelRect small{0, 0, c.coarse.width, c.coarse.height};
      drawParts(scene, c.coarse, std::span(&small, 1));
      copy(c.coarse, small, c.shown.framebuffer, whole, GL_LINEAR);
    } else if (!parts.empty()) {
      drawParts(scene, c.shown, parts);
    }
    if (!parts.empty()) {
      glFinish();
      if (coarse) adapt(std::chrono::duration<double>(Clock::now() - begin).count());
    }
  }
  copy(c.shown, whole, framebuffer, whole, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

// One step to fewer pixels when the picture took too long, to more when there was time to spare.
void LivePicture::adapt(double seconds) {
  const auto* at = std::ranges::find(kScales, scale_);
  if (seconds > longest_ && at + 1 != std::end(kScales))
    ++at;
  else if (seconds < 0.45 * longest_ && at != std::begin(kScales))
    --at;
  scale_ = *at;
}

}  // namespace resect
