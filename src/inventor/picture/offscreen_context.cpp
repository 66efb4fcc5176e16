#include "inventor/picture/offscreen_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <cstring>

#include "base/error.h"
#include "inventor/init.h"

namespace resect {
namespace {

constexpr const char* kAdvice =
    "pictures need OpenGL through EGL; install libegl1 and libgl1-mesa-dri";

bool contains(const char* extensions, const char* name) {
  return extensions && std::strstr(extensions, name);
}

template <typename Function>
Function extension(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

EGLDisplay initialised(EGLDisplay display) {
  const bool works = display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr);
  return works ? display : EGL_NO_DISPLAY;
}

// The first usable device that is not a software renderer.
EGLDisplay graphicsCard() {
  const auto devicesOf = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto told = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!devicesOf || !told || !devicesOf(16, devices, &count)) return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count; ++i) {
    if (contains(told(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) continue;
    const EGLDisplay display =
        initialised(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    if (display != EGL_NO_DISPLAY) return display;
  }
  return EGL_NO_DISPLAY;
}

EGLDisplay openDisplay() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  EGLDisplay display = EGL_NO_DISPLAY;
  if (contains(extensions, "EGL_EXT_platform_device")) display = graphicsCard();
  if (display == EGL_NO_DISPLAY && contains(extensions, "EGL_MESA_platform_surfaceless"))
    display = initialised(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
  return display != EGL_NO_DISPLAY ? display : initialised(eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

EGLContext makeContext(EGLDisplay display) {
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, wanted, &config, 1, &count))
    throw error("the EGL display has no OpenGL: {}", kAdvice);
  const EGLContext context =
      eglCreateContext(display, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
  if (context == EGL_NO_CONTEXT) throw error("cannot make an OpenGL context: {}", kAdvice);
  return context;
}

}  // namespace

OffscreenContext::OffscreenContext() {
  initInventor();
  // The display stays initialised: it is shared by all contexts of the process.
  static const EGLDisplay display = openDisplay();
  if (display == EGL_NO_DISPLAY) throw error("cannot open an EGL display: {}", kAdvice);
  display_ = display;
  egl_ = makeContext(display);
  if (!becomesCurrent()) {
    eglDestroyContext(display_, egl_);
    throw error("EGL cannot draw without a window: {}", kAdvice);
  }
  renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  id_ = SoGLCacheContextElement::getUniqueCacheContext();
}

OffscreenContext::~OffscreenContext() {
  if (becomesCurrent()) {
    SoContextHandler::destructingContext(id_);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display_, egl_);
}

void OffscreenContext::makeCurrent() const {
  if (!becomesCurrent()) throw error("EGL cannot draw without a window: {}", kAdvice);
}

bool OffscreenContext::becomesCurrent() const {
  return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, egl_);
}

bool OffscreenContext::processorDraws() const {
  return renderer_.find("llvmpipe") != std::string::npos ||
         renderer_.find("softpipe") != std::string::npos;
}

void beginPicture(std::uint32_t framebuffer, int width, int height) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
}

}  // namespace resect
