#include "inventor/offscreen_view.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/nodes/SoNode.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "base/error.h"
#include "inventor/init.h"

namespace resect {

namespace {

EGLDisplay openDisplay() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto has = [&](const char* name) { return extensions && std::strstr(extensions, name); };
  if (has("EGL_MESA_platform_surfaceless"))
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (has("EGL_EXT_platform_device")) {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (queryDevices && queryDevices(1, &device, &count) && count == 1)
      return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  }
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

// Keeps what Coin has to say about a shader while it is alive; passes on what else matters.
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
    // Coin asks GLX whether it draws directly, though EGL is in charge: means nothing.
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

constexpr const char* kAdvice =
    "pictures need OpenGL through EGL; install libegl1 and libgl1-mesa-dri";

}  // namespace

struct OffscreenView::Context {
  int width, height;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext egl = EGL_NO_CONTEXT;
  GLuint drawBuffer = 0, readBuffer = 0, renderBuffers[3] = {};
  std::uint32_t id = 0;
  std::unique_ptr<SoGLRenderAction> action;
  std::string renderer;

  Context(int w, int h) : width(w), height(h) {}

  void open(int samples) {
    display = openDisplay();
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
      throw error("cannot open an EGL display: {}", kAdvice);
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, wanted, &config, 1, &count))
      throw error("the EGL display has no OpenGL: {}", kAdvice);
    egl =
        eglCreateContext(display, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (egl == EGL_NO_CONTEXT) throw error("cannot make an OpenGL context: {}", kAdvice);
    makeCurrent();
    renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    makeBuffers(samples);

    id = SoGLCacheContextElement::getUniqueCacheContext();
    action = std::make_unique<SoGLRenderAction>(SbViewportRegion(short(width), short(height)));
    action->setCacheContext(id);
  }

  ~Context() {
    if (egl != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl)) {
      if (id) SoContextHandler::destructingContext(id);
      glDeleteFramebuffers(1, &drawBuffer);
      glDeleteFramebuffers(1, &readBuffer);
      glDeleteRenderbuffers(3, renderBuffers);
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    if (egl != EGL_NO_CONTEXT) eglDestroyContext(display, egl);
    // The display stays initialised: it is shared by all views of the process.
  }

  void makeCurrent() const {
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl))
      throw error("EGL cannot draw without a window: {}", kAdvice);
  }

  void makeBuffers(int samples) {
    GLint most = 1, largest = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (std::max(width, height) > largest)
      throw usageError("a picture of {} x {} pixels is too large for {}; stay below {}", width,
                       height, renderer, largest);
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
      throw error("{} refuses a framebuffer of {} x {} pixels; choose a smaller size", renderer,
                  width, height);
  }
};

OffscreenView::OffscreenView(int width, int height, int samples) {
  if (std::min(width, height) < 16 || std::max(width, height) > 8192)
    throw usageError("a picture of {} x {} pixels is refused; choose 16 to 8192 each way", width,
                     height);
  initInventor();
  context_ = std::make_unique<Context>(width, height);
  context_->open(samples);
}

OffscreenView::~OffscreenView() = default;

int OffscreenView::width() const { return context_->width; }
int OffscreenView::height() const { return context_->height; }
const char* OffscreenView::renderer() const { return context_->renderer.c_str(); }

RgbImage OffscreenView::render(SoNode* scene) {
  Context& c = *context_;
  c.makeCurrent();
  glBindFramebuffer(GL_FRAMEBUFFER, c.drawBuffer);
  glViewport(0, 0, c.width, c.height);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  const ShaderComplaints complaints;
  scene->ref();
  c.action->apply(scene);
  scene->unrefNoDelete();
  if (!complaints.text().empty())
    throw error("a shader of the scene does not work on {}: {}; please report this", c.renderer,
                complaints.text());
  return read();
}

void OffscreenView::makeCurrent() { context_->makeCurrent(); }

unsigned OffscreenView::framebuffer() const { return context_->drawBuffer; }

RgbImage OffscreenView::read() {
  Context& c = *context_;
  c.makeCurrent();
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
  return image;
}

}  // namespace resect
