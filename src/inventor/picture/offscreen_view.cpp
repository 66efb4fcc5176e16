#include "inventor/picture/offscreen_view.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/nodes/SoNode.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "base/error.h"
#include "inventor/picture/offscreen_context.h"

namespace resect {

namespace {

// Collects Coin's messages about shaders during its lifetime; passes on other messages.
class ShaderComplaints {
 public:
  ShaderComplaints()
      : before_(SoDebugError::getHandlerCallback()), data_(SoDebugError::getHandlerData()) {
    SoDebugError::setHandlerCallback(listen, this);
  }
  ~ShaderComplaints() { SoDebugError::setHandlerCallback(before_, data_); }
  const std::string& text() const { return text_; }

 private:
  static void listen(const SoError* e, void* closure) {
    auto* self = static_cast<ShaderComplaints*>(closure);
    const std::string text = e->getDebugString().getString();
    // Coin queries GLX although EGL is used: harmless.
    if (text.find("glxglue_isdirect") != std::string::npos) return;
    if (text.find("GLSL") != std::string::npos || text.find("hader") != std::string::npos)
      self->text_ += (self->text_.empty() ? "" : "; ") + text;
    else if (self->before_)
      self->before_(e, self->data_);
  }

  SoErrorCB* before_;
  void* data_;
  std::string text_;
};

// Each pixel is the mean of `times` x `times` pixels. Light is averaged and not its code in the
// file: that is about the root of the light.
RgbImage shrunk(const RgbImage& large, int times) {
  RgbImage small{large.width / times, large.height / times, {}};
  small.pixels.resize(std::size_t(3) * small.width * small.height);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        double light = 0;
        for (int j = 0; j < times; ++j)
          for (int i = 0; i < times; ++i) {
            const double code = large.at(times * x + i, times * y + j)[channel];
            light += code * code;
          }
        small.pixels[std::size_t(3) * (std::size_t(y) * small.width + x) + channel] =
            std::uint8_t(std::lround(std::sqrt(light / (times * times))));
      }
  return small;
}

}  // namespace

struct OffscreenView::Buffers {
  int width, height;  // of the buffers, enlarged
  int enlarged;
  OffscreenContext context;
  GLuint drawBuffer = 0, readBuffer = 0, renderBuffers[3] = {};
  SoGLRenderAction action;

  Buffers(int w, int h, const PictureQuality& quality)
      : width(w * quality.enlarged),
        height(h * quality.enlarged),
        enlarged(quality.enlarged),
        action(SbViewportRegion(short(width), short(height))) {
    makeBuffers(quality.samples);
    action.setCacheContext(context.cacheContext());
  }
  ~Buffers() {
    if (!context.becomesCurrent()) return;
    glDeleteFramebuffers(1, &drawBuffer);
    glDeleteFramebuffers(1, &readBuffer);
    glDeleteRenderbuffers(3, renderBuffers);
  }

  void makeBuffers(int samples) {
    GLint most = 1, largest = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (std::max(width, height) > largest)
      throw usageError("a picture of {} x {} pixels is too large for {}; stay below {}", width,
                       height, context.renderer(), largest);
    samples = std::clamp(samples, 1, most);
    glGenFramebuffers(1, &drawBuffer);
    glGenFramebuffers(1, &readBuffer);
    glGenRenderbuffers(3, renderBuffers);
    const auto storage = [&](int which, int n, GLenum format) {
      glBindRenderbuffer(GL_RENDERBUFFER, renderBuffers[which]);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, n > 1 ? n : 0, format, width, height);
    };
    storage(0, samples, GL_RGBA8);
    storage(1, samples, GL_DEPTH24_STENCIL8);
    storage(2, 1, GL_RGBA8);
    glBindFramebuffer(GL_FRAMEBUFFER, readBuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              renderBuffers[2]);
    glBindFramebuffer(GL_FRAMEBUFFER, drawBuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              renderBuffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              renderBuffers[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw error("{} refuses a framebuffer of {} x {} pixels; choose a smaller size",
                  context.renderer(), width, height);
  }
};

OffscreenView::OffscreenView(int width, int height, const PictureQuality& quality) {
  const int most = 8192 / quality.enlarged;
  if (std::min(width, height) < 16 || std::max(width, height) > most)
    throw usageError("a picture of {} x {} pixels is refused{}; choose 16 to {} each way", width,
                     height, quality.enlarged > 1 ? " at this quality" : "", most);
  buffers_ = std::make_unique<Buffers>(width, height, quality);
}

OffscreenView::~OffscreenView() = default;

int OffscreenView::width() const { return buffers_->width / buffers_->enlarged; }
int OffscreenView::height() const { return buffers_->height / buffers_->enlarged; }
const char* OffscreenView::renderer() const { return buffers_->context.renderer(); }

RgbImage OffscreenView::render(SoNode* scene) {
  Buffers& c = *buffers_;
  c.context.makeCurrent();
  beginPicture(c.drawBuffer, c.width, c.height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  const ShaderComplaints complaints;
  scene->ref();
  c.action.apply(scene);
  scene->unrefNoDelete();
  if (!complaints.text().empty())
    throw error("a shader of the scene does not work on {}: {}; please report this",
                c.context.renderer(), complaints.text());
  return read();
}

RgbImage OffscreenView::read() {
  Buffers& c = *buffers_;
  c.context.makeCurrent();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, c.drawBuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, c.readBuffer);
  glBlitFramebuffer(0, 0, c.width, c.height, 0, 0, c.width, c.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, c.readBuffer);
  const std::size_t row = std::size_t(3) * c.width;
  std::vector<std::uint8_t> bottomUp(row * c.height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, c.width, c.height, GL_RGB, GL_UNSIGNED_BYTE, bottomUp.data());

  RgbImage image{c.width, c.height, std::vector<std::uint8_t>(bottomUp.size())};
  for (int y = 0; y < c.height; ++y)
    std::memcpy(&image.pixels[row * y], &bottomUp[row * (c.height - 1 - y)], row);
  return c.enlarged > 1 ? shrunk(image, c.enlarged) : image;
}

}  // namespace resect
